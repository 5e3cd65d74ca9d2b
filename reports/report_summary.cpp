// SPDX-License-Identifier: MIT
#include "reports/report_summary.hpp"

#include <map>

#include <fmt/format.h>

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
                                name_of(judgement.verdict),
                                name_of(judgement.claim->expected_verdict), judgement.measured);
    }
  for (const VerdictRow& row : verdict_rows())
    if (counts[row.name] > 0) summary.text += fmt::format("{:4}  {}\n", counts[row.name], row.name);
  summary.text += unexpected;
  if (const auto& experiment = judged.run.unfinished)
    summary.text +=
        fmt::format("{} was left out: its records break off; go on with --resume\n", *experiment);
  return summary;
}

}  // namespace phytobench
