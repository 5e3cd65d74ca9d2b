// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/unpaired_verdict.hpp"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/change_bounds.hpp"
#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/verdict_reason.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/false_discovery_rate.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/statistics/rank_sum.hpp"

namespace phytobench {

namespace {

/// Streams of random numbers: one for each use, so that none depends on what else was asked.
enum BootstrapStream : std::uint64_t { of_ratio = 0, of_control = 1 };

double resampled_median(std::span<const double> values, UnitStream& stream,
                        std::vector<double>& drawn) {
  drawn.resize(values.size());
  for (double& value : drawn)
    value =
        values[static_cast<std::size_t>(stream.next_unit() * static_cast<double>(values.size()))];
  return median(drawn);
}

/// Ratio of medians other / base with the percentile interval of a bootstrap of both sides.
Estimate ratio_of_medians(std::span<const double> base, std::span<const double> other,
                          const UnpairedVerdictSettings& settings, BootstrapStream use) {
  CounterStream stream(settings.seed, use);
  std::vector<double> drawn, ratios;
  ratios.reserve(static_cast<std::size_t>(settings.resamples));
  for (int i = 0; i < settings.resamples; ++i) {
    const double below = resampled_median(base, stream, drawn);
    ratios.push_back(resampled_median(other, stream, drawn) / below);
  }
  return {median(other) / median(base), quantile(ratios, 0.025), quantile(ratios, 0.975)};
}

Estimate odd_against_even(std::span<const double> samples,
                          const UnpairedVerdictSettings& settings) {
  std::vector<double> halves[2];
  for (std::size_t i = 0; i < samples.size(); ++i) halves[i % 2].push_back(samples[i]);
  return ratio_of_medians(halves[0], halves[1], settings, of_control);
}

std::string too_few(const StoredBenchmark& base, const StoredBenchmark& other,
                    const UnpairedVerdictSettings& settings) {
  const std::string counts = fmt::format(
      "{} and {} {}: it takes {} of each", base.repetitions().size(), other.repetitions().size(),
      base.is_by_process ? "processes" : "repetitions", settings.least_repetitions);
  if (base.is_by_process) return counts;
  return fmt::format("{} (--benchmark_repetitions={} or more)", counts, settings.least_repetitions);
}

/// What can be said before anything is computed.
std::optional<ConcludedBenchmark> refusal(const StoredBenchmark& base, const StoredBenchmark& other,
                                          const UnpairedVerdictSettings& settings) {
  const auto said = [&](SpeedVerdict verdict, std::string reason) {
    return ConcludedBenchmark{.name = base.name, .verdict = verdict, .reason = std::move(reason)};
  };
  if (!base.objection.empty())
    return said(SpeedVerdict::nothing_measured, "base has no times: " + base.objection);
  if (other.objection == no_time_to_measure)
    return said(SpeedVerdict::nothing_measured, other.objection);
  if (!other.objection.empty()) return said(SpeedVerdict::wrong_answer, "new: " + other.objection);
  if (!base.inputs.empty() && !other.inputs.empty() && base.inputs != other.inputs)
    return said(SpeedVerdict::nothing_measured, "inputs differ: it is not the same work");
  if (!base.answer.empty() && !other.answer.empty() && base.answer != other.answer)
    return said(SpeedVerdict::wrong_answer, "it gives another answer than base");
  const std::size_t fewest = std::min(base.repetitions().size(), other.repetitions().size());
  if (fewest == 0)
    return said(SpeedVerdict::nothing_measured,
                base.is_aggregate_only || other.is_aggregate_only
                    ? "only means and medians were kept; measure again without "
                      "--benchmark_report_aggregates_only"
                    : "there is no time of it");
  if (fewest >= static_cast<std::size_t>(settings.least_repetitions)) return std::nullopt;
  ConcludedBenchmark few = said(SpeedVerdict::inconclusive, too_few(base, other, settings));
  few.blocks = fewest;
  return few;
}

/// Numbers without a verdict yet; p is not adjusted yet.
ConcludedBenchmark measured(const StoredBenchmark& base, const StoredBenchmark& other,
                            const UnpairedVerdictSettings& settings) {
  const std::vector<double> before = base.repetitions(), after = other.repetitions();
  ConcludedBenchmark result{.name = base.name,
                            .ratio = ratio_of_medians(before, after, settings, of_ratio),
                            .control = odd_against_even(before, settings)};
  result.noise_floor = largest_change(*result.control);
  result.p = rank_sum_test(before, after).p_two_sided;
  result.blocks = std::min(before.size(), after.size());
  return result;
}

std::string unpaired_doubt(const ConcludedBenchmark& benchmark,
                           const UnpairedVerdictSettings& settings) {
  const double surely = least_change(*benchmark.ratio);
  const bool is_noise_the_reason = surely > settings.tolerance
                                       ? surely <= settings.noise_factor * benchmark.noise_floor
                                       : benchmark.noise_floor >= settings.tolerance;
  if (is_noise_the_reason)
    return fmt::format("but base alone varies by up to {:.1f} %", 100.0 * benchmark.noise_floor);
  if (surely > settings.tolerance)
    return fmt::format("but p is {:.2g} and must be below {:g}", benchmark.p, settings.alpha);
  return fmt::format("and stored times tell no change below {:g} %", 100.0 * settings.tolerance);
}

void conclude_one(ConcludedBenchmark& benchmark, const UnpairedVerdictSettings& settings) {
  const Estimate& ratio = *benchmark.ratio;
  const double surely = least_change(ratio);
  const std::string limit = fmt::format("{:g} %", 100.0 * settings.tolerance);
  std::string clause;
  if (surely > settings.tolerance && surely > settings.noise_factor * benchmark.noise_floor &&
      benchmark.p < settings.alpha) {
    benchmark.verdict = ratio.value > 1.0 ? SpeedVerdict::slower : SpeedVerdict::faster;
    clause = "more than " + limit;
  } else if (largest_change(ratio) <= settings.tolerance &&
             benchmark.noise_floor < settings.tolerance) {
    benchmark.verdict = SpeedVerdict::same;
    clause = "within " + limit;
  } else {
    benchmark.verdict = SpeedVerdict::inconclusive;
    clause = unpaired_doubt(benchmark, settings);
  }
  benchmark.reason = fmt::format("{}, {}", change_text(ratio), clause);
}

const StoredBenchmark* found(const StoredResult& result, const std::string& name) {
  for (const StoredBenchmark& benchmark : result.benchmarks)
    if (benchmark.name == name) return &benchmark;
  return nullptr;
}

ConcludedBenchmark only_in(const char* side, const StoredBenchmark& benchmark) {
  return {.name = benchmark.name, .reason = fmt::format("only {} has it", side)};
}

void conclude_all(std::vector<ConcludedBenchmark>& all, const UnpairedVerdictSettings& settings) {
  std::vector<double> p;
  for (const ConcludedBenchmark& benchmark : all)
    if (benchmark.ratio) p.push_back(benchmark.p);
  const std::vector<double> adjusted = false_discovery_adjusted(p);
  std::size_t next = 0;
  for (ConcludedBenchmark& benchmark : all) {
    if (!benchmark.ratio) continue;
    benchmark.p = adjusted[next++];
    conclude_one(benchmark, settings);
  }
}

}  // namespace

std::string difference_of_machines(const ResultMachine& base, const ResultMachine& other) {
  constexpr double most_clock_change = 1.25;  // of one machine, which saves power when it is idle
  if (base.logical_processors == 0 || other.logical_processors == 0)
    return "a result does not say which machine it is from";
  if (base.processor != other.processor)
    return fmt::format("other machines: '{}' and '{}'", base.processor, other.processor);
  if (base.logical_processors != other.logical_processors)
    return fmt::format("other machines: {} and {} logical processors", base.logical_processors,
                       other.logical_processors);
  if (base.caches != other.caches)
    return fmt::format("other machines: caches {} and {}", base.caches, other.caches);
  if (std::max(base.mhz, other.mhz) > most_clock_change * std::min(base.mhz, other.mhz))
    return fmt::format("clocks of {:.0f} and {:.0f} MHz", base.mhz, other.mhz);
  if (base.library_build != other.library_build)
    return fmt::format("benchmark libraries built as {} and {}", base.library_build,
                       other.library_build);
  return "";
}

std::vector<ConcludedBenchmark> conclude_stored(const StoredResult& base, const StoredResult& other,
                                                const UnpairedVerdictSettings& settings) {
  PHYTOBENCH_EXPECT(settings.tolerance > 0.0 && settings.alpha > 0.0);
  PHYTOBENCH_EXPECT(settings.least_repetitions >= 2 && settings.resamples > 0);
  const std::string machines = difference_of_machines(base.machine, other.machine);
  std::vector<ConcludedBenchmark> all;
  bool has_common = false;
  for (const StoredBenchmark& benchmark : base.benchmarks) {
    const StoredBenchmark* match = found(other, benchmark.name);
    has_common = has_common || match != nullptr;
    if (match == nullptr) {
      all.push_back(only_in("base", benchmark));
    } else if (auto refused = refusal(benchmark, *match, settings)) {
      all.push_back(*std::move(refused));
    } else if (!machines.empty()) {
      all.push_back({.name = benchmark.name,
                     .verdict = SpeedVerdict::inconclusive,
                     .reason = machines + "; measure both on one machine"});
    } else {
      all.push_back(measured(benchmark, *match, settings));
    }
  }
  if (!has_common)
    throw NothingSelected(fmt::format("{} and {} have no benchmark in common; nothing was compared",
                                      base.origin.given, other.origin.given));
  for (const StoredBenchmark& benchmark : other.benchmarks)
    if (found(base, benchmark.name) == nullptr) all.push_back(only_in("new", benchmark));
  conclude_all(all, settings);
  return all;
}

}  // namespace phytobench
