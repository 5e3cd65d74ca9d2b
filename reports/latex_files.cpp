// SPDX-License-Identifier: MIT
#include "reports/latex_files.hpp"

#include "reports/latex_claims.hpp"
#include "reports/latex_tables.hpp"
#include "reports/run_limits.hpp"

namespace phytobench {

std::string latex_table_name(const PublishedTable& table) {
  return table.paper + "-" + table.id;
}

ReportFiles latex_files(const JudgedRun& judged, bool without_varying) {
  ReportFiles files;
  const auto add = [&](const std::string& name, std::string latex) {
    if (!latex.empty()) files["tables/" + name + ".tex"] = std::move(latex);
  };
  add("counts", latex_counts(judged, without_varying));
  add("claims", latex_claim_macros(judged, without_varying));
  add("all", latex_wrapper(judged, without_varying));
  for (const JudgedPaper& paper : judged.papers) {
    add("claims-" + paper.paper.key,
        latex_claim_table(paper, without_varying, incompleteness(judged)));
    for (const JudgedTable& table : paper.tables) {
      const std::string name = latex_table_name(*table.table);
      add(name, latex_table(table, without_varying));
      add(name + "-shares", latex_share_table(table, without_varying));
    }
  }
  return files;
}

}  // namespace phytobench
