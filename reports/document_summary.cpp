// SPDX-License-Identifier: MIT
#include "reports/document_summary.hpp"

#include <algorithm>
#include <map>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_anchors.hpp"
#include "reports/document_claims.hpp"
#include "reports/document_numbers.hpp"
#include "reports/document_predictions.hpp"
#include "reports/verdict_counts.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

constexpr const char* bases[] = {"paper", "author-published", "assumed", "fitted"};

template <class Use>
void for_each_judgement(const JudgedRun& judged, const Use& use) {
  for (const JudgedPaper& paper : judged.papers)
    for (const Judgement& judgement : paper.judgements) use(paper, judgement);
}

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
  counts.undecidable +=
      judgement.verdict == Verdict::not_comparable || judgement.verdict == Verdict::underspecified;
  if (judgement.verdict != Verdict::not_measured) return;
  counts.without_model += !judgement.claim->missing_model.empty();
  counts.not_seen += lacks_evidence(judgement);
  counts.undecidable += judgement.claim->missing_model.empty() && !lacks_evidence(judgement);
}

std::string works_of(const JudgedRun& judged) {
  std::string works;
  for (const JudgedPaper& paper : judged.papers)
    works += fmt::format("{}{} ({})", works.empty() ? "" : " and ", paper.paper.author,
                         paper.paper.year);
  return works;
}

std::string run_text(const RunContents& run, bool timed) {
  return fmt::format(
      "{} at tier {} with seed {}: {}{}", counted(run.complete_experiments.size(), "experiment"),
      name_of(run.header.tier), run.header.seed, counted(run.records.size(), "measurement"),
      timed ? fmt::format(" and {}", counted(run.timings.size(), "timing")) : "");
}

std::string runs_text(const RunComparison& comparison) {
  std::string text = fmt::format("{} runs, see below", comparison.runs.size());
  for (std::size_t run = 0; run < comparison.runs.size(); ++run) {
    const RunHeader& header = comparison.runs[run].contents.header;
    text += fmt::format("{} {} (tier {}, seed {})", run == 0 ? ":" : ";",
                        comparison.runs[run].label, name_of(header.tier), header.seed);
  }
  return text;
}

/// What holds from the text alone must not be mixed with what needs more than the text.
std::string found_text(const ClaimCounts& counts) {
  std::string text = fmt::format(
      "{} from the text alone, {} with values that the author published elsewhere, {} under a "
      "reading or a value of ours; {} wrong or incomplete as printed and {} once corrected",
      counted(counts.from_text, "claim holds", "claims hold"), counts.with_author_values,
      counts.reproduced - counts.from_text - counts.with_author_values,
      counted(counts.with_erratum, "is", "are"), counts.with_erratum == 1 ? "holds" : "hold");
  if (counts.fitted > 0)
    text += fmt::format("; {} only with a parameter that was fitted",
                        counted(counts.fitted, "holds", "hold"));
  return text + fmt::format("; {} not reproduced.", counted(counts.refuted, "is", "are"));
}

std::string open_text(const ClaimCounts& counts) {
  std::string text = fmt::format(
      "{} inconclusive; {} cannot be decided by any run (not comparable, underspecified, or "
      "nothing "
      "to measure); {} for a model that is not built yet; {} not measured in this run.",
      counted(counts.inconclusive, "is", "are"), counts.undecidable,
      counted(counts.without_model, "waits", "wait"), counted(counts.not_seen, "was", "were"));
  if (counts.hidden > 0)
    text += fmt::format(" {} on times and {} left out of this version of the report.",
                        counted(counts.hidden, "claim rests", "claims rest"),
                        counts.hidden == 1 ? "is" : "are");
  return text;
}

std::string predicted_text(const ordered_json& predictions, const ClaimCounts& counts) {
  const auto same = predictions["same"].get<std::size_t>();
  const auto differ = predictions["differ"].get<std::size_t>();
  std::string text = "No verdict was predicted before building.";
  if (predictions["predicted"] != 0)
    text = fmt::format(
        "Verdicts were derived from the texts before anything was built. Of those that this run "
        "decided, {} as predicted and {} otherwise; {} a verdict that the text alone fixes.",
        counted(same, "was found", "were found"), differ,
        counted(predictions["fixed"].get<std::size_t>(), "more has", "more have"));
  text += fmt::format(
      " {} from what this version of the suite expects",
      counts.unexpected == 0 ? "None differs" : counted(counts.unexpected, "differs", "differ"));
  if (counts.contradicted > 0)
    text += fmt::format("; on {} the runs disagree", counted(counts.contradicted, "claim"));
  return text + ".";
}

/// One row of the counts; `belongs` says which judgements it counts.
template <class Belongs>
ordered_json counts_row(const JudgedRun& judged, const std::string& name, const std::string& look,
                        const Belongs& belongs) {
  std::size_t total = 0;
  std::map<std::string, std::size_t> by_basis, by_paper;
  for_each_judgement(judged, [&](const JudgedPaper& paper, const Judgement& judgement) {
    if (!belongs(judgement)) return;
    ++total;
    ++by_basis[judgement.claim->basis];
    ++by_paper[paper.paper.key];
  });
  ordered_json row{{"verdict", name}, {"class", look}, {"row", slug(name)}, {"total", total}};
  row["any"] = total > 0;
  row["by_basis"] = row["by_paper"] = ordered_json::array();
  for (const char* basis : bases) row["by_basis"].push_back({{"count", by_basis[basis]}});
  for (const JudgedPaper& paper : judged.papers)
    row["by_paper"].push_back({{"count", by_paper[paper.paper.key]}});
  return row;
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
  const bool timed = !without_varying && !judged.run.timings.empty();
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
      fmt::format("{}. {} of the claims had a measurement.",
                  comparison ? runs_text(*comparison) : run_text(judged.run, timed),
                  counts.measured),
      timed);
  add("Found", found_text(counts), varies);
  add("Open", open_text(counts), varies);
  add("Predicted", predicted_text(predictions, counts), varies);
  return lines;
}

ordered_json counts_document(const JudgedRun& judged, bool without_varying) {
  ordered_json rows = ordered_json::array();
  for (const VerdictRow& row : verdict_rows())
    rows.push_back(
        counts_row(judged, std::string(row.name), row_class(row), [&](const Judgement& judgement) {
          return shown_verdict(judgement, without_varying).label == row.name;
        }));
  if (counts_of(judged, without_varying).hidden > 0)
    rows.push_back(
        counts_row(judged, left_out_row, left_out_class, [&](const Judgement& judgement) {
          return shown_verdict(judgement, without_varying).hidden;
        }));
  ordered_json kinds = ordered_json::array(), works = ordered_json::array();
  for_each_judgement(judged, [&](const JudgedPaper&, const Judgement& judgement) {
    const std::string& kind = judgement.claim->kind;
    if (std::find(kinds.begin(), kinds.end(), kind) == kinds.end()) kinds.push_back(kind);
  });
  for (const JudgedPaper& paper : judged.papers)
    works.push_back(fmt::format("{} {}", paper.paper.author, paper.paper.year));
  return {{"bases", ordered_json(bases)}, {"kinds", kinds}, {"works", works}, {"rows", rows}};
}

}  // namespace phytobench
