// SPDX-License-Identifier: MIT
// What every claim of the real papers must say, and may not.
#include <map>
#include <set>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "reference/claims.hpp"
#include "reference/data_folder.hpp"
#include "reference/errata.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

using testing::StartsWith;

TEST(PaperClaims, LoadForEveryPaper) {
  ASSERT_FALSE(paper_keys().empty());
  for (const std::string& paper : paper_keys())
    EXPECT_FALSE(load_claims(paper).claims.empty()) << paper;
}

TEST(PaperClaims, HaveUniqueIdsAndSayWhatTheyAreJudgedBy) {
  std::set<std::string> ids;
  for (const std::string& paper : paper_keys()) {
    for (const Claim& claim : load_claims(paper).claims) {
      SCOPED_TRACE(claim.id);
      EXPECT_TRUE(ids.insert(claim.id).second);
      EXPECT_EQ(claim.paper, paper);
      EXPECT_FALSE(claim.locator.empty());
      EXPECT_FALSE(claim.text.empty());
      EXPECT_FALSE(claim.published.empty());
      EXPECT_FALSE(claim.reason.empty());
      EXPECT_NE(claim.checks.empty(), !claim.fixed_verdict.has_value());
      EXPECT_TRUE(claim.predicted_verdict.has_value());
    }
  }
}

TEST(PaperClaims, ThatNeedAnErratumNameOneThatListsThem) {
  for (const std::string& paper : paper_keys()) {
    std::map<std::string, std::vector<std::string>> listed;
    for (const Erratum& erratum : load_errata(paper)) listed[erratum.id] = erratum.claims;
    for (const Claim& claim : load_claims(paper).claims) {
      SCOPED_TRACE(claim.id);
      EXPECT_EQ(!claim.erratum.empty(), claim.expected_verdict == Verdict::reproduced_with_erratum);
      if (claim.erratum.empty()) continue;
      ASSERT_TRUE(listed.contains(claim.erratum)) << claim.erratum;
      EXPECT_THAT(listed[claim.erratum], testing::Contains(claim.id));
    }
  }
}

TEST(PaperClaims, ListedByAnErratumExist) {
  for (const std::string& paper : paper_keys()) {
    std::set<std::string> ids;
    for (const Claim& claim : load_claims(paper).claims) ids.insert(claim.id);
    for (const Erratum& erratum : load_errata(paper))
      for (const std::string& claim : erratum.claims)
        EXPECT_TRUE(ids.contains(claim)) << erratum.id << " lists " << claim;
  }
}

TEST(PaperClaims, MeasureOnlyTheirOwnPaperAndLeaveRoomBetweenBounds) {
  for (const std::string& paper : paper_keys()) {
    for (const Claim& claim : load_claims(paper).claims) {
      for (const ClaimCheck& check : claim.checks) {
        SCOPED_TRACE(claim.id);
        if (check.low && check.high) {
          EXPECT_LE(*check.low, *check.high);
        }
        for (const auto& term : check.terms) {
          for (const std::string& part : term) {
            const bool is_signed = part.starts_with('+') || part.starts_with('-');
            EXPECT_EQ(is_signed, check.subject == CheckSubject::sum) << part;
            EXPECT_THAT(part.substr(is_signed ? 1 : 0), StartsWith(paper + "/"));
          }
        }
      }
    }
  }
}

TEST(PaperClaims, ExpectWhatTheirKindOfJudgementCanGive) {
  const std::set<Verdict> judged = {Verdict::reproduced, Verdict::reproduced_with_erratum,
                                    Verdict::not_reproduced, Verdict::inconclusive};
  for (const std::string& paper : paper_keys())
    for (const Claim& claim : load_claims(paper).claims) {
      SCOPED_TRACE(claim.id);
      if (claim.fixed_verdict)
        EXPECT_EQ(claim.expected_verdict, *claim.fixed_verdict);
      else
        EXPECT_TRUE(judged.contains(claim.expected_verdict));
      EXPECT_NE(claim.predicted_verdict, Verdict::inconclusive) << "noise cannot be predicted";
      if (!claim.missing_model.empty())
        EXPECT_THAT(claim.reason, StartsWith("model not built yet"));
    }
}

/// Claims with the same words are one claim; a reason that serves two topics serves neither.
TEST(PaperClaims, AreSaidOnceAndReasonedByTopic) {
  for (const std::string& paper : paper_keys()) {
    std::map<std::string, std::string> said, reasoned;
    for (const Claim& claim : load_claims(paper).claims) {
      const auto [text, is_new] = said.emplace(claim.text, claim.id);
      EXPECT_TRUE(is_new) << claim.id << " says what " << text->second << " says";
      const auto [reason, is_first] = reasoned.emplace(claim.reason, claim.topic);
      EXPECT_EQ(reason->second, claim.topic) << claim.id << " has the reason of another topic";
    }
  }
}

TEST(PaperClaims, StandInFilesWithATopicAndAPlaceOfTheirOwn) {
  for (const std::string& paper : paper_keys()) {
    std::set<double> places;
    for (const auto& file : paper_files(paper, "claims")) {
      const PaperClaims part = load_claims_file(file.string(), paper);
      EXPECT_TRUE(places.insert(part.order).second) << file << " has the order of another file";
      for (const Claim& claim : part.claims) EXPECT_FALSE(claim.topic.empty()) << claim.id;
    }
  }
}

TEST(PublishedTables, NameOneMeasurementPerCell) {
  for (const std::string& paper : paper_keys()) {
    std::set<std::string> ids;
    for (const PublishedTable& table : load_claims(paper).tables) {
      SCOPED_TRACE(table.id);
      EXPECT_TRUE(ids.insert(table.id).second);
      std::set<std::string> cells;
      for (std::size_t row = 0; row < table.rows.size(); ++row) {
        for (std::size_t column = 0; column < table.columns.size(); ++column) {
          const std::string cell = table.measurement_at(row, column);
          EXPECT_TRUE(cells.insert(cell).second) << cell;
          EXPECT_EQ(cell.find_first_of("{}"), std::string::npos) << cell;
        }
      }
      EXPECT_EQ(cells.size(), table.rows.size() * table.columns.size());
    }
  }
}

}  // namespace
}  // namespace phytobench
