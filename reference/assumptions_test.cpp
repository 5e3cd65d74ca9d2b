// SPDX-License-Identifier: MIT
#include "reference/assumptions.hpp"

#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reference/claims.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

/// One line for each claim that an assumption names in vain, and for each claim that is said to be
/// assumed or fitted while no assumption says what.
std::string objections(const std::vector<Assumption>& assumptions,
                       const std::vector<Claim>& claims) {
  std::set<std::string> known, named;
  for (const Claim& claim : claims) known.insert(claim.id);
  std::string found;
  for (const Assumption& assumption : assumptions)
    for (const std::string& claim : assumption.claims) {
      if (!known.contains(claim)) found += "\n  " + assumption.id + ": no claim " + claim;
      if (!named.insert(assumption.id + " " + claim).second)
        found += "\n  " + assumption.id + " names twice " + claim;
      named.insert(claim);
    }
  for (const Claim& claim : claims)
    if ((claim.basis == "assumed" || claim.basis == "fitted") && !named.contains(claim.id))
      found += "\n  " + claim.basis + ", but no assumption names it: " + claim.id;
  return found;
}

TEST(Assumptions, SayWhatIsOpenWhatIsTakenAndWhatElseThereIs) {
  for (const std::string& paper : paper_keys()) {
    const std::vector<Assumption> assumptions = load_assumptions(paper);
    EXPECT_FALSE(assumptions.empty()) << paper;
    std::set<std::string> ids;
    for (const Assumption& assumption : assumptions) {
      SCOPED_TRACE(paper + " " + assumption.id);
      EXPECT_TRUE(ids.insert(assumption.id).second);
      EXPECT_FALSE(assumption.locator.empty());
      EXPECT_FALSE(assumption.question.empty());
      EXPECT_FALSE(assumption.reading.empty());
      EXPECT_FALSE(assumption.alternatives.empty());
    }
  }
}

TEST(Assumptions, NameTheClaimsThatRestOnThem) {
  for (const std::string& paper : paper_keys()) {
    const std::string found = objections(load_assumptions(paper), load_claims(paper).claims);
    EXPECT_TRUE(found.empty()) << paper << found;
  }
}

TEST(Assumptions, AGapIsNoticed) {
  const Assumption assumption{.id = "A1", .claims = {"p/a"}};
  Claim assumed;
  assumed.id = "p/a";
  assumed.basis = "assumed";
  Claim plain = assumed;
  plain.id = "p/b";
  plain.basis = "paper";
  EXPECT_EQ(objections({assumption}, {assumed, plain}), "");
  EXPECT_NE(objections({assumption}, {plain}), "") << "there is no such claim";
  EXPECT_NE(objections({}, {assumed}), "") << "nobody says what is assumed";
  Claim fitted = assumed;
  fitted.basis = "fitted";
  EXPECT_NE(objections({}, {fitted}), "") << "nobody says what is fitted";
  EXPECT_NE(objections({Assumption{.id = "A1", .claims = {"p/a", "p/a"}}}, {assumed}), "");
}

}  // namespace
}  // namespace phytobench
