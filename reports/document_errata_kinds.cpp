// SPDX-License-Identifier: MIT
#include "reports/document_errata_kinds.hpp"

#include <algorithm>
#include <map>

#include <nlohmann/json.hpp>

namespace phytobench {

namespace {

constexpr const char* no_kind = "kind not told";

std::vector<CorrectedClaims> all_kinds() {
  return {{name_of(ErratumKind::formula), "a formula"},
          {name_of(ErratumKind::number), "a number"},
          {name_of(ErratumKind::missing_case), "a missing case"},
          {name_of(ErratumKind::wording), "the wording"},
          {name_of(ErratumKind::bookkeeping), "bookkeeping (a label, reference or symbol)"},
          {name_of(ErratumKind::program), "not the text, but it differs from the program"},
          {no_kind, "not sorted yet"}};
}

}  // namespace

std::optional<std::string> kind_of_correction(const JudgedPaper& paper, const Judgement& judgement,
                                              bool without_varying) {
  if (judgement.verdict != Verdict::reproduced_with_erratum) return std::nullopt;
  if (without_varying && judgement.varies) return std::nullopt;
  const auto erratum = std::find_if(paper.errata.begin(), paper.errata.end(), [&](const auto& e) {
    return e.id == judgement.claim->erratum;
  });
  if (erratum == paper.errata.end() || !erratum->kind) return no_kind;
  return name_of(*erratum->kind);
}

std::vector<CorrectedClaims> corrected_by_kind(std::span<const JudgedPaper> papers,
                                               bool without_varying) {
  std::map<std::string, std::size_t> counts;
  for (const JudgedPaper& paper : papers)
    for (const Judgement& judgement : paper.judgements)
      if (const auto kind = kind_of_correction(paper, judgement, without_varying)) ++counts[*kind];
  std::vector<CorrectedClaims> kinds = all_kinds();
  for (CorrectedClaims& kind : kinds) kind.count = counts[kind.kind];
  std::erase_if(kinds, [](const CorrectedClaims& kind) { return kind.count == 0; });
  return kinds;
}

nlohmann::ordered_json errata_kinds_document(const JudgedPaper& paper, bool without_varying) {
  auto rows = nlohmann::ordered_json::array();
  for (const CorrectedClaims& kind : corrected_by_kind({&paper, 1}, without_varying))
    rows.push_back({{"kind", kind.kind}, {"words", kind.words}, {"count", kind.count}});
  return rows;
}

}  // namespace phytobench
