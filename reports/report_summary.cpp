// SPDX-License-Identifier: MIT
#include "reports/report_summary.hpp"

#include <map>

#include <fmt/format.h>

#include "reports/document_errata_kinds.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

ReportSummary report_summary(const JudgedRun& judged) {
  ReportSummary summary;
  std::map<std::string_view, std::size_t> counts;
  std::string unexpected;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) {
      ++counts[row_of(judgement).name];
      summary.inconclusive += judgement.verdict == Verdict::inconclusive;
      if (!judgement.is_unexpected()) continue;
      ++summary.unexpected;
      unexpected += fmt::format("unexpected: {} is '{}', expected '{}' ({})\n", judgement.claim->id,
                                label_of(judgement.verdict),
                                label_of(judgement.claim->expected_verdict), judgement.measured);
    }
  for (const VerdictRow& row : verdict_rows())
    if (counts[row.name] > 0) {
      summary.text += fmt::format("{:4}  {}\n", counts[row.name], row.name);
      if (row.verdict != Verdict::reproduced_with_erratum) continue;
      for (const CorrectedClaims& kind : corrected_by_kind(judged.papers, false))
        summary.text += fmt::format("      {:4}  {}\n", kind.count, kind.kind);
    }
  summary.text += unexpected;
  if (const auto& experiment = judged.run.unfinished)
    summary.text +=
        fmt::format("{} was left out: its records break off; go on with --resume\n", *experiment);
  return summary;
}

}  // namespace phytobench
