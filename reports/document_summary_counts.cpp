// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reference/claim_bases.hpp"
#include "reports/document_anchors.hpp"
#include "reports/document_claims.hpp"
#include "reports/document_errata_kinds.hpp"
#include "reports/document_summary.hpp"
#include "reports/judge/for_each_judgement.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

/// One row of the counts; `belongs` says which judgements it counts.
template <class Belongs>
ordered_json counts_row(const JudgedRun& judged, const ShownVerdict& verdict,
                        const Belongs& belongs) {
  std::size_t total = 0;
  std::map<std::string, std::size_t> by_basis, by_paper;
  for_each_judgement(judged, [&](const JudgedPaper& paper, const Judgement& judgement) {
    if (!belongs(paper, judgement)) return;
    ++total;
    ++by_basis[judgement.claim->basis];
    ++by_paper[paper.paper.key];
  });
  ordered_json row{
      {"verdict", verdict.label}, {"class", verdict.look}, {"row", verdict.row}, {"total", total}};
  row["any"] = total > 0;
  row["by_basis"] = row["by_paper"] = row["kinds"] = ordered_json::array();
  for (const std::string_view basis : claim_bases)
    row["by_basis"].push_back({{"count", by_basis[std::string(basis)]}});
  for (const JudgedPaper& paper : judged.papers)
    row["by_paper"].push_back({{"count", by_paper[paper.paper.key]}});
  return row;
}

ordered_json counts_row(const JudgedRun& judged, const VerdictRow& row, bool without_varying) {
  ordered_json part =
      counts_row(judged, {std::string(row.name), row_class(row), slug(row.identifier)},
                 [&](const JudgedPaper&, const Judgement& judgement) {
                   return shown_verdict(judgement, without_varying).label == row.name;
                 });
  if (row.verdict != Verdict::reproduced_with_erratum) return part;
  for (const CorrectedClaims& kind : corrected_by_kind(judged.papers, without_varying))
    part["kinds"].push_back(counts_row(judged, {kind.kind, row_class(row), slug(row.identifier)},
                                       [&](const JudgedPaper& paper, const Judgement& judgement) {
                                         return kind_of_correction(paper, judgement,
                                                                   without_varying) == kind.kind;
                                       }));
  return part;
}

}  // namespace

ordered_json counts_document(const JudgedRun& judged, bool without_varying) {
  ordered_json rows = ordered_json::array();
  for (const VerdictRow& row : verdict_rows())
    rows.push_back(counts_row(judged, row, without_varying));
  if (counts_of(judged, without_varying).hidden > 0)
    rows.push_back(counts_row(judged, {left_out_row, left_out_class, left_out_class, true},
                              [&](const JudgedPaper&, const Judgement& judgement) {
                                return shown_verdict(judgement, without_varying).hidden;
                              }));
  ordered_json kinds = ordered_json::array(), works = ordered_json::array();
  for_each_judgement(judged, [&](const JudgedPaper&, const Judgement& judgement) {
    const std::string& kind = judgement.claim->kind;
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  });
  for (const JudgedPaper& paper : judged.papers)
    works.push_back(fmt::format("{} {}", paper.paper.author, paper.paper.year));
  return {{"bases", ordered_json(claim_bases)}, {"kinds", kinds}, {"works", works}, {"rows", rows}};
}

}  // namespace phytobench
