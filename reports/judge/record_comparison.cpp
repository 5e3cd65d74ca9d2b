// SPDX-License-Identifier: MIT
#include <algorithm>
#include <bit>
#include <cmath>
#include <map>

#include "core/contract/check.hpp"
#include "reports/exact_text.hpp"
#include "reports/judge/record_paths.hpp"
#include "reports/judge/run_comparison.hpp"

namespace phytobench {

namespace {

/// What each run has under one name; null where it has nothing.
using Row = std::vector<const Record*>;

bool is_same(double a, double b) {
  return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b);
}

bool is_same_value(const RecordValue& a, const RecordValue& b) {
  const auto *first = std::get_if<double>(&a), *second = std::get_if<double>(&b);
  return first && second ? is_same(*first, *second) : a == b;
}

bool is_same_record(const Record& a, const Record& b) {
  return is_same_value(a.value, b.value) && a.unit == b.unit && a.sample_size == b.sample_size &&
         a.spread.has_value() == b.spread.has_value() &&
         (!a.spread || is_same(*a.spread, *b.spread));
}

const Record& first_of(const Row& row) {
  return **std::find_if(row.begin(), row.end(), [](const Record* record) { return record; });
}

bool are_same(const Row& row) {
  return std::all_of(row.begin(), row.end(), [&](const Record* record) {
    return !record || is_same_record(first_of(row), *record);
  });
}

std::string text_of(const Record& record, bool with_sample) {
  std::string text = exact_text(record.value);
  if (record.unit != "1") text += " " + record.unit;
  if (!with_sample) return text;
  text += " (n " + std::to_string(record.sample_size);
  if (record.spread) text += ", spread " + exact_text(*record.spread);
  return text + ")";
}

std::optional<double> relative_difference(const Row& row) {
  std::vector<double> numbers;
  for (const Record* record : row) {
    if (!record) continue;
    const std::optional<double> number = number_of(*record);
    if (!number) return std::nullopt;
    numbers.push_back(*number);
  }
  const auto [low, high] = std::minmax_element(numbers.begin(), numbers.end());
  const double magnitude = std::max(std::abs(*low), std::abs(*high));
  return magnitude > 0.0 ? (*high - *low) / magnitude : 0.0;
}

DifferingRecord differing_record(const std::string& measurement, const Row& row) {
  DifferingRecord differing{.experiment = first_of(row).experiment,
                            .measurement = measurement,
                            .values = {},
                            .relative = {}};
  for (const bool with_sample : {false, true}) {
    differing.values.clear();
    for (const Record* record : row)
      differing.values.push_back(record ? std::optional(text_of(*record, with_sample))
                                        : std::nullopt);
    std::vector<std::string> texts;
    for (const auto& value : differing.values)
      if (value) texts.push_back(*value);
    const bool are_told_apart =
        std::any_of(texts.begin(), texts.end(), [&](const auto& t) { return t != texts.front(); });
    if (are_told_apart) break;
  }
  differing.relative = relative_difference(row);
  return differing;
}

/// Below every number, so that what has none comes last.
double size_of(const DifferingRecord& record) {
  return record.relative.value_or(-1.0);
}

/// Experiments whose largest difference is larger come first, and within each larger differences;
/// what is equal stays in the order of names.
void sort_by_size(std::vector<DifferingRecord>& records) {
  std::map<std::string, double> largest;
  for (const DifferingRecord& record : records) {
    double& size = largest.try_emplace(record.experiment, size_of(record)).first->second;
    size = std::max(size, size_of(record));
  }
  std::stable_sort(records.begin(), records.end(), [&](const auto& a, const auto& b) {
    if (a.experiment == b.experiment) return size_of(a) > size_of(b);
    const double first = largest.at(a.experiment), second = largest.at(b.experiment);
    return first != second ? first > second : a.experiment < b.experiment;
  });
}

}  // namespace

RecordComparison compare_records(std::span<const RunContents* const> runs) {
  std::map<std::string, Row> rows;
  for (std::size_t run = 0; run < runs.size(); ++run)
    for (const Record& record : runs[run]->records) {
      Row& row = rows[record.measurement];
      row.resize(runs.size());
      row[run] = &record;
    }
  RecordComparison comparison;
  comparison.only_in.resize(runs.size());
  for (const auto& [measurement, row] : rows) {
    const auto having =
        row.size() - static_cast<std::size_t>(std::count(row.begin(), row.end(), nullptr));
    comparison.in_all += having == row.size();
    if (having == 1) {
      const auto owner = std::find_if(row.begin(), row.end(), [](const Record* r) { return r; });
      ++comparison.only_in[static_cast<std::size_t>(owner - row.begin())];
      continue;
    }
    ++comparison.shared;
    ++comparison.shared_of[first_of(row).experiment];
    if (are_same(row))
      ++comparison.equal;
    else
      comparison.differing.push_back(differing_record(measurement, row));
  }
  sort_by_size(comparison.differing);
  return comparison;
}

}  // namespace phytobench
