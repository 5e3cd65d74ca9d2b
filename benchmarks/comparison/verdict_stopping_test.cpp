// SPDX-License-Identifier: MIT
// How often the verdicts are right where measuring ends as it does in `compare`: by the width of
// the interval. Blocks are timed by measure_pair() itself, on machines whose noise is known. Bounds
// are those of verdict_simulation_test.cpp: a share of 400 repetitions keeps them with its interval
// of Clopper and Pearson.
#include <algorithm>
#include <cmath>
#include <vector>

#include <gtest/gtest.h>

#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/simulated_noise.hpp"
#include "core/statistics/signed_rank.hpp"

namespace phytobench {
namespace {

/// What the processes of both sides share: their place in the block, and what else the machine does
/// meanwhile, which slows all four alike.
struct Turns {
  UnitStream& stream;
  int processes = 0;
  double mood = 1.0;

  double next_mood() {
    if (processes++ % 4 == 0) mood = std::exp(0.3 * random_normal(stream));
    return mood;
  }
};

class NoisySide final : public TimedSide {
 public:
  NoisySide(const NoisyMachine& machine, double ratio, Turns& turns)
      : machine_(machine), ratio_(ratio), turns_(turns) {}

  std::vector<std::string> names() override { return {"b"}; }
  std::vector<VerifiedBenchmark> verify(const std::vector<std::string>&) override {
    return {{.name = "b", .inputs = "inputs", .answer = "answer"}};
  }
  std::vector<CalibratedBenchmark> calibrate(const std::vector<std::string>&, double) override {
    return {{.name = "b", .iterations = 1, .seconds = 1e-3}};
  }
  std::vector<SampledBenchmark> sample(const SamplePlan&) override {
    const double mood = turns_.next_mood();
    const double time_s = 1e-3 * ratio_ * mood * std::exp(log_noise(machine_, turns_.stream));
    return {{.name = "b", .samples = {{.iterations = 1, .cpu_s = time_s, .wall_s = time_s}}}};
  }

 private:
  const NoisyMachine& machine_;
  double ratio_;
  Turns& turns_;
};

struct StoppedExperiment {
  NoisyMachine machine;
  double ratio = 1.0;
  VerdictSettings verdicts = quick;
  std::uint64_t seed = 65;
};

/// What is concluded of one benchmark in each repetition, measured with all defaults of `compare`
/// but for the samples of a process, which its noise is that of.
std::vector<ConcludedBenchmark> repeated_until_narrow(const StoppedExperiment& experiment) {
  std::vector<ConcludedBenchmark> all;
  for (std::uint64_t repetition = 0; repetition < repetitions; ++repetition) {
    CounterStream stream(experiment.seed, repetition);
    Turns turns{.stream = stream};
    NoisySide base(experiment.machine, 1.0, turns);
    NoisySide other(experiment.machine, experiment.ratio, turns);
    const PairTiming timing = measure_pair({.base = &base,
                                            .other = &other,
                                            .names = {"b"},
                                            .settings = {.seed = repetition, .samples = 1},
                                            .clock_s = [] { return 0.0; }});
    all.push_back(conclude(timing.measured, experiment.verdicts).at(0));
  }
  return all;
}

/// The share that ended with fewer blocks than the most there may be.
Estimate share_stopped(const std::vector<ConcludedBenchmark>& all) {
  const auto most = static_cast<std::size_t>(TimingSettings{}.most_blocks);
  const auto count =
      std::count_if(all.begin(), all.end(), [&](const auto& each) { return each.blocks < most; });
  return share_estimate(count, repetitions);
}

TEST(VerdictStoppingSlow, CalmMachinesStopAtOnceAndLoudOnesGoOn) {
  const auto least = static_cast<std::size_t>(TimingSettings{}.least_blocks);
  for (const ConcludedBenchmark& each : repeated_until_narrow({.machine = {.noise = 0.001}}))
    EXPECT_EQ(each.blocks, least);
  const auto usual = repeated_until_narrow({.machine = {.noise = 0.03}});
  EXPECT_GT(share_stopped(usual).low, 0.9);
  EXPECT_TRUE(std::any_of(usual.begin(), usual.end(),
                          [&](const auto& each) { return each.blocks > 2 * least; }));
  EXPECT_LT(share_stopped(repeated_until_narrow({.machine = {.noise = 0.2}})).high, 0.1);
}

TEST(VerdictStoppingSlow, FalseAlarmsAreRarerThanOneInTwenty) {
  for (const NoiseLaw law : every_law)
    for (const double noise : {0.01, 0.03, 0.08}) {
      const auto all = repeated_until_narrow({.machine = {.law = law, .noise = noise}});
      EXPECT_LT(share_of_alarms(all).high, 0.05) << static_cast<int>(law) << " at " << noise;
    }
}

// Without tolerance and noise floor the test alone decides, and it must keep its 5 % where the
// number of blocks is chosen by what they show. No proof of more.
TEST(VerdictStoppingSlow, TheTestAloneKeepsItsLevel) {
  const VerdictSettings bare{.tolerance = 1e-6, .noise_factor = 0.0, .resamples = 1000};
  for (const double noise : {0.02, 0.03}) {
    const auto all = repeated_until_narrow({.machine = {.noise = noise}, .verdicts = bare});
    EXPECT_GT(share_of_alarms(all).value, 0.0) << "or nothing is tested here";
    EXPECT_LT(share_of_alarms(all).low, 0.05) << noise;
  }
}

// What must never be done, on the same kind of noise: to look at p after every block, and stop
// where it is small.
TEST(VerdictStoppingSlow, StoppingBySmallPAlarmsMoreOftenThanThat) {
  const TimingSettings usual;
  int alarms = 0;
  for (std::uint64_t repetition = 0; repetition < repetitions; ++repetition) {
    CounterStream stream(66, repetition);
    std::vector<double> log_ratios;
    bool is_alarm = false;
    while (!is_alarm && log_ratios.size() < static_cast<std::size_t>(usual.most_blocks)) {
      log_ratios.push_back(0.03 * random_normal(stream));
      is_alarm = log_ratios.size() >= static_cast<std::size_t>(usual.least_blocks) &&
                 signed_rank_test(log_ratios).p_two_sided < quick.alpha;
    }
    alarms += is_alarm;
  }
  EXPECT_GT(share_estimate(alarms, repetitions).low, 0.1);
}

TEST(VerdictStoppingSlow, ATenthIsFound) {
  for (const NoiseLaw law : every_law) {
    const NoisyMachine machine{.law = law, .noise = 0.03};
    const auto slower = repeated_until_narrow({.machine = machine, .ratio = 1.1});
    EXPECT_GT(share_of(SpeedVerdict::slower, slower).low, 0.9) << static_cast<int>(law);
    EXPECT_LT(share_of(SpeedVerdict::same, slower).high, 0.05) << static_cast<int>(law);
    EXPECT_LT(share_of(SpeedVerdict::faster, slower).high, 0.05) << static_cast<int>(law);
  }
  const auto faster = repeated_until_narrow({.machine = {.noise = 0.03}, .ratio = 1.0 / 1.1});
  EXPECT_GT(share_of(SpeedVerdict::faster, faster).low, 0.9);
}

// A narrow interval lies within the tolerance unless its middle is off by half of that, and so must
// the control's.
TEST(VerdictStoppingSlow, NoChangeIsMostlyCalledTheSame) {
  const auto calm = repeated_until_narrow({.machine = {.noise = 0.01}});
  EXPECT_GT(share_of(SpeedVerdict::same, calm).low, 0.9);
  const auto usual = repeated_until_narrow({.machine = {.noise = 0.03}});
  EXPECT_GT(share_of(SpeedVerdict::same, usual).low, 0.85);
}

}  // namespace
}  // namespace phytobench
