// SPDX-License-Identifier: MIT
#include "benchmarks/shadow/shadow_race.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "benchmarks/resident_memory.hpp"
#include "benchmarks/shadow/shadow_judge.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

template <class Work>
double seconds_for(const Work& work) {
  const auto start = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

double fastest_cast(const ShadowContestant& contestant, const ShadowWorkload& workload) {
  const auto engine = contestant.engine->create();
  LitMaps lit;
  double fastest = std::numeric_limits<double>::infinity();
  for (int k = 0; k < 2; ++k)
    fastest = std::min(fastest, seconds_for([&] {
                         engine->cast(workload.field, workload.suns,
                                      {.threads = contestant.threads}, lit);
                       }));
  return fastest;
}

/// Seconds, from two corners of the terrain; 0 if there is no need to know.
double predicted_cast(const ShadowContestant& contestant, const ShadowWorkload& workload) {
  constexpr int small = 128, large = 256;
  if (workload.field.columns() <= 2 * large || workload.field.rows() <= 2 * large) return 0.0;
  const double t1 = fastest_cast(contestant, corner_of(workload, small));
  const double t2 = fastest_cast(contestant, corner_of(workload, large));
  // The time of a vertex grows with the map's side at most.
  const double exponent = std::clamp(std::log2(t2 / t1), 2.0, 3.0);
  const double vertices = static_cast<double>(workload.field.size());
  return t2 * std::pow(vertices / (large * large), exponent / 2.0);
}

class ShadowRace {
 public:
  explicit ShadowRace(const ShadowRaceRequest& request)
      : request_(request), workload_(*request.workload) {}

  ShadowRaceResult run() {
    for (const ShadowContestant& contestant : request_.contestants)
      static_cast<ShadowContestant&>(result_.entries.emplace_back()) = contestant;
    predict();
    check_all();
    time_in_turns();
    return std::move(result_);
  }

 private:
  using State = ShadowEntry::State;

  void progress(const std::string& what) const {
    if (request_.is_interrupted && request_.is_interrupted()) throw Interrupted();
    if (request_.show_progress) request_.show_progress(what);
  }

  void predict() {
    for (ShadowEntry& entry : result_.entries) {
      if (!entry.engine->built()) continue;
      progress("predicting " + entry.name());
      entry.predicted_s = predicted_cast(entry, workload_);
      entry.state = entry.predicted_s > request_.budget_s ? State::skipped : State::wrong;
    }
  }

  int most_threads() const {
    int most = 1;
    for (const ShadowEntry& entry : result_.entries) most = std::max(most, entry.threads);
    return most;
  }

  void check_all() {
    progress("asking the judge");
    const ShadowJudge judge(workload_, request_.order_seed, most_threads());
    result_.judge = judge.name();
    result_.lit = judge.lit().lit();
    for (ShadowEntry& entry : result_.entries)
      if (entry.state == State::wrong) check(entry, judge);
  }

  /// An engine that has just been made, once: its answer, and what memory it asks for.
  void check(ShadowEntry& entry, const ShadowJudge& judge) const {
    progress("checking " + entry.name());
    const bool is_measured = reset_peak_memory();
    const auto before = resident_bytes();
    LitMaps lit;
    entry.work = entry.engine->create()->cast(workload_.field, workload_.suns,
                                              {.threads = entry.threads}, lit);
    const auto peak = peak_resident_bytes();
    if (is_measured && before && peak) entry.bytes = *peak - *before;
    entry.disagreement = judge.disagreement(lit);
    if (!entry.disagreement.empty() && entry.engine->exact) return;
    entry.wrong_share = judge.wrong_share(lit);
    entry.state = State::timed;
  }

  void time_in_turns() {
    std::vector<ShadowEntry*> timed;
    for (ShadowEntry& entry : result_.entries)
      if (entry.state == State::timed) timed.push_back(&entry);
    int rounds = request_.rounds;
    for (int round = 0; !timed.empty() && (rounds == 0 || round < rounds); ++round) {
      const double seconds = seconds_for([&] { time_round(round, timed); });
      if (rounds == 0)
        rounds = std::clamp(static_cast<int>(request_.timing_s / std::max(seconds, 1e-9)), 3, 25);
    }
  }

  void time_round(int round, const std::vector<ShadowEntry*>& timed) {
    CounterStream stream(request_.order_seed, static_cast<std::uint64_t>(round));
    for (const std::size_t i : random_order(timed.size(), stream)) {
      progress(fmt::format("round {}: timing {}", round + 1, timed[i]->name()));
      const auto engine = timed[i]->engine->create();
      timed[i]->seconds.push_back(seconds_for([&] {
        engine->cast(workload_.field, workload_.suns, {.threads = timed[i]->threads}, lit_);
      }));
    }
  }

  const ShadowRaceRequest& request_;
  const ShadowWorkload& workload_;
  ShadowRaceResult result_;
  LitMaps lit_;
};

}  // namespace

std::string ShadowContestant::name() const {
  return threads > 1 ? fmt::format("{}, {} threads", engine->name, threads)
                     : std::string(engine->name);
}

ShadowRaceResult race_shadows(const ShadowRaceRequest& request) {
  return ShadowRace(request).run();
}

}  // namespace phytobench
