// SPDX-License-Identifier: MIT
#include "reports/csv.hpp"

#include <fmt/format.h>

namespace phytobench {

namespace {

/// Shortest text that reads back as the same number.
std::string exact(const RecordValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return fmt::format("{}", std::get<double>(value));
}

}  // namespace

std::string csv_line(const std::vector<std::string>& fields) {
  std::string line;
  for (std::size_t i = 0; i < fields.size(); ++i) {
    if (i > 0) line += ',';
    if (fields[i].find_first_of(",\"\n\r") == std::string::npos) {
      line += fields[i];
      continue;
    }
    line += '"';
    for (const char c : fields[i]) line += c == '"' ? std::string("\"\"") : std::string(1, c);
    line += '"';
  }
  return line + "\n";
}

std::string claims_csv(const JudgedRun& judged, bool without_varying) {
  std::string csv = csv_line({"id", "locator", "kind", "verdict", "basis", "published", "measured",
                              "expected_verdict", "reason"});
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) {
      const Claim& claim = *judgement.claim;
      const bool hidden = without_varying && judgement.varies;
      csv += csv_line({claim.id, claim.locator, claim.kind,
                       hidden ? "" : std::string(name_of(judgement.verdict)), claim.basis,
                       claim.published, hidden ? "" : judgement.measured,
                       std::string(name_of(claim.expected_verdict)), judgement.reason});
    }
  return csv;
}

std::string records_csv(const RunContents& run) {
  std::string csv = csv_line({"measurement", "value", "unit", "n", "seed"});
  for (const Record& record : run.records)
    csv += csv_line({record.measurement, exact(record.value), record.unit,
                     std::to_string(record.sample_size),
                     record.seed ? std::to_string(*record.seed) : ""});
  return csv;
}

}  // namespace phytobench
