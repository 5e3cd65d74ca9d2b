// SPDX-License-Identifier: MIT
#include "reports/document_places_known.hpp"

#include <unistd.h>

#include <algorithm>
#include <filesystem>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "reference/claims.hpp"
#include "reference/papers.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

/// A file of its own for each test: they run beside each other.
class KnownPlaces : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    file_ = fs::path(testing::TempDir()) / (std::string("phytobench-known-places-") + test->name() +
                                            "-" + std::to_string(::getpid()) + ".toml");
  }
  void TearDown() override { fs::remove(file_); }

  std::vector<KnownPlace> from(const std::string& text) const {
    write_file_atomically(file_, text);
    return known_places_of(file_.string());
  }

  fs::path file_;
};

TEST_F(KnownPlaces, HaveTheirPagesAndTheirSection) {
  const auto known = from("[figure]\n\"10\" = [\"7\", \"2.1\"]\n\"9\" = [\"6-7\", \"2\"]\n");
  ASSERT_EQ(known.size(), 2u);
  EXPECT_EQ(shown(known[0].place), "Figure 9") << "in the order of the work";
  EXPECT_EQ(shown_pages(known[0]), "p. 6-7");
  EXPECT_EQ(shown_pages(known[1]), "p. 7");
  EXPECT_EQ(known[1].section, "2.1");
}

TEST_F(KnownPlaces, OfSectionsAreInTheSectionAbove) {
  const auto known = from("[section]\n\"3\" = [\"6-7\"]\n\"3.1.2\" = [\"7\"]\n");
  EXPECT_EQ(known[0].section, "");
  EXPECT_EQ(known[1].section, "3.1");
}

TEST_F(KnownPlaces, MustHavePages) {
  for (const char* pages : {"", "x", "7-", "7-6", "0", "7-8-9", "-7", "7 "})
    EXPECT_THROW(from(std::string("[section]\n\"3\" = [\"") + pages + "\"]\n"), InputError)
        << pages;
  EXPECT_THROW(from("[figure]\n\"3\" = [\"7\"]\n"), InputError) << "no section";
  EXPECT_THROW(from("[plate]\n\"3\" = [\"7\", \"1\"]\n"), InputError) << "unknown kind";
}

/// A locator that names a place that does not exist is a misprint of ours, or misread.
TEST_F(KnownPlaces, HoldEveryPlaceThatClaimsName) {
  for (const std::string& paper : paper_keys()) {
    const auto known = known_places(paper);
    ASSERT_FALSE(known.empty()) << paper;
    for (const Claim& claim : load_claims(paper).claims)
      for (const Place& place : places_of(claim.locator))
        EXPECT_TRUE(search_token(place).empty() ||
                    std::any_of(known.begin(), known.end(),
                                [&](const KnownPlace& each) { return each.place == place; }))
            << claim.id << ": " << claim.locator;
  }
}

/// Numbers of figures and equations have no gaps, and all stand in a section on its pages.
TEST_F(KnownPlaces, AreComplete) {
  for (const std::string& paper : paper_keys()) {
    const auto known = known_places(paper);
    const auto find = [&](const Place& place) {
      return std::find_if(known.begin(), known.end(),
                          [&](const KnownPlace& each) { return each.place == place; });
    };
    for (const KnownPlace& each : known) {
      SCOPED_TRACE(paper + ", " + shown(each.place));
      const std::size_t dot = each.place.number.rfind('.') + 1;
      const std::string before = each.place.number.substr(0, dot);
      const int last = std::atoi(each.place.number.c_str() + dot);
      if (last > 1)
        EXPECT_NE(find({each.place.kind, before + std::to_string(last - 1)}), known.end());
      if (each.section.empty()) continue;
      const auto section = find({PlaceKind::section, each.section});
      ASSERT_NE(section, known.end()) << each.section;
      EXPECT_LE(section->first_page, each.first_page);
      EXPECT_GE(section->last_page, each.last_page);
    }
  }
}

}  // namespace
}  // namespace phytobench
