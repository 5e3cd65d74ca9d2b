// SPDX-License-Identifier: MIT
#include "benchmarks/overlap/overlap_race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <map>
#include <memory>

#include <fmt/format.h>

#include "benchmarks/overlap/overlap_judge.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/overlap/lens.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench {

namespace {

template <class Work>
double seconds_of(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The fastest of a few searches: the first has to ask for its memory.
double fastest_search(const OverlapEngineDescriptor& engine, const OverlapWorkload& workload,
                      const OverlapSetup& setup) {
  const auto made = engine.create();
  OverlapPairs pairs;
  double fastest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 3; ++k)
    fastest = std::min(
        fastest, seconds_of([&] { made->find(workload.discs(), workload.ground, setup, pairs); }));
  return fastest;
}

/// Seconds, from two smaller scenes of the same kind; 0 if there is no need to know.
double predicted_seconds(const OverlapEngineDescriptor& engine, const OverlapWorkload& workload,
                         const OverlapSetup& setup) {
  constexpr std::size_t small = 3'000, large = 12'000;
  if (workload.x.size() < 2 * large) return 0.0;
  const OverlapWorkload first = smaller(workload, small), second = smaller(workload, large);
  const double n1 = static_cast<double>(first.x.size()), n2 = static_cast<double>(second.x.size());
  if (n1 < 1.0 || n2 < 1.5 * n1) return 0.0;
  const double t1 = fastest_search(engine, first, setup),
               t2 = fastest_search(engine, second, setup);
  const double exponent = std::clamp(std::log(t2 / t1) / std::log(n2 / n1), 1.0, 2.5);
  return t2 * std::pow(static_cast<double>(workload.x.size()) / n2, exponent);
}

/// Areas of the judge's pairs in three ways, none of which has to search.
class LensRace {
 public:
  LensRace(const OverlapJudge& judge, const OverlapWorkload& workload) {
    // As an engine has them in its cache; again and again, so that a clock can tell. Where sizes
    // are worlds apart the textbook's form has no digits left, and no answer to be timed.
    constexpr std::size_t most = 8'000, areas = 400'000;
    constexpr double worlds_apart = 1000.0;
    for (std::size_t p = 0; p < judge.pairs().size() && r_.size() < most; ++p) {
      const double a = workload.radius[static_cast<std::size_t>(judge.pairs().first()[p])];
      const double b = workload.radius[static_cast<std::size_t>(judge.pairs().second()[p])];
      if (std::max(a, b) > worlds_apart * std::min(a, b)) continue;
      r_.push_back(std::min(a, b));
      s_.push_back(std::max(a, b));
      d_.push_back(judge.distances()[p]);
    }
    area_.resize(r_.size());
    if (!r_.empty()) repetitions_ = areas / r_.size();
  }

  std::size_t size() const { return area_.size(); }
  std::size_t repetitions() const { return repetitions_; }

  void textbook() {
    for (std::size_t p = 0; p < size(); ++p)
      area_[p] = oracles::alsweis::equation_a4_corrected(r_[p], s_[p], d_[p]);
  }
  void scalar() {
    for (std::size_t p = 0; p < size(); ++p) area_[p] = lens_area(r_[p], s_[p], d_[p]);
  }
  void vector() { lens_areas(r_, s_, d_, area_); }

  /// No time for a wrong answer: the same bits for ours, half the digits for the textbook's, which
  /// loses the others where circles nearly touch.
  void check() {
    scalar();
    const std::vector<double> ours = area_;
    vector();
    PHYTOBENCH_ENSURE(area_ == ours);
    textbook();
    std::size_t off = 0;
    for (std::size_t p = 0; p < size(); ++p)
      off += !(std::abs(area_[p] - ours[p]) <= 1e-8 * r_[p] * r_[p] + 1e-12 * s_[p] * s_[p]);
    PHYTOBENCH_ENSURE(off == 0);
  }

 private:
  std::vector<double> r_, s_, d_, area_;
  std::size_t repetitions_ = 1;
};

class Race {
 public:
  explicit Race(const OverlapRaceRequest& request)
      : request_(request), workload_(*request.workload) {}

  OverlapRaceResult run() {
    for (const OverlapContestant& contestant : request_.contestants)
      static_cast<OverlapContestant&>(result_.entries.emplace_back()) = contestant;
    predict();
    progress("asking the oracle");
    judge_ = std::make_unique<OverlapJudge>(workload_, request_.order_seed);
    result_.judge = judge_->name();
    result_.pairs = judge_->pairs().size();
    constexpr std::size_t sample = 500;
    result_.largest_area_error = judge_->largest_area_error(sample);
    check();
    time();
    time_lens();
    return std::move(result_);
  }

 private:
  using State = OverlapEntry::State;

  void progress(const std::string& what) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted();
    if (request_.show_progress) request_.show_progress(what);
  }

  /// The judge counts pairs; an engine that finds far more is wrong, not out of memory.
  OverlapSetup setup_of(const OverlapEntry& entry) const { return {.threads = entry.threads}; }

  void predict() {
    for (OverlapEntry& entry : result_.entries) {
      if (!entry.engine->built()) continue;
      progress("predicting " + entry.name());
      entry.predicted_s = predicted_seconds(*entry.engine, workload_, setup_of(entry));
      entry.state = entry.predicted_s > request_.budget_s ? State::skipped : State::inexact;
    }
  }

  double search(OverlapEntry& entry) {
    auto& engine = engines_[&entry];
    if (!engine) engine = entry.engine->create();
    return seconds_of([&] {
      entry.work = engine->find(workload_.discs(), workload_.ground, setup_of(entry), pairs_);
    });
  }

  void check() {
    for (OverlapEntry& entry : result_.entries) {
      if (entry.state != State::inexact) continue;
      progress("checking " + entry.name());
      search(entry);
      entry.disagreement = judge_->disagreement(pairs_);
      if (entry.disagreement.empty()) entry.state = State::timed;
    }
  }

  void time() {
    std::vector<OverlapEntry*> timed;
    for (OverlapEntry& entry : result_.entries)
      if (entry.state == State::timed) timed.push_back(&entry);
    int rounds = request_.rounds;
    for (int round = 0; !timed.empty() && (rounds == 0 || round < rounds); ++round) {
      const double seconds = seconds_of([&] {
        CounterStream stream(request_.order_seed, static_cast<std::uint64_t>(round));
        for (const std::size_t i : random_order(timed.size(), stream)) {
          progress(fmt::format("round {}: timing {}", round + 1, timed[i]->name()));
          timed[i]->seconds.push_back(search(*timed[i]));
        }
      });
      if (rounds == 0)
        rounds = std::clamp(static_cast<int>(request_.timing_s / std::max(seconds, 1e-9)), 3, 25);
    }
  }

  void time_lens() {
    LensRace lens(*judge_, workload_);
    if (lens.size() == 0) return;
    progress("timing lens areas");
    lens.check();
    result_.lens = {{"textbook", {}}, {"scalar", {}}, {"vector", {}}};
    const std::function<void()> ways[] = {[&] { lens.textbook(); }, [&] { lens.scalar(); },
                                          [&] { lens.vector(); }};
    constexpr int rounds = 25;
    for (int round = 0; round < rounds; ++round) {
      CounterStream stream(request_.order_seed, 1000 + static_cast<std::uint64_t>(round));
      for (const std::size_t w : random_order(std::size(ways), stream))
        result_.lens[w].seconds.push_back(seconds_of([&] {
          for (std::size_t k = 0; k < lens.repetitions(); ++k) ways[w]();
        }));
    }
  }

  const OverlapRaceRequest& request_;
  const OverlapWorkload& workload_;
  OverlapRaceResult result_;
  std::unique_ptr<OverlapJudge> judge_;
  std::map<const OverlapEntry*, std::unique_ptr<OverlapEngine>> engines_;
  OverlapPairs pairs_;
};

}  // namespace

std::string OverlapContestant::name() const {
  return threads > 1 ? fmt::format("{}, {} threads", engine->name, threads)
                     : std::string(engine->name);
}

OverlapRaceResult race_overlap(const OverlapRaceRequest& request) {
  return Race(request).run();
}

}  // namespace phytobench
