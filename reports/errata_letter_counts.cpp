// SPDX-License-Identifier: MIT
#include "reports/errata_letter_counts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "reports/document_errata_kinds.hpp"
#include "reports/errata_letter_refuted.hpp"

namespace phytobench {

namespace {

/// Every plain verdict, as it is said of one claim and, in a list, of several, in the order of the
/// list.
struct Saying {
  std::string_view of_one, of_several;
  bool decided = false;
};
constexpr std::array<Saying, 13> sayings{{
    {"holds as it stands", "hold as they stand", true},
    {"holds with values that its author published elsewhere",
     "hold with values that their author published elsewhere", true},
    {"holds under our reading", "hold under our reading of a question above", true},
    {"is wrong as printed and holds corrected", "are wrong as printed and hold corrected", true},
    {"holds with a value chosen to meet it", "hold with a value that was chosen to meet them",
     true},
    {"does not hold", "do not hold", true},
    {"could not be decided", "could not be decided: noise, or too few runs", false},
    {"could not be decided: the runs disagree", "could not be decided: the runs disagree", false},
    {"cannot be checked: too little is printed", "cannot be checked: too little is printed", false},
    {"cannot be compared: seconds of another machine",
     "cannot be compared: seconds of another machine", false},
    {"not measured: the model is not built yet", "were not measured: their model is not built yet",
     false},
    {"not measured", "were not measured", false},
    {"left out: rests on times", "are left out: they rest on times", false},
}};

std::string holding_by(const std::string& basis) {
  if (basis == "author-published") return "holds with values that its author published elsewhere";
  if (basis == "assumed") return "holds under our reading";
  if (basis == "fitted") return "holds with a value chosen to meet it";
  return "holds as it stands";
}

std::size_t decided_count(const JudgedPaper& judged, bool without_varying) {
  std::size_t count = 0;
  for (const Judgement& judgement : judged.judgements) {
    const std::string verdict = plain_verdict(judgement, without_varying);
    for (const Saying& saying : sayings) count += saying.decided && saying.of_one == verdict;
  }
  return count;
}

/// "What is wrong with those that hold corrected: a formula (3); the wording (1)."
std::string corrected_sentence(const JudgedPaper& judged, bool without_varying) {
  std::string kinds;
  for (const CorrectedClaims& kind : corrected_by_kind({&judged, 1}, without_varying))
    kinds += fmt::format("{}{} ({})", kinds.empty() ? "" : "; ", kind.words, kind.count);
  if (kinds.empty()) return "";
  return "What is wrong with those that hold corrected: " + kinds + ".\n\n";
}

}  // namespace

std::string plain_verdict(const Judgement& judgement, bool without_varying) {
  if (without_varying && judgement.varies) return "left out: rests on times";
  switch (judgement.verdict) {
    case Verdict::reproduced:
      return holding_by(judgement.claim->basis);
    case Verdict::reproduced_with_erratum:
      return "is wrong as printed and holds corrected";
    case Verdict::not_reproduced:
      return "does not hold";
    case Verdict::inconclusive:
      return judgement.contradicted ? "could not be decided: the runs disagree"
                                    : "could not be decided";
    case Verdict::underspecified:
      return "cannot be checked: too little is printed";
    case Verdict::not_comparable:
      return "cannot be compared: seconds of another machine";
    case Verdict::not_measured:
      return judgement.claim->missing_model.empty() ? "not measured"
                                                    : "not measured: the model is not built yet";
  }
  return "";
}

std::vector<std::string> verdict_counts(std::span<const Judgement* const> judgements,
                                        bool without_varying) {
  std::vector<std::string> texts;
  for (const Saying& saying : sayings) {
    const auto count =
        std::count_if(judgements.begin(), judgements.end(), [&](const Judgement* judgement) {
          return plain_verdict(*judgement, without_varying) == saying.of_one;
        });
    if (count > 0)
      texts.push_back(fmt::format("{} {}", count, count == 1 ? saying.of_one : saying.of_several));
  }
  return texts;
}

std::string confirmed_part(const JudgedPaper& judged, bool without_varying) {
  std::string text = "## What was confirmed\n\n";
  text += fmt::format(
      "The work was taken apart into {} statements. {} of them were decided; all verdicts:\n\n",
      judged.judgements.size(), decided_count(judged, without_varying));
  std::vector<const Judgement*> all;
  for (const Judgement& judgement : judged.judgements) all.push_back(&judgement);
  for (const std::string& count : verdict_counts(all, without_varying)) text += "- " + count + "\n";
  text += "\n" + corrected_sentence(judged, without_varying);
  std::string refuted;
  for (const Judgement& judgement : judged.judgements)
    if (plain_verdict(judgement, without_varying) == "does not hold")
      refuted += refuted_entry(judgement, judged);
  if (!refuted.empty())
    text += "Those that do not hold, with what was looked for and found:\n\n" + refuted + "\n";
  return text;
}

}  // namespace phytobench
