// SPDX-License-Identifier: MIT
// The parts of the validation that rest on experiments about the works.
#include <algorithm>
#include <cmath>

#include "core/statistics/moments.hpp"
#include "core/statistics/order_statistics.hpp"
#include "core/statistics/power_law.hpp"
#include "reports/judge/record_paths.hpp"
#include "reports/judge/validation.hpp"

namespace phytobench {

namespace {

/// Names by which experiments record how far core is from a transcription:
/// "agreement/..._difference",
/// "..._difference_from_print", "..._difference_from_core".
bool is_transcription(const std::string& measurement) {
  const std::string last = path_parts(measurement).back();
  if (last.ends_with("difference_from_print") || last.ends_with("difference_from_core"))
    return true;
  return measurement.find("/agreement/") != std::string::npos && last.ends_with("difference");
}

/// The order of errors below "<experiment>/step-<n>/" against their steps' length.
std::optional<ObservedOrder> order_of_steps(const RunContents& run, const std::string& experiment,
                                            const std::string& error, double expected) {
  const RecordsBelow records(run.records, experiment + "/step-");
  std::vector<double> lengths, errors;
  for (const auto& [name, record] : records.by_name()) {
    const auto parts = path_parts(name);
    if (parts.size() != 2 || parts[1] != error) continue;
    const auto length = records.number(parts[0] + "/length"), value = number_of(*record);
    if (!length || !value || !(*length > 0.0) || !(*value > 0.0)) continue;
    lengths.push_back(*length);
    errors.push_back(*value);
  }
  const auto law = fit_power_law(lengths, errors);
  if (!law) return std::nullopt;
  return ObservedOrder{experiment + "/step-*/" + error, expected, law->exponent};
}

/// An order that an experiment has fitted itself.
std::optional<ObservedOrder> recorded_order(const RunContents& run, const std::string& group,
                                            double expected) {
  const RecordsBelow records(run.records, group + "/");
  const auto value = records.number("exponent"), low = records.number("exponent_low"),
             high = records.number("exponent_high");
  if (!value || !low || !high) return std::nullopt;
  return ObservedOrder{group + "/exponent", expected, {*value, *low, *high}};
}

/// Logarithms of times by series, in the order of rounds.
using SeriesByName = std::map<std::string, std::map<std::int64_t, double>>;

std::map<std::string, SeriesByName> series_by_experiment(const RunContents& run) {
  std::map<std::string, SeriesByName> experiments;
  for (const TimingSample& sample : run.timings)
    if (sample.unit == "s" && sample.value > 0.0)
      experiments[sample.experiment][sample.measurement][sample.round] = std::log(sample.value);
  return experiments;
}

/// Nothing for few rounds, or times that are all the same.
std::optional<double> correlation_of(const std::map<std::int64_t, double>& rounds) {
  constexpr std::size_t least_rounds = 9;
  std::vector<double> logs;
  for (const auto& [round, log] : rounds) logs.push_back(log);
  if (logs.size() < least_rounds ||
      std::all_of(logs.begin(), logs.end(), [&](double log) { return log == logs[0]; }))
    return std::nullopt;
  return lag_1_autocorrelation(logs);
}

}  // namespace

std::vector<Transcription> transcriptions(const RunContents& run) {
  std::vector<Transcription> rows;
  for (const Record& record : run.records) {
    const auto difference = number_of(record);
    if (difference && is_transcription(record.measurement))
      rows.push_back({record.measurement, std::abs(*difference), record.unit});
  }
  return rows;
}

std::vector<ObservedOrder> observed_orders(const RunContents& run) {
  std::vector<ObservedOrder> orders;
  const auto add = [&](const std::optional<ObservedOrder>& order) {
    if (order) orders.push_back(*order);
  };
  // Euler's method is of order 1, both ways.
  add(order_of_steps(run, "alsweis/growth-steps", "explicit_error", 1.0));
  add(order_of_steps(run, "alsweis/growth-steps", "implicit_error", 1.0));
  // Cells cut by an edge err by their side squared, at random, and their number grows as 1 / side.
  for (const char* kind : {"equal", "winner", "field"})
    add(recorded_order(run, std::string("alsweis/shared-ground-cells/") + kind, 1.5));
  return orders;
}

std::vector<KeptQuantity> kept_quantities(const RunContents& run) {
  std::vector<KeptQuantity> rows;
  for (const Record& record : run.records) {
    const auto drift = number_of(record);
    if (drift && record.measurement.find("/invariant/") != std::string::npos &&
        record.measurement.ends_with("drift"))
      rows.push_back({record.measurement, *drift});
  }
  return rows;
}

std::vector<RoundMemory> round_memories(const RunContents& run) {
  std::vector<RoundMemory> rows;
  for (const auto& [experiment, series] : series_by_experiment(run)) {
    RoundMemory row{.experiment = experiment};
    std::vector<double> correlations;
    for (const auto& [name, rounds] : series) {
      const auto correlation = correlation_of(rounds);
      if (!correlation) continue;
      correlations.push_back(*correlation);
      row.beyond += std::abs(*correlation) > 2.0 / std::sqrt(static_cast<double>(rounds.size()));
    }
    if (correlations.empty()) continue;
    row.series = static_cast<std::int64_t>(correlations.size());
    row.median_correlation = median(correlations);
    rows.push_back(row);
  }
  return rows;
}

}  // namespace phytobench
