// SPDX-License-Identifier: MIT
#include "benchmarks/regression/selftest_benchmarks.hpp"

#include <limits>
#include <span>

#include <fmt/format.h>

#include "benchmarks/faulty_engines/faulty_scan.hpp"
#include "benchmarks/nearest_node/awkward_seedlings.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/growth_kernel.hpp"

namespace phytobench {

namespace {

// x -> a x + c modulo 2^64 (Knuth, The Art of Computer Programming 2, sec. 3.3.4: MMIX).
constexpr std::uint64_t multiplier = 6364136223846793005;
constexpr std::uint64_t increment = 1442695040888963407;
constexpr std::uint64_t first_state = 8;

/// One after the other: no step can begin before the last has ended.
std::uint64_t chained(std::uint64_t steps) {
  std::uint64_t x = first_state;
  for (std::uint64_t k = 0; k < steps; ++k) x = multiplier * x + increment;
  return x;
}

/// The same in 64 steps: (a, c) become those of 2, 4, 8, ... steps at once.
std::uint64_t jumped(std::uint64_t steps) {
  std::uint64_t x = first_state, a = multiplier, c = increment;
  for (; steps != 0; steps >>= 1) {
    if ((steps & 1) != 0) x = a * x + c;
    c = a * c + c;
    a = a * a;
  }
  return x;
}

/// A multiplication and an addition take some four cycles: about 0.2 ms.
constexpr std::uint64_t steps_of_a_run = 150'000;
constexpr std::uint64_t for_ever = std::numeric_limits<std::uint64_t>::max();

/// Does half of its work after so many runs.
class ChainKernel final : public WatchedKernel {
 public:
  explicit ChainKernel(std::uint64_t honest_runs) : honest_runs_(honest_runs) {}

  std::string inputs() const override {
    const std::uint64_t numbers[] = {multiplier, increment, first_state, steps_of_a_run};
    return KernelDigest().add(numbers).hex();
  }
  void run() override {
    done_ = runs_++ < honest_runs_ ? steps_of_a_run : steps_of_a_run / 2;
    state_ = chained(done_);
  }
  std::string answer() const override { return KernelDigest().add(std::span(&state_, 1)).hex(); }
  WorkCounts work() const override { return {{"steps", done_}}; }
  std::string objection() override {
    const std::uint64_t expected = jumped(steps_of_a_run);
    if (state_ == expected) return {};
    return fmt::format("{} after {} steps instead of {}", state_, done_, expected);
  }

 private:
  std::uint64_t honest_runs_;
  std::uint64_t runs_ = 0, done_ = 0, state_ = first_state;
};

/// Works until its answer was looked at, which a process that only calibrates never does.
class StoppingKernel final : public WatchedKernel {
 public:
  std::string inputs() const override { return chain_.inputs(); }
  void run() override {
    if (!was_looked_at_) chain_.run();
  }
  std::string answer() const override {
    was_looked_at_ = true;
    return chain_.answer();
  }
  WorkCounts work() const override { return chain_.work(); }
  std::string objection() override { return chain_.objection(); }

 private:
  ChainKernel chain_{for_ever};
  mutable bool was_looked_at_ = false;
};

class EmptyKernel final : public WatchedKernel {
 public:
  std::string inputs() const override { return sha256_hex("nothing"); }
  void run() override {}
  std::string answer() const override { return sha256_hex("nothing"); }
  WorkCounts work() const override { return {}; }
  std::string objection() override { return {}; }
};

struct TakesTheLaterOfEquals : NoMistake {
  static bool wins(double candidate, double best) { return candidate <= best; }
};

constinit const EngineDescriptor breaks_ties_upwards{
    .name = "breaks_ties_upwards",
    .summary = "Wrong on purpose: of equally near nodes it takes the highest index.",
    .source = "a <= where a < belongs",
    .create = make_point_driven_engine<FaultyScan<TakesTheLaterOfEquals>>,
};

constexpr std::uint64_t honest_runs = 3;  ///< enough to be verified

/// Steps and points share one lattice, so that ties are everywhere.
Seedling tied_seedling() {
  return with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10));
}

}  // namespace

std::vector<WatchedBenchmark> selftest_benchmarks() {
  return {
      {.name = "selftest/steady",
       .summary = "Fixed arithmetic, step after step.",
       .is_own = true,
       .prepare = [] { return std::make_unique<ChainKernel>(for_ever); }},
      growth_benchmark({.name = "selftest/wrong-answer",
                        .summary = "Wrong on purpose: a growth with ties given to the wrong node.",
                        .engine = &breaks_ties_upwards,
                        .subject = std::make_shared<GrowthSubject>(tied_seedling)}),
      {.name = "selftest/measures-nothing",
       .summary = "Wrong on purpose: a run does nothing.",
       .is_own = true,
       .prepare = [] { return std::make_unique<EmptyKernel>(); }},
      {.name = "selftest/forgets-work",
       .summary = "Wrong on purpose: after a few runs it does half of its work.",
       .is_own = true,
       .prepare = [] { return std::make_unique<ChainKernel>(honest_runs); }},
      {.name = "selftest/stops-working",
       .summary = "Wrong on purpose: once its answer was looked at, a run does nothing.",
       .is_own = true,
       .prepare = [] { return std::make_unique<StoppingKernel>(); }},
  };
}

}  // namespace phytobench
