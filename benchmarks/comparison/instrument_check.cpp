// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instrument_check.hpp"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/steady_seconds.hpp"
#include "benchmarks/comparison/timed_block.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

constexpr const char* steady = "selftest/steady";
constexpr std::uint64_t stream_of_comparisons = 4;  // 0 to 3 are those of blocks

void count(VerdictTally& tally, SpeedVerdict verdict) {
  switch (verdict) {
    case SpeedVerdict::slower:
      ++tally.slower;
      return;
    case SpeedVerdict::faster:
      ++tally.faster;
      return;
    case SpeedVerdict::same:
      ++tally.same;
      return;
    case SpeedVerdict::inconclusive:
      ++tally.inconclusive;
      return;
    case SpeedVerdict::same_binary:
    case SpeedVerdict::nothing_measured:
    case SpeedVerdict::wrong_answer:
      ++tally.other;
      return;
  }
}

/// What one comparison of several benchmarks comes to: what must never be before what may.
SpeedVerdict worst_of(const std::vector<ConcludedBenchmark>& concluded) {
  using enum SpeedVerdict;
  for (const SpeedVerdict verdict :
       {wrong_answer, nothing_measured, same_binary, slower, faster, inconclusive})
    if (std::any_of(concluded.begin(), concluded.end(), [&](const ConcludedBenchmark& benchmark) {
          return benchmark.verdict == verdict;
        }))
      return verdict;
  return same;
}

enum class ComparisonKind { alike, usual, handicapped };

/// So many of each kind, mixed evenly: if time runs out, it does for all.
std::vector<ComparisonKind> mixed(const InstrumentRequest& request) {
  std::vector<std::pair<double, ComparisonKind>> places;
  const auto add = [&](ComparisonKind kind, int count) {
    for (int i = 0; i < count; ++i) places.emplace_back((i + 0.5) / count, kind);
  };
  add(ComparisonKind::alike, request.repetitions);
  add(ComparisonKind::usual, request.usual_repetitions);
  add(ComparisonKind::handicapped, request.slow_repetitions);
  std::sort(places.begin(), places.end());
  std::vector<ComparisonKind> kinds;
  for (const auto& [place, kind] : places) kinds.push_back(kind);
  return kinds;
}

struct BrokenBenchmark {
  const char* name;
  const char* demanded;
  SpeedVerdict verdict;
};

constexpr BrokenBenchmark broken_benchmarks[] = {
    {"selftest/wrong-answer", "refused before it is timed", SpeedVerdict::wrong_answer},
    {"selftest/forgets-work", "refused while it is timed", SpeedVerdict::wrong_answer},
    {"selftest/stops-working", "refused while it is timed", SpeedVerdict::wrong_answer},
    {"selftest/measures-nothing", "no verdict on speed", SpeedVerdict::nothing_measured}};

class InstrumentChecker {
 public:
  explicit InstrumentChecker(const InstrumentRequest& request) : request_(request) {
    PHYTOBENCH_EXPECT(request.side && request.repetitions >= 1 && request.slow_repetitions >= 1);
    PHYTOBENCH_EXPECT(request.handicap > 0.0);
    PHYTOBENCH_EXPECT(request.usual_repetitions >= 0);
    PHYTOBENCH_EXPECT(request.usual_repetitions == 0 || !request.usual_names.empty());
  }

  InstrumentCheck check() {
    const double start_s = now_s();
    base_ = request_.side(0.0);
    alike_ = request_.side(0.0);
    handicapped_ = request_.side(request_.handicap);
    result_.wanted_alike = request_.repetitions;
    result_.wanted_usual = request_.usual_repetitions;
    result_.wanted_handicapped = request_.slow_repetitions;
    result_.usual_names = request_.usual_names;
    result_.handicap = request_.handicap;
    for (const BrokenBenchmark& broken : broken_benchmarks)
      result_.refusals.push_back(tried(broken));
    compare_all(start_s);
    if (!noise_floors_.empty()) result_.noise_floor = median(noise_floors_);
    if (!found_ratios_.empty()) result_.found_handicap = median(found_ratios_) - 1.0;
    result_.seconds = now_s() - start_s;
    return std::move(result_);
  }

 private:
  double now_s() const { return request_.clock_s ? request_.clock_s() : steady_seconds(); }

  PairTiming measured(TimedSide& other, const std::vector<std::string>& names,
                      TimingSettings settings) {
    settings.seed = drawn_seed(request_.seed, stream_of_comparisons, next_++);
    PairTiming timing = measure_pair({.base = base_.get(),
                                      .other = &other,
                                      .names = names,
                                      .settings = settings,
                                      .is_interrupted = request_.is_interrupted,
                                      .stolen_share = request_.stolen_share,
                                      .clock_s = request_.clock_s});
    if (timing.was_interrupted) throw Interrupted("the instrument was not judged");
    return timing;
  }

  RefusalCheck tried(const BrokenBenchmark& broken) {
    show(fmt::format("{}: it must be refused", broken.name));
    const PairTiming timing = measured(*alike_, {broken.name}, request_.timing);
    const ConcludedBenchmark concluded = conclude(timing.measured, request_.verdicts).front();
    const MeasuredBenchmark& benchmark = timing.measured.benchmarks.front();
    const bool has_time =
        !timing.samples.empty() || !benchmark.control.empty() || !benchmark.blocks.empty();
    const std::string why = benchmark.objection.empty() ? concluded.reason : benchmark.objection;
    return {.benchmark = broken.name,
            .demanded = broken.demanded,
            .found = fmt::format("{}: {}{}", name_of(concluded.verdict), why,
                                 has_time ? "; it was given times" : ""),
            .is_refused = concluded.verdict == broken.verdict && !has_time};
  }

  void compare_all(double start_s) {
    const std::vector<ComparisonKind> kinds = mixed(request_);
    for (std::size_t i = 0; i < kinds.size(); ++i) {
      if (now_s() - start_s > request_.most_s) return;
      show(fmt::format("comparison {} of {}, {:.0f} s", i + 1, kinds.size(), now_s() - start_s));
      if (kinds[i] == ComparisonKind::usual)
        compare_as_usual();
      else
        compare(kinds[i] == ComparisonKind::handicapped);
    }
  }

  void compare(bool is_slow) {
    const PairTiming timing =
        measured(is_slow ? *handicapped_ : *alike_, {steady}, request_.timing);
    const ConcludedBenchmark concluded = conclude(timing.measured, request_.verdicts).front();
    count(is_slow ? result_.handicapped : result_.alike, concluded.verdict);
    if (concluded.control) noise_floors_.push_back(concluded.noise_floor);
    if (is_slow && concluded.ratio) found_ratios_.push_back(concluded.ratio->value);
  }

  void compare_as_usual() {
    TimingSettings settings = request_.usual_timing;
    settings.budget_s =
        std::min(settings.budget_s, 0.4 * request_.most_s / request_.usual_repetitions);
    settings.least_blocks = std::max(settings.least_blocks,
                                     blocks_needed(request_.usual_names.size(), request_.verdicts));
    settings.most_blocks = std::max(settings.least_blocks, settings.most_blocks);
    settings.tolerance = request_.verdicts.tolerance;
    const PairTiming timing = measured(*alike_, request_.usual_names, settings);
    count(result_.usual, worst_of(conclude(timing.measured, request_.verdicts)));
  }

  void show(const std::string& line) const {
    if (request_.show_progress) request_.show_progress(line);
  }

  const InstrumentRequest& request_;
  std::unique_ptr<TimedSide> base_, alike_, handicapped_;
  InstrumentCheck result_;
  std::vector<double> noise_floors_, found_ratios_;
  std::uint64_t next_ = 0;  ///< number of the next comparison
};

}  // namespace

void refuse_to_time_counters(const WorkerDescription& description, const std::string& whose) {
  if (description.counts_work)
    throw InputError(whose + ": was built with work counters, which take time; time another build");
}

InstrumentCheck check_instrument(const InstrumentRequest& request) {
  return InstrumentChecker(request).check();
}

}  // namespace phytobench
