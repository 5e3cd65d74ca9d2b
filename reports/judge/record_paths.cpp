// SPDX-License-Identifier: MIT
#include "reports/judge/record_paths.hpp"

namespace phytobench {

std::vector<std::string> path_parts(std::string_view name) {
  std::vector<std::string> parts;
  while (true) {
    const std::size_t slash = name.find('/');
    parts.emplace_back(name.substr(0, slash));
    if (slash == std::string_view::npos) return parts;
    name.remove_prefix(slash + 1);
  }
}

RecordsBelow::RecordsBelow(const std::vector<Record>& records, const std::string& prefix) {
  for (const Record& record : records)
    if (record.measurement.starts_with(prefix))
      by_name_[record.measurement.substr(prefix.size())] = &record;
}

const Record* RecordsBelow::find(const std::string& name) const {
  const auto found = by_name_.find(name);
  return found == by_name_.end() ? nullptr : found->second;
}

std::optional<double> RecordsBelow::number(const std::string& name) const {
  const Record* const record = find(name);
  return record ? number_of(*record) : std::nullopt;
}

std::optional<std::int64_t> RecordsBelow::count(const std::string& name) const {
  const Record* const record = find(name);
  const auto* const whole = record ? std::get_if<std::int64_t>(&record->value) : nullptr;
  return whole ? std::optional(*whole) : std::nullopt;
}

std::string RecordsBelow::text(const std::string& name) const {
  const Record* const record = find(name);
  const auto* const text = record ? std::get_if<std::string>(&record->value) : nullptr;
  return text ? *text : "";
}

std::optional<double> number_of(const RecordValue& value) {
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return static_cast<double>(*whole);
  if (const auto* real = std::get_if<double>(&value)) return *real;
  return std::nullopt;
}

std::optional<double> number_of(const Record& record) {
  return number_of(record.value);
}

}  // namespace phytobench
