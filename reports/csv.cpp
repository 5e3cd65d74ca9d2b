// SPDX-License-Identifier: MIT
#include "reports/csv.hpp"

#include "reports/document_claims.hpp"
#include "reports/exact_text.hpp"
#include "reports/repeat_commands.hpp"

namespace phytobench {

namespace {

using Fields = std::vector<std::string>;

Fields joined(Fields front, const Fields& back) {
  front.insert(front.end(), back.begin(), back.end());
  return front;
}

/// The command that measures a claim alone; nothing where there is nothing to measure.
std::string repeat_command(const Claim& claim, std::uint64_t seed) {
  if (claim.checks.empty()) return "";
  return repeat_experiments(experiments_of(claim), claim.tier, seed);
}

Fields claim_fields(const Claim& claim, const Judgement& judgement, bool hidden,
                    std::uint64_t seed) {
  return {claim.id,
          claim.paper,
          claim.topic,
          claim.locator,
          claim.kind,
          claim.text,
          claim.published,
          claim.unit,
          claim.digits ? std::to_string(*claim.digits) : "",
          hidden ? "" : judgement.measured,
          hidden ? "" : std::string(name_of(judgement.verdict)),
          hidden ? left_out_row : std::string(row_of(judgement).identifier),
          claim.basis,
          std::string(name_of(claim.expected_verdict)),
          claim.predicted_verdict ? std::string(name_of(*claim.predicted_verdict)) : "",
          claim.difference,
          claim.machine_dependence,
          claim.erratum,
          std::string(name_of(claim.tier)),
          hidden ? claim.reason : judgement.reason,
          repeat_command(claim, seed)};
}

const Fields record_heading = {"kind",   "experiment", "measurement", "value",    "unit",   "n",
                               "spread", "seed",       "round",       "position", "threads"};

Fields record_fields(const Record& record) {
  return {"record",
          record.experiment,
          record.measurement,
          exact_text(record.value),
          record.unit,
          std::to_string(record.sample_size),
          record.spread ? exact_text(*record.spread) : "",
          record.seed ? std::to_string(*record.seed) : "",
          "",
          "",
          ""};
}

Fields sample_fields(const TimingSample& sample) {
  return {"sample",
          sample.experiment,
          sample.measurement,
          exact_text(sample.value),
          sample.unit,
          "1",
          "",
          "",
          std::to_string(sample.round),
          std::to_string(sample.position),
          std::to_string(sample.threads)};
}

/// What names a run: reasons and measured values call it by its letter.
const Fields run_heading = {"letter", "run"};

Fields run_fields(std::span<const ComparedRun> runs, std::size_t run) {
  return {run_letter(run), runs[run].label};
}

/// The rows of one run; `first` stands before each.
std::string record_rows(const RunContents& run, const Fields& first, bool without_varying) {
  std::string csv;
  for (const Record& record : run.records) csv += csv_line(joined(first, record_fields(record)));
  if (without_varying) return csv;
  for (const TimingSample& sample : run.timings)
    csv += csv_line(joined(first, sample_fields(sample)));
  return csv;
}

}  // namespace

std::string csv_line(const Fields& fields) {
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
  std::string csv = csv_line({"id",
                              "paper",
                              "topic",
                              "locator",
                              "kind",
                              "text",
                              "published",
                              "unit",
                              "digits",
                              "measured",
                              "verdict",
                              "row",
                              "basis",
                              "expected_verdict",
                              "predicted_verdict",
                              "difference",
                              "machine_dependence",
                              "erratum",
                              "tier",
                              "reason",
                              "repeat"});
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements)
      csv += csv_line(claim_fields(*judgement.claim, judgement, without_varying && judgement.varies,
                                   judged.run.header.seed));
  return csv;
}

std::string records_csv(const RunContents& run, bool without_varying) {
  return csv_line(record_heading) + record_rows(run, {}, without_varying);
}

std::string records_csv(std::span<const ComparedRun> runs, bool without_varying) {
  std::string csv = csv_line(joined(run_heading, record_heading));
  for (std::size_t run = 0; run < runs.size(); ++run)
    csv += record_rows(runs[run].contents, run_fields(runs, run), without_varying);
  return csv;
}

std::string claims_by_run_csv(const RunComparison& comparison, bool without_varying) {
  std::string csv =
      csv_line(joined(joined({"id"}, run_heading), {"verdict", "measured", "merged_verdict"}));
  for (const ComparedClaim& claim : comparison.claims) {
    if (without_varying && claim.varies) continue;
    for (std::size_t run = 0; run < comparison.runs.size(); ++run)
      csv += csv_line(joined(joined({claim.id}, run_fields(comparison.runs, run)),
                             {std::string(name_of(claim.verdicts[run])), claim.measured[run],
                              std::string(name_of(claim.merged))}));
  }
  return csv;
}

std::string differing_records_csv(const RunComparison& comparison) {
  std::string csv = csv_line(joined(joined({"measurement"}, run_heading), {"value"}));
  for (const DifferingRecord& record : comparison.records.differing)
    for (std::size_t run = 0; run < comparison.runs.size(); ++run)
      if (record.values[run])
        csv += csv_line(joined(joined({record.measurement}, run_fields(comparison.runs, run)),
                               {*record.values[run]}));
  return csv;
}

}  // namespace phytobench
