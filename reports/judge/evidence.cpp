// SPDX-License-Identifier: MIT
#include "reports/judge/evidence.hpp"

#include <algorithm>
#include <cmath>
#include <cstdlib>

#include <fmt/format.h>

namespace phytobench {

namespace {

constexpr int most_shown_digits = 17;  // tell any two doubles apart

/// The number that a reader sees. Unlike std::stod it bears what is nearly 0.
double read_back(const std::string& text) {
  return std::strtod(text.c_str(), nullptr);
}

std::vector<double> as_seen(std::span<const double> values, int digits) {
  std::vector<double> seen;
  for (const double value : values) seen.push_back(read_back(shown(value, digits)));
  return seen;
}

/// Whether every number is seen on its side of every bound.
bool are_told_apart(std::span<const double> numbers, std::span<const double> bounds, int digits) {
  const std::vector<double> seen_numbers = as_seen(numbers, digits);
  const std::vector<double> seen_bounds = as_seen(bounds, std::max(digits, shown_digits));
  for (std::size_t i = 0; i < numbers.size(); ++i)
    for (std::size_t j = 0; j < bounds.size(); ++j) {
      const double number = numbers[i], bound = bounds[j];
      if (number == bound || !std::isfinite(number) || !std::isfinite(bound)) continue;
      if (number < bound ? seen_numbers[i] >= seen_bounds[j] : seen_numbers[i] <= seen_bounds[j])
        return false;
    }
  return true;
}

}  // namespace

Evidence::Evidence(const RunContents& run) {
  for (const Record& record : run.records) {
    records_[record.measurement] = record.value;
    if (record.sample_size > 1) sample_sizes_[record.measurement] = record.sample_size;
  }
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

std::optional<MedianOfRounds> Evidence::median_of(const std::string& measurement) const {
  const std::vector<double> own = samples(measurement);
  if (own.empty()) return std::nullopt;
  if (is_timing(measurement)) return median_of_rounds(own);
  return MedianOfRounds{{own[0], own[0], own[0]}};
}

std::optional<MedianOfRounds> Evidence::ratio_of(const std::string& first,
                                                 const std::string& second) const {
  if (!is_timing(first) && !is_timing(second)) {
    const auto a = median_of(first), b = median_of(second);
    if (!a || !b) return std::nullopt;
    const double ratio = a->value / b->value;
    return MedianOfRounds{{ratio, ratio, ratio}};
  }
  const std::map<std::int64_t, double> others = rounds(second);
  std::vector<double> numerator, denominator;
  for (const auto& [round, value] : rounds(first))
    if (const auto other = others.find(round); other != others.end()) {
      numerator.push_back(value);
      denominator.push_back(other->second);
    }
  if (numerator.empty()) return std::nullopt;
  return ratio_of_rounds(numerator, denominator);
}

std::int64_t Evidence::sample_size(const std::string& measurement) const {
  const auto found = sample_sizes_.find(measurement);
  return found == sample_sizes_.end() ? 1 : found->second;
}

std::int64_t Evidence::threads(const std::string& measurement) const {
  std::int64_t threads = 1;
  if (const auto timed = timings_.find(measurement); timed != timings_.end())
    for (const TimingSample& sample : timed->second) threads = std::max(threads, sample.threads);
  return threads;
}

std::string shown(double value, int digits) {
  if (value == std::floor(value) && std::abs(value) < 1e15) return fmt::format("{:.0f}", value);
  return fmt::format("{:.{}g}", value, digits);
}

std::string shown(const RecordValue& value, int digits) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return shown(std::get<double>(value), digits);
}

int digits_to_tell_apart(std::span<const double> numbers, std::span<const double> bounds,
                         int least) {
  // One digit more may make equal what was apart: 1.2345649 and 1.2345651 differ with six digits
  // and not with seven. So no pair is ever settled before the others.
  int digits = least;
  while (digits < most_shown_digits && !are_told_apart(numbers, bounds, digits)) ++digits;
  return digits;
}

std::string shown_range(double low, double high, int digits) {
  if (low == high) return "= " + shown(low, digits);
  const double half = (high - low) / 2.0, centre = low + half;
  const auto is_close = [&](const std::string& text, double value) {
    return std::abs(read_back(text) - value) <= half / 10.0;
  };
  if (is_close(shown(low, digits), low) && is_close(shown(high, digits), high))
    return fmt::format("{} to {}", shown(low, digits), shown(high, digits));
  std::string text = shown(centre, digits);
  for (int more = digits + 1; more <= most_shown_digits && !is_close(text, centre); ++more)
    text = shown(centre, more);
  return fmt::format("{} ± {:.2g}", text, half);
}

}  // namespace phytobench
