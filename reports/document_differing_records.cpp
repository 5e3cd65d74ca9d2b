// SPDX-License-Identifier: MIT
#include "reports/document_differing_records.hpp"

#include <algorithm>
#include <span>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "reports/document_numbers.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr std::size_t most_records = 10;  // of an experiment; all stand in the CSV file

/// "0.25", and "-" of what is no number.
std::string relative_text(const DifferingRecord& record) {
  return record.relative ? fmt::format("{:.2g}", *record.relative) : "-";
}

std::string shared_text(const RecordComparison& records, std::size_t runs) {
  const std::string all = counted(records.in_all, "measurement");
  if (runs == 2) return fmt::format("Both runs have {} in common.", all);
  const std::string some =
      records.shared == records.in_all
          ? ""
          : fmt::format(" and some of them {} more", records.shared - records.in_all);
  return fmt::format("All {} runs have {} in common{}.", runs, all, some);
}

std::string equal_text(const RecordComparison& records) {
  if (records.shared == 0) return "";
  if (records.differing.empty()) return "None differs: all are equal, bit for bit.";
  return fmt::format("{}; the other {} equal, bit for bit.",
                     counted(records.differing.size(), "differs", "differ"),
                     counted(records.equal, "is", "are"));
}

std::string only_text(const RecordComparison& records) {
  std::vector<std::string> parts;
  for (std::size_t run = 0; run < records.only_in.size(); ++run)
    if (records.only_in[run] > 0)
      parts.push_back(fmt::format("{} in {}", records.only_in[run], run_letter(run)));
  return parts.empty() ? "" : fmt::format("Found in one run alone: {}.", fmt::join(parts, ", "));
}

ordered_json record_row(const DifferingRecord& record) {
  ordered_json cells = ordered_json::array();
  for (const auto& value : record.values) cells.push_back(value.value_or("-"));
  const bool is_below = record.measurement.starts_with(record.experiment + "/");
  return {{"measurement",
           is_below ? record.measurement.substr(record.experiment.size() + 1) : record.measurement},
          {"cells", cells},
          {"relative", relative_text(record)}};
}

/// Of one experiment, whose records follow each other.
ordered_json group_of(std::span<const DifferingRecord> records, std::size_t shared) {
  ordered_json group{{"experiment", records.front().experiment},
                     {"differing", records.size()},
                     {"shared", shared},
                     {"largest", relative_text(records.front())},
                     {"has_largest", records.front().relative.has_value()},
                     {"rows", ordered_json::array()}};
  for (const DifferingRecord& record : records.first(std::min(most_records, records.size())))
    group["rows"].push_back(record_row(record));
  group["more"] = records.size() - group["rows"].size();
  group["has_more"] = group["more"] > 0;
  return group;
}

ordered_json groups_of(const RecordComparison& comparison) {
  ordered_json groups = ordered_json::array();
  const std::span<const DifferingRecord> all = comparison.differing;
  for (std::size_t start = 0, end = 0; start < all.size(); start = end) {
    while (end < all.size() && all[end].experiment == all[start].experiment) ++end;
    const auto shared = comparison.shared_of.find(all[start].experiment);
    groups.push_back(group_of(all.subspan(start, end - start),
                              shared == comparison.shared_of.end() ? 0 : shared->second));
    groups.back()["is_first"] = start == 0;
  }
  return groups;
}

}  // namespace

ordered_json differing_records_document(const RunComparison& comparison) {
  const RecordComparison& records = comparison.records;
  ordered_json part{{"shared_text", shared_text(records, comparison.runs.size())},
                    {"equal_text", equal_text(records)},
                    {"only_text", only_text(records)},
                    {"differing", records.differing.size()},
                    {"has_differing", !records.differing.empty()},
                    {"experiments", groups_of(records)}};
  part["experiment_count"] = counted(part["experiments"].size(), "experiment");
  return part;
}

}  // namespace phytobench
