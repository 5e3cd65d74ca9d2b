// SPDX-License-Identifier: MIT
#include "reports/document_timings.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/statistics/median_of_rounds.hpp"
#include "core/statistics/order_statistics.hpp"
#include "reports/document_anchors.hpp"
#include "reports/document_costs.hpp"
#include "reports/document_intervals.hpp"
#include "reports/document_numbers.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t least_pairs = 2;  ///< fewer say nothing of scatter

/// Samples of one measurement in the order of rounds.
struct Series {
  std::string unit;
  std::vector<std::pair<std::int64_t, double>> rounds;

  std::vector<double> values() const {
    std::vector<double> values;
    for (const auto& [round, value] : rounds) values.push_back(value);
    return values;
  }
};

using SeriesByName = std::map<std::string, Series>;

std::map<std::string, SeriesByName> series_by_experiment(const RunContents& run) {
  std::map<std::string, SeriesByName> experiments;
  for (const TimingSample& sample : run.timings) {
    if (is_cost(sample)) continue;
    Series& series = experiments[sample.experiment][sample.measurement];
    series.unit = sample.unit;
    series.rounds.emplace_back(sample.round, sample.value);
  }
  for (auto& [experiment, by_name] : experiments)
    for (auto& [name, series] : by_name) std::sort(series.rounds.begin(), series.rounds.end());
  return experiments;
}

std::string shown_value(double value, const std::string& unit) {
  return unit == "s" ? shown_seconds(value) : fmt::format("{:.4g} {}", value, unit);
}

std::string percent_to_two_digits(double share) {
  return fmt::format("{:.2g} %", 100.0 * share);
}

ordered_json row_of(const std::string& name, const Series& series) {
  const MedianOfRounds median = median_of_rounds(series.values());
  const bool has_interval = median.rounds > 1;
  const auto shown = [&](double value) { return shown_value(value, series.unit); };
  return {
      {"name", name},
      {"rounds", median.rounds},
      {"median", shown(median.value)},
      {"has_interval", has_interval},
      {"interval", has_interval ? shown_ends(median, shown(median.low), shown(median.high)) : ""}};
}

void add_scatter(ordered_json& part, const Scatter& scatter) {
  part["has_scatter"] = scatter.pairs >= least_pairs;
  part["pairs"] = scatter.pairs;
  part["typical"] = percent_to_two_digits(scatter.typical);
  part["one_in_twenty"] = percent_to_two_digits(scatter.one_in_twenty);
}

ordered_json experiment_part(const std::string& experiment, const SeriesByName& by_name,
                             std::vector<double>& all_changes) {
  ordered_json part{{"id", experiment},
                    {"anchor", "timings-" + slug(experiment)},
                    {"measurements", by_name.size()},
                    {"rows", ordered_json::array()}};
  std::vector<double> changes;
  for (const auto& [name, series] : by_name) {
    part["rows"].push_back(row_of(name.substr(experiment.size() + 1), series));
    if (series.unit != "s") continue;
    const std::vector<double> own = round_changes(series.values());
    changes.insert(changes.end(), own.begin(), own.end());
  }
  add_scatter(part, scatter_of(changes));
  all_changes.insert(all_changes.end(), changes.begin(), changes.end());
  return part;
}

}  // namespace

std::vector<double> round_changes(std::span<const double> samples) {
  std::vector<double> changes;
  for (std::size_t i = 1; i < samples.size(); ++i)
    if (samples[i - 1] > 0.0) changes.push_back(std::abs(samples[i] / samples[i - 1] - 1.0));
  return changes;
}

Scatter scatter_of(std::span<const double> changes) {
  if (changes.empty()) return {};
  return {changes.size(), median(changes), quantile(changes, 0.95)};
}

ordered_json timings_document(const RunContents& run, bool without_varying) {
  ordered_json document{{"experiments", ordered_json::array()}};
  std::vector<double> changes;
  if (!without_varying)
    for (const auto& [experiment, by_name] : series_by_experiment(run))
      document["experiments"].push_back(experiment_part(experiment, by_name, changes));
  document["has_timings"] = !document["experiments"].empty();
  document["hidden"] = without_varying;
  document["ends"] = ends_of_medians;
  add_scatter(document, scatter_of(changes));
  return document;
}

}  // namespace phytobench
