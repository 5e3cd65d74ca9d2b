// SPDX-License-Identifier: MIT
// What is wrong with the claims that hold only in another form than the printed one.
#pragma once

#include <optional>
#include <span>
#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// The kind of the erratum by which a claim is wrong as printed and holds corrected: "formula",
/// or "kind not told" where its erratum has none. Nothing for a claim of another verdict, and for
/// one that is left out because it rests on times.
std::optional<std::string> kind_of_correction(const JudgedPaper& paper, const Judgement& judgement,
                                              bool without_varying);

struct CorrectedClaims {
  std::string kind;
  std::string words;  ///< what is wrong, in a sentence: "a formula", "the wording"
  std::size_t count = 0;
};

/// Claims that are wrong as printed and hold corrected, by the kind of their erratum: those that
/// occur, in the order of the kinds.
std::vector<CorrectedClaims> corrected_by_kind(std::span<const JudgedPaper> papers,
                                               bool without_varying);

/// The same of one work, for the section on its errata: rows of kind, words and count.
nlohmann::ordered_json errata_kinds_document(const JudgedPaper& paper, bool without_varying);

}  // namespace phytobench
