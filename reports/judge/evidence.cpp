// SPDX-License-Identifier: MIT
#include "reports/judge/evidence.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace phytobench {

Evidence::Evidence(const RunContents& run) {
  for (const Record& record : run.records) records_[record.measurement] = record.value;
  for (const TimingSample& sample : run.timings) timings_[sample.measurement].push_back(sample);
  for (auto& [measurement, samples] : timings_)
    std::stable_sort(
        samples.begin(), samples.end(),
        [](const TimingSample& a, const TimingSample& b) { return a.round < b.round; });
}

bool Evidence::has(const std::string& measurement) const {
  return records_.contains(measurement) || timings_.contains(measurement);
}

std::optional<RecordValue> Evidence::recorded(const std::string& measurement) const {
  const auto found = records_.find(measurement);
  if (found == records_.end()) return std::nullopt;
  return found->second;
}

std::vector<RecordValue> Evidence::recorded_below(const std::string& prefix) const {
  std::vector<RecordValue> values;
  for (auto record = records_.lower_bound(prefix);
       record != records_.end() && record->first.starts_with(prefix); ++record)
    values.push_back(record->second);
  return values;
}

std::vector<double> Evidence::samples(const std::string& measurement) const {
  std::vector<double> samples;
  if (const auto timed = timings_.find(measurement); timed != timings_.end()) {
    for (const TimingSample& sample : timed->second) samples.push_back(sample.value);
  } else if (const auto found = records_.find(measurement); found != records_.end()) {
    if (const auto* whole = std::get_if<std::int64_t>(&found->second))
      samples.push_back(static_cast<double>(*whole));
    if (const auto* real = std::get_if<double>(&found->second)) samples.push_back(*real);
  }
  return samples;
}

std::map<std::int64_t, double> Evidence::rounds(const std::string& measurement) const {
  std::map<std::int64_t, double> rounds;
  if (const auto timed = timings_.find(measurement); timed != timings_.end())
    for (const TimingSample& sample : timed->second) rounds[sample.round] = sample.value;
  return rounds;
}

std::int64_t Evidence::threads(const std::string& measurement) const {
  std::int64_t threads = 1;
  if (const auto timed = timings_.find(measurement); timed != timings_.end())
    for (const TimingSample& sample : timed->second) threads = std::max(threads, sample.threads);
  return threads;
}

std::string shown(double value) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return fmt::format("{:.0f}", value);
  return fmt::format("{:.6g}", value);
}

std::string shown(const RecordValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return shown(std::get<double>(value));
}

std::string shown_range(double low, double high) {
  if (low == high) return "= " + shown(low);
  const double half = (high - low) / 2.0, centre = low + half;
  const auto is_close = [&](const std::string& text, double value) {
    return std::abs(std::stod(text) - value) <= half / 10.0;
  };
  if (is_close(shown(low), low) && is_close(shown(high), high))
    return fmt::format("{} to {}", shown(low), shown(high));
  std::string text = shown(centre);
  for (int digits = 7; digits <= 17 && !is_close(text, centre); ++digits)
    text = fmt::format("{:.{}g}", centre, digits);
  return fmt::format("{} ± {:.2g}", text, half);
}

}  // namespace phytobench
