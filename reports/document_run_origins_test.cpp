// SPDX-License-Identifier: MIT
#include "reports/document_run_origins.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

using nlohmann::ordered_json;
using testing::AllOf;
using testing::HasSubstr;
using testing::Not;

/// Two runs of one commit, of which nothing more is known but their compilers.
struct TwoOrigins {
  std::vector<ComparedRun> runs{{"GCC on X", {}}, {"Clang on X", {}}};
  std::vector<std::string> environments{R"({"compiler": "GNU 12", "commit": "abc"})",
                                        R"({"compiler": "Clang", "commit": "abc"})"};
  bool without_varying = false;

  void have_commits(const std::string& first, const std::string& second, bool changed = false) {
    environments = {
        R"({"commit": ")" + first + R"("})",
        R"({"commit": ")" + second + R"(", "source_changed": )" + (changed ? "true}" : "false}")};
  }
  ordered_json fact(const std::string& name) const {
    const ordered_json facts = run_facts({runs, environments, without_varying});
    for (const ordered_json& row : facts)
      if (row["name"] == name) return row;
    return {};
  }
  std::vector<std::string> warnings() const {
    std::vector<std::string> texts;
    const ordered_json rows = run_warnings({runs, environments, without_varying});
    for (const ordered_json& row : rows) texts.push_back(row["text"]);
    return texts;
  }
};

TEST(RunFacts, SayWhereRunsComeFromAndWhatOfItDiffers) {
  TwoOrigins two;
  EXPECT_EQ(two.fact("compiler")["cells"], (ordered_json{"GNU 12", "Clang"}));
  EXPECT_EQ(two.fact("compiler")["differs"], true);
  EXPECT_EQ(two.fact("processor")["shared"], "not recorded");
  EXPECT_EQ(two.fact("tier")["differs"], false);
  EXPECT_EQ(two.fact("tier")["shared"], "quick");
  EXPECT_EQ(two.fact("tier")["span"], 2);
  two.runs[1].contents.header = {Tier::full, 7};
  EXPECT_EQ(two.fact("tier")["differs"], true);
}

TEST(RunFacts, NameFoldersOnlyWhereTheyAreKnown) {
  TwoOrigins two;
  EXPECT_TRUE(two.fact("folder").is_null());
  two.runs[0].folder = "a";
  two.runs[1].folder = "b";
  EXPECT_EQ(two.fact("folder")["cells"], (ordered_json{"a", "b"}));
  two.without_varying = true;
  EXPECT_TRUE(two.fact("folder").is_null());
  EXPECT_TRUE(two.fact("compiler").is_null());
  EXPECT_FALSE(two.fact("seed").is_null());
}

TEST(RunWarnings, AreNoneForRunsOfOneKind) {
  TwoOrigins two;
  EXPECT_TRUE(two.warnings().empty());
  two.have_commits("abc", "abc");
  EXPECT_TRUE(two.warnings().empty());
}

TEST(RunWarnings, NameTheCommitsWhereTheyDiffer) {
  TwoOrigins two;
  two.have_commits("abc", "def", true);
  ASSERT_EQ(two.warnings().size(), 1u);
  EXPECT_THAT(two.warnings()[0],
              AllOf(HasSubstr("different commits"), HasSubstr("A: abc, B: def with changes")));
  two.without_varying = true;
  EXPECT_TRUE(two.warnings().empty());
}

TEST(RunWarnings, CompareNoCommitThatIsNotRecorded) {
  for (const char* without : {"{}", R"({"commit": null})", R"({"commit": "unknown"})"}) {
    TwoOrigins two;
    two.environments[0] = without;
    EXPECT_EQ(two.fact("commit")["cells"], (ordered_json{"not recorded", "abc"}));
    ASSERT_EQ(two.warnings().size(), 1u) << without;
    EXPECT_THAT(two.warnings()[0], HasSubstr("No commit is recorded for A: whether"));
    two.environments[1] = without;
    ASSERT_EQ(two.warnings().size(), 1u) << without;
    EXPECT_THAT(two.warnings()[0], HasSubstr("No commit is recorded for A and B: whether"));
    two.without_varying = true;
    EXPECT_TRUE(two.warnings().empty());
  }
}

TEST(RunWarnings, NameTheCommitsOfThoseThatHaveOne) {
  TwoOrigins three;
  three.runs.push_back({"Clang on Y", {}});
  three.environments = {"{}", R"({"commit": "abc"})", R"({"commit": "def"})"};
  ASSERT_EQ(three.warnings().size(), 2u);
  EXPECT_THAT(three.warnings()[0], HasSubstr("different commits (B: abc, C: def):"));
  EXPECT_THAT(three.warnings()[1], HasSubstr("recorded for A: "));
}

TEST(RunWarnings, TellOfChangesThatAnEqualCommitHides) {
  TwoOrigins two;
  two.have_commits("abc", "abc", true);
  ASSERT_EQ(two.warnings().size(), 1u);
  EXPECT_THAT(two.warnings()[0], AllOf(HasSubstr("in the source of B"),
                                       HasSubstr("although they name the same commit.")));
  two.environments[0] = "{}";
  ASSERT_EQ(two.warnings().size(), 2u);
  EXPECT_THAT(two.warnings()[0], AllOf(HasSubstr("in the source of B"), Not(HasSubstr("same"))));
}

TEST(RunWarnings, TellOfOtherTiersAndSeeds) {
  TwoOrigins two;
  two.runs[1].contents.header = {Tier::full, 7};
  ASSERT_EQ(two.warnings().size(), 2u);
  EXPECT_THAT(two.warnings()[0], HasSubstr("different tiers"));
  EXPECT_THAT(two.warnings()[1], HasSubstr("different seeds"));
}

TEST(RunWarnings, TellOfExperimentsThatARunLacks) {
  TwoOrigins two;
  two.runs[0].contents.complete_experiments = {"p/a", "p/b"};
  two.runs[1].contents.complete_experiments = {"p/b", "p/c", "p/d"};
  ASSERT_EQ(two.warnings().size(), 1u);
  EXPECT_THAT(two.warnings()[0],
              HasSubstr("of 4 experiments that any of them ran, A lacks 2 experiments, "
                        "B lacks 1 experiment"));
}

}  // namespace
}  // namespace phytobench
