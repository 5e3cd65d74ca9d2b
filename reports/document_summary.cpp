// SPDX-License-Identifier: MIT
#include "reports/document_summary.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_claims.hpp"
#include "reports/document_costs.hpp"
#include "reports/document_errata_kinds.hpp"
#include "reports/document_numbers.hpp"
#include "reports/document_predictions.hpp"
#include "reports/judge/for_each_judgement.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

void count(ClaimCounts& counts, const Judgement& judgement, bool without_varying) {
  ++counts.claims;
  counts.measured += has_measurement(judgement);
  counts.vary |= judgement.varies;
  if (shown_verdict(judgement, without_varying).hidden) {
    ++counts.hidden;
    return;
  }
  counts.unexpected += judgement.is_unexpected();
  counts.contradicted += judgement.contradicted;
  if (is_fitted(judgement)) {
    ++counts.fitted;
    return;
  }
  const bool reproduced = judgement.verdict == Verdict::reproduced;
  counts.reproduced += reproduced;
  counts.from_text += reproduced && judgement.claim->basis == "paper";
  counts.with_author_values += reproduced && judgement.claim->basis == "author-published";
  counts.with_erratum += judgement.verdict == Verdict::reproduced_with_erratum;
  counts.refuted += judgement.verdict == Verdict::not_reproduced;
  counts.inconclusive += judgement.verdict == Verdict::inconclusive;
  counts.not_comparable += judgement.verdict == Verdict::not_comparable;
  counts.underspecified += judgement.verdict == Verdict::underspecified;
  if (judgement.verdict != Verdict::not_measured) return;
  counts.without_model += !judgement.claim->missing_model.empty();
  counts.not_seen += lacks_evidence(judgement);
  counts.unmeasurable += judgement.claim->missing_model.empty() && !lacks_evidence(judgement);
}

std::string works_of(const JudgedRun& judged) {
  std::string works;
  for (const JudgedPaper& paper : judged.papers)
    works += fmt::format("{}{} ({})", works.empty() ? "" : " and ", paper.paper.author,
                         paper.paper.year);
  return works;
}

/// What was timed for its own sake; every experiment's cost is timed, too.
std::size_t timings_of_models(const RunContents& run) {
  return static_cast<std::size_t>(std::ranges::count_if(
      run.timings, [](const TimingSample& sample) { return !is_cost(sample); }));
}

std::string run_text(const RunContents& run, bool timed) {
  return fmt::format(
      "{} at tier {} with seed {}: {}{}", counted(run.complete_experiments.size(), "experiment"),
      name_of(run.header.tier), run.header.seed, counted(run.records.size(), "measurement"),
      timed ? fmt::format(" and {}", counted(timings_of_models(run), "timing")) : "");
}

std::string runs_text(const RunComparison& comparison) {
  std::string text = fmt::format("{} runs, see below", comparison.runs.size());
  for (std::size_t run = 0; run < comparison.runs.size(); ++run) {
    const RunHeader& header = comparison.runs[run].contents.header;
    text += fmt::format("{} {} (tier {}, seed {})", run == 0 ? ":" : ";", run_letter(run),
                        name_of(header.tier), header.seed);
  }
  return text;
}

/// What holds from the text alone must not be mixed with what needs more than the text.
std::string found_text(const ClaimCounts& counts) {
  std::string text = fmt::format(
      "{}: {} from the text alone, {} with values that the author published elsewhere, {} under a "
      "reading or a value of ours.",
      counted(counts.reproduced, "claim is reproduced", "claims are reproduced"), counts.from_text,
      counts.with_author_values, counts.reproduced - counts.from_text - counts.with_author_values);
  if (counts.fitted > 0)
    text += fmt::format(
        " {} only with a parameter that was fitted to meet {}, which shows that such a value "
        "exists, no more.",
        counted(counts.fitted, "more holds", "more hold"), counts.fitted == 1 ? "it" : "them");
  return text;
}

/// What the works have wrong, and by what kind of mistake.
std::string wrong_text(const ClaimCounts& counts, const std::vector<CorrectedClaims>& kinds) {
  std::string text = fmt::format("{} only once corrected",
                                 counted(counts.with_erratum, "claim holds", "claims hold"));
  std::string reasons;
  for (const CorrectedClaims& kind : kinds)
    reasons += fmt::format("{}{} ({})", reasons.empty() ? "" : "; ", kind.words, kind.count);
  if (!reasons.empty()) text += fmt::format(". What is wrong: {}", reasons);
  return text +
         fmt::format(
             ". {} not reproduced: what was measured contradicts {}. If something that the work "
             "does not state would make one hold, its reason says what.",
             counted(counts.refuted, "claim is", "claims are"),
             counts.refuted == 1 ? "it" : "them");
}

std::string open_text(const ClaimCounts& counts) {
  std::string text = fmt::format(
      "{}: {} for a model that is not built yet, {} not measured in this run, {} inconclusive "
      "(noise, too few runs, or runs that disagree).",
      counted(counts.without_model + counts.not_seen + counts.inconclusive, "claim"),
      counted(counts.without_model, "waits", "wait"), counted(counts.not_seen, "was", "were"),
      counted(counts.inconclusive, "is", "are"));
  if (counts.contradicted > 0)
    text += fmt::format(" On {} the runs disagree.", counted(counts.contradicted, "claim"));
  if (counts.hidden > 0)
    text += fmt::format(" {} on times and {} left out of this version of the report.",
                        counted(counts.hidden, "claim rests", "claims rest"),
                        counts.hidden == 1 ? "is" : "are");
  return text;
}

/// What no run of this suite can decide, however long.
std::string untold_text(const ClaimCounts& counts) {
  return fmt::format(
      "{}: {} of another machine (not comparable), {} too much open to be checked "
      "(underspecified), {} that this suite can measure.",
      counted(counts.not_comparable + counts.underspecified + counts.unmeasurable, "claim"),
      counted(counts.not_comparable, "states seconds", "state seconds"),
      counted(counts.underspecified, "leaves", "leave"),
      counted(counts.unmeasurable, "states nothing", "state nothing"));
}

std::string predicted_text(const ordered_json& predictions, const ClaimCounts& counts) {
  const auto same = predictions["same"].get<std::size_t>();
  const auto differ = predictions["differ"].get<std::size_t>();
  std::string text = "No verdict was predicted before building.";
  if (predictions["predicted"] != 0)
    text = fmt::format(
        "Verdicts were predicted from notes on the texts, most of them older than this suite. Of "
        "those "
        "that this run decided, {} as predicted and {} otherwise; {} a verdict that the text alone "
        "fixes.",
        counted(same, "was found", "were found"), differ,
        counted(predictions["fixed"].get<std::size_t>(), "more has", "more have"));
  return text + fmt::format(" {} unexpectedly from what this version of the suite gives elsewhere.",
                            counts.unexpected == 0
                                ? "None differs"
                                : counted(counts.unexpected, "differs", "differ"));
}

}  // namespace

ClaimCounts counts_of(const JudgedRun& judged, bool without_varying) {
  ClaimCounts counts;
  for_each_judgement(judged, [&](const JudgedPaper&, const Judgement& judgement) {
    count(counts, judgement, without_varying);
  });
  return counts;
}

ordered_json summary_document(const JudgedRun& judged, const RunComparison* comparison,
                              bool without_varying) {
  const ClaimCounts counts = counts_of(judged, without_varying);
  const ordered_json predictions = predictions_document(judged, without_varying);
  const bool timed = !without_varying && timings_of_models(judged.run) > 0;
  const bool varies = counts.vary && !without_varying;
  ordered_json lines = ordered_json::array();
  const auto add = [&](const char* term, const std::string& text, bool line_varies) {
    lines.push_back({{"term", term}, {"text", text}, {"varies", line_varies}});
  };
  add("Asked",
      fmt::format("Do the {} of {} hold when the models are built again from the text and run?",
                  counted(counts.claims, "claim"), works_of(judged)),
      false);
  add("Run",
      fmt::format("{}. {} of the claims had a measurement, a few of them only in part.",
                  comparison ? runs_text(*comparison) : run_text(judged.run, timed),
                  counts.measured),
      timed);
  add("Found", found_text(counts), varies);
  add("Wrong in the works", wrong_text(counts, corrected_by_kind(judged.papers, without_varying)),
      varies);
  add("Open", open_text(counts), varies);
  add("Cannot be told", untold_text(counts), false);
  add("Predicted", predicted_text(predictions, counts), varies);
  return lines;
}

}  // namespace phytobench
