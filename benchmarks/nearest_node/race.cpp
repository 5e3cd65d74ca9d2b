// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <set>

#include <fmt/format.h>

#include "benchmarks/nearest_node/growth_trace.hpp"
#include "benchmarks/nearest_node/remembering_judge.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

double seconds_of(const std::function<void()>& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Expects the time of a growth from growths of smaller trees, which are checked as all others.
class Predictor {
 public:
  Predictor(double points, double density, double budget_s)
      : points_(points), density_(density), budget_s_(budget_s) {}

  /// Seconds, or 0 if it is certain to be far below the budget.
  double predict(const EngineDescriptor& engine, const GrowthRun& run) {
    double size = 0.0, seconds = 0.0, exponent = 2.0, predicted = 0.0;
    bool is_fitted = false;  // or else the exponent is a guess, which nothing is skipped for
    for (const double pilot : {2000.0, 8000.0, 32000.0}) {
      if (pilot > 0.5 * points_) break;
      const double cheap = 0.02 * budget_s_;
      if (size > 0.0 && ((is_fitted && predicted > 20.0 * budget_s_) ||
                         seconds * std::pow(pilot / size, exponent) > std::max(cheap, 1.0)))
        break;
      const double now = timed_pilot(pilot, engine, run);
      if (now < 0.0) return 0.0;  // inexact: the check will say so
      is_fitted = size > 0.0 && seconds > 0.0;
      if (is_fitted)
        exponent = std::clamp(std::log(now / seconds) / std::log(pilot / size), 1.0, 2.5);
      size = pilot;
      seconds = now;
      predicted = seconds * std::pow(points_ / size, exponent);
      if (predicted < cheap) break;
    }
    return predicted;
  }

 private:
  struct Pilot {
    Workload workload;
    GrowthOracle oracle;
    explicit Pilot(Workload w) : workload(std::move(w)), oracle(workload.seedling) {}
  };

  double timed_pilot(double points, const EngineDescriptor& engine, const GrowthRun& run) {
    auto& pilot = pilots_[points];
    if (!pilot)
      pilot = std::make_unique<Pilot>(scaled_test_tree({.points = points, .density = density_}));
    const CheckedGrowth checked =
        grow_checked(engine, pilot->workload.seedling, pilot->oracle, run);
    return checked.verified ? fastest_growth(*checked.verified) : -1.0;
  }

  /// Small growths again and again: threads that wake up for the first time, or one hiccup, would
  /// be taken for a steep exponent.
  static double fastest_growth(const VerifiedRun& run) {
    constexpr int most_growths = 5;
    constexpr double enough_s = 0.2;
    double fastest = std::numeric_limits<double>::infinity(), spent = 0.0;
    for (int growth = 0; growth < most_growths && spent < enough_s; ++growth) {
      const double seconds = run.grow().seconds.total;
      fastest = std::min(fastest, seconds);
      spent += seconds;
    }
    return fastest;
  }

  double points_;
  double density_;
  double budget_s_;
  std::map<double, std::unique_ptr<Pilot>> pilots_;
};

/// Says how long another judge takes: time that is no engine's.
class TimedJudge final : public GrowthJudge {
 public:
  explicit TimedJudge(GrowthJudge& judge) : judge_(judge) {}

  double seconds() const { return seconds_; }

  void restart() override {
    seconds_ += seconds_of([&] { judge_.restart(); });
  }
  std::span<const int> associate(std::span<const SearchableNode> new_nodes) override {
    std::span<const int> answer;
    seconds_ += seconds_of([&] { answer = judge_.associate(new_nodes); });
    return answer;
  }
  std::vector<int> remove(std::span<const SearchableNode> killers, double distance,
                          bool& expected) override {
    std::vector<int> answer;
    seconds_ += seconds_of([&] { answer = judge_.remove(killers, distance, expected); });
    return answer;
  }
  std::string tree_hash() const override { return judge_.tree_hash(); }
  std::string name() const override { return judge_.name(); }

 private:
  GrowthJudge& judge_;
  double seconds_ = 0.0;
};

/// What was checked in less than this is grown once more, untimed, before each growth that is
/// timed.
constexpr double worth_a_warm_up_s = 0.25;

constexpr int most_rounds = 25;

class Race {
 public:
  explicit Race(const RaceRequest& request)
      : request_(request),
        seedling_(request.workload->seedling),
        points_(static_cast<double>(seedling_.attraction_points.size())) {}

  RaceResult run() {
    PHYTOBENCH_EXPECT(request_.least_rounds >= 1 && request_.least_rounds <= most_rounds);
    list_entries();
    predict();
    make_judge();
    check();
    measure_memory();
    time();
    return std::move(result_);
  }

 private:
  using State = RaceEntry::State;

  void list_entries() {
    for (const Contestant& contestant : request_.contestants)
      static_cast<Contestant&>(result_.entries.emplace_back()) = contestant;
  }

  GrowthRun run_of(const RaceEntry& entry) const {
    return {.options = loop_options_named(entry.option), .threads = entry.threads};
  }

  void progress(const std::string& what) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted();
    if (request_.show_progress) request_.show_progress(what);
  }

  /// Shows iterations of a long growth and lets Ctrl-C through.
  GrowthRun observed(GrowthRun run, const std::string& what) const {
    run.observer = [this, what](const PassStatistics& pass) {
      progress(fmt::format("{}: iteration {}, {} live points", what, pass.iteration + 1,
                           pass.live_points));
      return true;
    };
    return run;
  }

  void predict() {
    Predictor predictor(points_, request_.workload->density, request_.budget_s);
    for (RaceEntry& entry : result_.entries) {
      if (!entry.engine->built()) continue;
      progress("predicting " + entry.name());
      if (std::isfinite(request_.budget_s))
        entry.predicted_s = predictor.predict(*entry.engine, run_of(entry));
      entry.state = entry.predicted_s > request_.budget_s ? State::skipped : State::inexact;
    }
  }

  void make_judge() {
    progress("growing the judge's tree");
    if (seedling_.attraction_points.size() <= GrowthOracle::most_points) {
      oracle_ = std::make_unique<GrowthOracle>(seedling_);
      judge_ = make_literal_judge(*oracle_);
    } else {
      judge_ = make_grid_judge(seedling_, request_.order_seed);
      if (result_.entries.size() > 1) judge_ = make_remembering_judge(std::move(judge_));
    }
    result_.judge = judge_->name();
  }

  void check() {
    for (RaceEntry& entry : result_.entries) {
      if (entry.state != State::inexact) continue;
      CheckedGrowth checked;
      TimedJudge judge(*judge_);
      const double seconds = seconds_of([&] {
        checked = grow_checked(*entry.engine, seedling_, judge,
                               observed(run_of(entry), "checking " + entry.name()));
      });
      check_seconds_[&entry] = seconds - judge.seconds();
      entry.disagreement = checked.disagreement;
      if (!checked.verified) continue;
      if (!accept_tree(*checked.verified, entry)) continue;
      entry.state = State::timed;
      entry.work = checked.result.work;
      result_.nodes = checked.result.skeleton.node_count();
      result_.iterations = checked.result.passes.size();
      verified_.emplace(&entry, *checked.verified);
    }
    progress("counting pairs");
    result_.floor = count_pairs(seedling_, {});
  }

  /// Where the judge does not know the tree, the first one that agreed in every answer is it.
  bool accept_tree(const VerifiedRun& verified, RaceEntry& entry) {
    entry.tree_hash = verified.hash();
    if (tree_hash_.empty()) tree_hash_ = entry.tree_hash;
    if (entry.tree_hash == tree_hash_) return true;
    entry.disagreement = "every assignment agrees, but the tree is another";
    return false;
  }

  /// By replaying one growth, so that only the engine allocates.
  void measure_memory() {
    const auto trusted =
        std::find_if(result_.entries.begin(), result_.entries.end(),
                     [](const RaceEntry& entry) { return entry.state == State::timed; });
    if (!(request_.replay_s > 0.0) || trusted == result_.entries.end()) return;
    progress("recording a trace");
    const GrowthTrace trace = record_trace(*trusted->engine, seedling_, run_of(*trusted));
    std::map<std::string_view, double> bytes;
    for (RaceEntry& entry : result_.entries) {
      if (entry.state != State::timed || check_seconds_.at(&entry) > request_.replay_s) continue;
      if (!bytes.contains(entry.engine->name)) {
        progress("memory of " + std::string(entry.engine->name));
        bytes[entry.engine->name] =
            replay(trace, *entry.engine, seedling_.attraction_points, entry.threads).bytes;
      }
      if (points_ > 0.0) entry.bytes_per_point = bytes[entry.engine->name] / points_;
    }
  }

  void time() {
    if (!request_.measure_time) return;
    std::vector<RaceEntry*> timed;
    for (RaceEntry& entry : result_.entries)
      if (entry.state == State::timed) timed.push_back(&entry);
    int rounds = request_.rounds;
    for (int round = 0; rounds == 0 || round < rounds; ++round) {
      const double seconds = seconds_of([&] { time_round(round, rounds, timed); });
      if (rounds == 0)
        rounds = std::clamp(static_cast<int>(request_.timing_s / std::max(seconds, 1e-9)),
                            request_.least_rounds, most_rounds);
    }
  }

  void time_round(int round, int rounds, const std::vector<RaceEntry*>& timed) {
    CounterStream stream(request_.order_seed, static_cast<std::uint64_t>(round));
    for (const std::size_t i : random_order(timed.size(), stream)) {
      progress(fmt::format("round {}{}: timing {}", round + 1,
                           rounds > 0 ? fmt::format(" of {}", rounds) : "", timed[i]->name()));
      const VerifiedRun& run = verified_.at(timed[i]);
      // Caches and free memory are as the contestant before has left them: a short growth would
      // mostly measure that.
      if (check_seconds_.at(timed[i]) < worth_a_warm_up_s) run.grow();
      timed[i]->rounds.push_back(run.grow().seconds);
    }
  }

  const RaceRequest& request_;
  const Seedling& seedling_;
  double points_;
  RaceResult result_;
  std::unique_ptr<GrowthOracle> oracle_;
  std::unique_ptr<GrowthJudge> judge_;
  std::string tree_hash_;
  std::map<const RaceEntry*, VerifiedRun> verified_;
  std::map<const RaceEntry*, double> check_seconds_;
};

}  // namespace

std::string Contestant::name() const {
  std::string name = std::string(engine->name) + " " + option;
  if (threads > 1) name += fmt::format(", {} threads", threads);
  return name;
}

std::vector<Contestant> combinations(const std::vector<const EngineDescriptor*>& engines,
                                     const std::vector<std::string>& options,
                                     const std::vector<int>& threads) {
  std::vector<Contestant> all;
  for (const EngineDescriptor* engine : engines)
    for (const std::string& option : options)
      for (const int count : threads) all.push_back({engine, option, count});
  return all;
}

RaceResult race(const RaceRequest& request) {
  return Race(request).run();
}

std::vector<double> samples(const RaceEntry& entry, double PhaseSeconds::*phase) {
  std::vector<double> seconds;
  for (const PhaseSeconds& round : entry.rounds) seconds.push_back(round.*phase);
  return seconds;
}

double reset_seconds(const PhaseSeconds& seconds) {
  return seconds.total - seconds.association - seconds.kill - seconds.growth;
}

}  // namespace phytobench
