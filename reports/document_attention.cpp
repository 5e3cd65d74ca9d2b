// SPDX-License-Identifier: MIT
#include "reports/document_attention.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_claims.hpp"
#include "reports/document_numbers.hpp"
#include "reports/document_summary.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

struct Group {
  const char* title;
  const char* anchor;
  bool (*holds)(const Judgement&);
};

constexpr Group groups[] = {
    {"Not reproduced", "not-reproduced",
     [](const Judgement& j) { return j.verdict == Verdict::not_reproduced; }},
    {"Inconclusive", "inconclusive",
     [](const Judgement& j) { return j.verdict == Verdict::inconclusive; }},
    {"Other than this suite expects", "unexpected",
     [](const Judgement& j) { return j.is_unexpected() && j.verdict != Verdict::not_reproduced; }},
};

ordered_json claim_part(const Paper& paper, const Judgement& judgement, bool without_varying) {
  ordered_json claim = claim_brief(judgement, without_varying);
  claim["work"] = fmt::format("{} {}", paper.author, paper.year);
  claim["problems"] = claim_problems(judgement);
  claim["has_problems"] = !claim["problems"].empty();
  return claim;
}

}  // namespace

ordered_json attention_document(const JudgedRun& judged, bool without_varying) {
  ordered_json parts = ordered_json::array();
  for (const Group& group : groups) {
    ordered_json claims = ordered_json::array();
    for (const JudgedPaper& paper : judged.papers)
      for (const Judgement& judgement : paper.judgements)
        if (group.holds(judgement) && !shown_verdict(judgement, without_varying).hidden)
          claims.push_back(claim_part(paper.paper, judgement, without_varying));
    if (claims.empty()) continue;
    parts.push_back({{"title", group.title},
                     {"anchor", group.anchor},
                     {"claim_count", claims.size()},
                     {"claims", std::move(claims)}});
  }
  return parts;
}

ordered_json limits_document(const JudgedRun& judged, bool without_varying) {
  const ClaimCounts counts = counts_of(judged, without_varying);
  ordered_json limits = ordered_json::array();
  if (counts.not_seen > 0)
    limits.push_back(fmt::format(
        "{} checks that this run did not feed: it is of tier {}, or leaves experiments out.",
        counted(counts.not_seen, "claim has", "claims have"), name_of(judged.run.header.tier)));
  for (const char* limit :
       {"Absolute seconds of another machine, compiler and language are never compared; ratios, "
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
        "laws and counter-examples guard it, but nobody else has reviewed these verdicts."})
    limits.push_back(limit);
  return limits;
}

}  // namespace phytobench
