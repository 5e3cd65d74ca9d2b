// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/change_bounds.hpp"
#include "benchmarks/comparison/verdict_reason.hpp"
#include "core/contract/check.hpp"
#include "core/statistics/bootstrap.hpp"
#include "core/statistics/false_discovery_rate.hpp"
#include "core/statistics/signed_rank.hpp"

namespace phytobench {

namespace {

struct Conclusion {
  SpeedVerdict verdict = SpeedVerdict::inconclusive;
  std::string reason;
};

/// Verdicts that need no times.
std::optional<Conclusion> without_times(const MeasuredBenchmark& benchmark, bool is_same_program) {
  using enum SpeedVerdict;
  if (!benchmark.is_same_work)
    return Conclusion{nothing_measured, benchmark.objection.empty()
                                            ? "its inputs differ, or one side does not have it"
                                            : benchmark.objection};
  if (!benchmark.objection.empty()) return Conclusion{wrong_answer, benchmark.objection};
  if (is_same_program) return Conclusion{same_binary, "both sides have the same code and data"};
  if (benchmark.blocks.empty()) return Conclusion{nothing_measured, "no block was finished"};
  return std::nullopt;
}

std::vector<double> log_ratios(const std::vector<BlockTimes>& blocks) {
  std::vector<double> ratios;
  for (const BlockTimes& block : blocks) ratios.push_back(block.log_ratio());
  return ratios;
}

/// None of too few blocks.
std::optional<Estimate> ratio_of(const std::vector<BlockTimes>& blocks,
                                 const VerdictSettings& settings) {
  if (blocks.size() < static_cast<std::size_t>(settings.least_blocks)) return std::nullopt;
  const Estimate logs = median_estimate(log_ratios(blocks), {.resamples = settings.resamples});
  return Estimate{std::exp(logs.value), std::exp(logs.low), std::exp(logs.high)};
}

void estimate(ConcludedBenchmark& result, const MeasuredBenchmark& benchmark,
              const VerdictSettings& settings) {
  result.ratio = ratio_of(benchmark.blocks, settings);
  result.control = ratio_of(benchmark.control, settings);
  if (result.control) result.noise_floor = largest_change(*result.control);
}

/// Why there is nothing to test.
std::optional<Conclusion> untestable(const ConcludedBenchmark& result, std::size_t control_blocks,
                                     const VerdictSettings& settings) {
  if (!result.ratio)
    return Conclusion{.reason = fmt::format("{} of at least {} blocks were measured", result.blocks,
                                            settings.least_blocks)};
  if (!result.control)
    return Conclusion{.reason = fmt::format("{} of at least {} blocks of the control were measured",
                                            control_blocks, settings.least_blocks)};
  if (least_change(*result.control) > settings.tolerance)
    return Conclusion{.reason = broken_instrument(*result.control)};
  return std::nullopt;
}

/// Before it is adjusted. Twice the tail on the side of the median, not the smaller of both tails:
/// the test must not speak for the other side than the interval does.
double p_value(const std::vector<BlockTimes>& blocks, const Estimate& ratio) {
  const SignedRankTest test = signed_rank_test(log_ratios(blocks));
  if (ratio.value == 1.0) return 1.0;
  return std::min(1.0, 2.0 * (ratio.value > 1.0 ? test.p_greater : test.p_less));
}

Conclusion judged(const ConcludedBenchmark& benchmark, const VerdictSettings& settings,
                  std::size_t tested) {
  const Estimate& ratio = *benchmark.ratio;
  const double limit = std::max(settings.tolerance, settings.noise_factor * benchmark.noise_floor);
  if (least_change(ratio) > limit && benchmark.p < settings.alpha)
    return {ratio.value > 1.0 ? SpeedVerdict::slower : SpeedVerdict::faster,
            beyond_doubt(benchmark, settings)};
  if (std::max(largest_change(ratio), benchmark.noise_floor) <= settings.tolerance)
    return {SpeedVerdict::same, within_tolerance(benchmark, settings)};
  return {SpeedVerdict::inconclusive, doubt(benchmark, settings, tested)};
}

void conclude_with(ConcludedBenchmark& benchmark, Conclusion conclusion) {
  benchmark.verdict = conclusion.verdict;
  benchmark.reason = std::move(conclusion.reason);
}

/// Adjusts p and judges the benchmarks at these places.
void judge_together(std::vector<ConcludedBenchmark>& all, const std::vector<std::size_t>& tested,
                    const VerdictSettings& settings) {
  std::vector<double> p_values;
  for (const std::size_t place : tested) p_values.push_back(all[place].p);
  const std::vector<double> adjusted = false_discovery_adjusted(p_values);
  for (std::size_t i = 0; i < tested.size(); ++i) {
    ConcludedBenchmark& benchmark = all[tested[i]];
    benchmark.p = adjusted[i];
    conclude_with(benchmark, judged(benchmark, settings, tested.size()));
  }
}

void expect_in_range(const VerdictSettings& settings) {
  PHYTOBENCH_EXPECT(settings.tolerance > 0.0 && std::isfinite(settings.tolerance));
  PHYTOBENCH_EXPECT(settings.alpha > 0.0 && settings.alpha < 1.0);
  PHYTOBENCH_EXPECT(settings.noise_factor >= 0.0 && std::isfinite(settings.noise_factor));
  PHYTOBENCH_EXPECT(settings.least_blocks >= 1 && settings.resamples > 0);
}

}  // namespace

std::vector<ConcludedBenchmark> conclude(const Measured& measured,
                                         const VerdictSettings& settings) {
  expect_in_range(settings);
  std::vector<ConcludedBenchmark> all;
  std::vector<std::size_t> tested;
  for (const MeasuredBenchmark& benchmark : measured.benchmarks) {
    ConcludedBenchmark result{.name = benchmark.name, .blocks = benchmark.blocks.size()};
    std::optional<Conclusion> early = without_times(benchmark, measured.is_same_program);
    if (!early) {
      estimate(result, benchmark, settings);
      early = untestable(result, benchmark.control.size(), settings);
    }
    if (early) {
      conclude_with(result, *early);
    } else {
      result.p = p_value(benchmark.blocks, *result.ratio);
      tested.push_back(all.size());
    }
    all.push_back(std::move(result));
  }
  judge_together(all, tested, settings);
  return all;
}

int blocks_needed(std::size_t benchmarks, const VerdictSettings& settings) {
  expect_in_range(settings);
  int blocks = 0;
  for (double p = 2.0 * static_cast<double>(benchmarks); p >= settings.alpha; p *= 0.5) ++blocks;
  return std::max(settings.least_blocks, blocks);
}

}  // namespace phytobench
