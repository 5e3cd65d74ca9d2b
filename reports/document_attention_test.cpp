// SPDX-License-Identifier: MIT
#include "reports/document_attention.hpp"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

/// A claim for each group, and one that is as expected. All but the last are expected to hold.
struct EveryGroup {
  std::vector<Claim> claims;
  JudgedRun judged;

  EveryGroup() : claims(6) {
    const Verdict found[] = {Verdict::reproduced,   Verdict::reproduced_with_erratum,
                             Verdict::inconclusive, Verdict::not_reproduced,
                             Verdict::reproduced,   Verdict::not_reproduced};
    judged.papers.resize(1);
    for (std::size_t i = 0; i < claims.size(); ++i) {
      claims[i].id = "b/" + std::to_string(i);
      judged.papers[0].judgements.push_back({.claim = &claims[i], .verdict = found[i]});
    }
    claims[4].expected_verdict = Verdict::not_reproduced;  // here it holds
    for (const std::size_t timed : {4u, 5u}) {
      claims[timed].machine_dependence = "otherwise there";
      judged.papers[0].judgements[timed].varies = true;
    }
  }
};

std::vector<std::string> groups_of(const nlohmann::ordered_json& document) {
  std::vector<std::string> groups;
  for (const auto& group : document) {
    groups.push_back(group["anchor"].get<std::string>() + ":");
    for (const auto& claim : group["claims"]) groups.back() += " " + claim["id"].get<std::string>();
  }
  return groups;
}

TEST(Attention, NamesEachClaimOnceAndFailuresFirst) {
  EXPECT_EQ(groups_of(attention_document(EveryGroup().judged, false)),
            (std::vector<std::string>{"not-reproduced: b/3 b/5", "inconclusive: b/2",
                                      "unexpected: b/1", "by-machine: b/4"}));
}

TEST(Attention, MarksFailuresThatDependOnTheMachine) {
  const auto failures = attention_document(EveryGroup().judged, false)[0]["claims"];
  EXPECT_EQ(failures[0]["unexpected"], true);
  EXPECT_EQ(failures[0]["by_machine"], false);
  EXPECT_EQ(failures[1]["unexpected"], false);
  EXPECT_EQ(failures[1]["by_machine"], true);
}

TEST(Attention, TellsNothingOfWhatIsHidden) {
  EXPECT_EQ(
      groups_of(attention_document(EveryGroup().judged, true)),
      (std::vector<std::string>{"not-reproduced: b/3", "inconclusive: b/2", "unexpected: b/1"}));
}

}  // namespace
}  // namespace phytobench
