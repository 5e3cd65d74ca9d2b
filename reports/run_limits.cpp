// SPDX-License-Identifier: MIT
#include "reports/run_limits.hpp"

#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "reports/document_numbers.hpp"
#include "reports/document_summary.hpp"
#include "reports/repeat_commands.hpp"

namespace phytobench {

namespace {

/// Names enough to find the reason; the list of experiments below "How to repeat it" has them all.
constexpr std::size_t most_names = 6;

/// Experiments that claims of the run's tier rest on.
std::set<std::string> needed_experiments(const JudgedRun& judged) {
  std::set<std::string> needed;
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements)
      if (judgement.claim->tier <= judged.run.header.tier)
        for (const std::string& experiment : experiments_of(*judgement.claim))
          needed.insert(experiment);
  return needed;
}

std::string listed(const std::vector<std::string>& names) {
  const auto shown = static_cast<std::ptrdiff_t>(std::min(names.size(), most_names));
  std::string text = fmt::format("{}", fmt::join(names.begin(), names.begin() + shown, ", "));
  if (names.size() > most_names) text += fmt::format(" and {} more", names.size() - most_names);
  return text;
}

constexpr const char* general_limits[] = {
    "Absolute seconds of another machine, compiler and language are never compared; ratios, "
    "orderings and exponents are, within one run.",
    "Intervals cover the noise between rounds of this run, not the choice of machine, compiler "
    "or memory layout.",
    "Counts rest on one random seed where the works published one. Agreement shows that the "
    "published numbers are compatible with the text, not that the works' programs were the "
    "same as ours.",
    "A verdict of the basis assumed holds for the reading that is stated beside it; other "
    "readings may give another verdict. One of the basis fitted shows that a parameter exists, "
    "no more.",
    "The suite's own code can be wrong. Independent transcriptions of the printed equations, "
    "laws and counter-examples guard it, but nobody else has reviewed these verdicts."};

}  // namespace

std::string incompleteness(const JudgedRun& judged) {
  const auto& unfinished = judged.run.unfinished;
  std::string text;
  if (unfinished)
    text = fmt::format(
        "The records of {} break off, so that nothing of it was judged: go on with the command of "
        "the run and --resume.",
        *unfinished);
  const std::set<std::string> needed = needed_experiments(judged);
  std::vector<std::string> absent;
  for (const std::string& experiment : needed)
    if (!judged.run.complete_experiments.contains(experiment) && experiment != unfinished)
      absent.push_back(experiment);
  if (!absent.empty())
    text += fmt::format(
        "{}{} of the {} that claims of tier {} rest on {} not in it - not chosen, interrupted or "
        "failed; a run does not tell these apart: {}.",
        text.empty() ? "" : " ", absent.size(), counted(needed.size(), "experiment"),
        name_of(judged.run.header.tier), absent.size() == 1 ? "is" : "are", listed(absent));
  return text.empty() ? text : "This run is not whole. " + text;
}

std::vector<std::string> run_limits(const JudgedRun& judged, bool without_varying) {
  std::vector<std::string> limits;
  if (std::string text = incompleteness(judged); !text.empty()) limits.push_back(std::move(text));
  const ClaimCounts counts = counts_of(judged, without_varying);
  if (counts.not_seen > 0)
    limits.push_back(fmt::format(
        "{} checks that this run did not feed: it is of tier {}, or leaves experiments out.",
        counted(counts.not_seen, "claim has", "claims have"), name_of(judged.run.header.tier)));
  limits.insert(limits.end(), std::begin(general_limits), std::end(general_limits));
  return limits;
}

}  // namespace phytobench
