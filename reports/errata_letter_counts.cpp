// SPDX-License-Identifier: MIT
#include "reports/errata_letter_counts.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include <fmt/format.h>

#include "reports/errata_letter.hpp"

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
    {"holds with the correction", "hold in another form than the printed one, given above", true},
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

std::string refuted_list(const JudgedPaper& judged, bool without_varying) {
  std::string text;
  for (const Judgement& judgement : judged.judgements) {
    if (plain_verdict(judgement, without_varying) != "does not hold") continue;
    const Claim& claim = *judgement.claim;
    text += fmt::format("- {}: {}", with_literal_markdown(claim.locator),
                        with_literal_markdown(claim.text));
    constexpr std::string_view derived = "derived: ";
    if (claim.published.starts_with(derived))
      text += fmt::format(" Follows from print: {}.",
                          with_literal_markdown(claim.published.substr(derived.size())));
    else if (!claim.published.empty() && claim.published != "-")
      text += fmt::format(" Printed: {}.", with_literal_markdown(claim.published));
    constexpr std::size_t longest_found = 60;  // beyond it is a table of numbers
    if (!judgement.measured.empty() && judgement.measured.size() <= longest_found)
      text += fmt::format(" Found: {}.", with_literal_markdown(judgement.measured));
    text += fmt::format(" {}\n", with_literal_markdown(claim.reason));
  }
  return text;
}

}  // namespace

std::string plain_verdict(const Judgement& judgement, bool without_varying) {
  if (without_varying && judgement.varies) return "left out: rests on times";
  switch (judgement.verdict) {
    case Verdict::reproduced:
      return holding_by(judgement.claim->basis);
    case Verdict::reproduced_with_erratum:
      return "holds with the correction";
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
  text += "\n";
  const std::string refuted = refuted_list(judged, without_varying);
  if (!refuted.empty())
    text += "Those that do not hold, with what was looked for and found:\n\n" + refuted + "\n";
  return text;
}

}  // namespace phytobench
