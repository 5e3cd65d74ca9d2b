// SPDX-License-Identifier: MIT
#include "reports/document_attention.hpp"

#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "reports/document_claims.hpp"
#include "reports/expectation.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

struct Group {
  const char* title;
  const char* anchor;
  bool (*holds)(const Judgement&);
};

/// What failed or is inconclusive first; each claim once.
constexpr Group attention_groups[] = {
    {"Not reproduced", "not-reproduced",
     [](const Judgement& j) { return j.verdict == Verdict::not_reproduced; }},
    {"Inconclusive", "inconclusive",
     [](const Judgement& j) { return j.verdict == Verdict::inconclusive; }},
    {"Other than this suite expects", "unexpected",
     [](const Judgement& j) { return j.is_unexpected() && j.verdict != Verdict::not_reproduced; }},
    {"Expected otherwise, but known to depend on the machine", "by-machine",
     [](const Judgement& j) {
       return expectation_of(j) == Expectation::depends_on_machine &&
              j.verdict != Verdict::not_reproduced;
     }},
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
  for (const Group& group : attention_groups) {
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

}  // namespace phytobench
