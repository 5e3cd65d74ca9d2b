// SPDX-License-Identifier: MIT
#include "reports/junit_xml.hpp"

#include <map>
#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/xml_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

using namespace xml_fixture;

std::map<std::string, std::string> properties_of(const xmlNode* test) {
  std::map<std::string, std::string> properties;
  for (const xmlNode* list : children(test, "properties"))
    for (const xmlNode* property : children(list, "property"))
      properties[attribute(property, "name")] = attribute(property, "value");
  return properties;
}

/// A claim for each way a case can end.
struct EveryVerdict {
  std::vector<Claim> claims;
  JudgedRun judged;

  EveryVerdict() {
    const std::vector<std::tuple<std::string, Verdict, Verdict>> cases = {
        {"holds", Verdict::reproduced, Verdict::reproduced},
        {"refuted-as-expected", Verdict::not_reproduced, Verdict::not_reproduced},
        {"refuted", Verdict::not_reproduced, Verdict::reproduced},
        {"noise", Verdict::inconclusive, Verdict::reproduced},
        {"open", Verdict::underspecified, Verdict::underspecified},
        {"seconds", Verdict::not_comparable, Verdict::not_comparable},
        {"absent", Verdict::not_measured, Verdict::reproduced}};
    judged.papers.resize(1);
    JudgedPaper& paper = judged.papers[0];
    paper.paper.key = "p";
    for (const auto& [name, verdict, expected] : cases) {
      Claim claim;
      claim.id = "p/" + name;
      claim.paper = "p";
      claim.topic = "Trees & <leaves>. \"Growth\"";
      claim.text = "a < b && \"c\" ]]>";
      claim.basis = "paper";
      claim.expected_verdict = expected;
      paper.claims.claims.push_back(claim);
    }
    for (std::size_t i = 0; i < cases.size(); ++i)
      paper.judgements.push_back({.claim = &paper.claims.claims[i],
                                  .verdict = std::get<1>(cases[i]),
                                  .measured = "5 \x01 < 6",
                                  .reason = "two\nlines & \"more\"",
                                  .checks = {},
                                  .varies = false});
  }
};

/// The one suite of a document.
const xmlNode* suite_of(const Document& document) {
  const auto suites = children(xmlDocGetRootElement(document.get()), "testsuite");
  return suites.size() == 1 ? suites.front() : nullptr;
}

TEST(JunitXml, FailsOnlyWhatIsUnexpectedAndSkipsWhatIsNotDecided) {
  const Document document = parsed(junit_xml(EveryVerdict().judged, false));
  ASSERT_NE(document, nullptr);
  const xmlNode* suite = suite_of(document);
  ASSERT_NE(suite, nullptr);
  std::map<std::string, std::string> ends;
  for (const xmlNode* test : children(suite, "testcase"))
    ends[attribute(test, "name")] = !children(test, "failure").empty()   ? "failed"
                                    : !children(test, "skipped").empty() ? "skipped"
                                                                         : "passed";
  EXPECT_EQ(ends, (std::map<std::string, std::string>{{"holds", "passed"},
                                                      {"refuted-as-expected", "passed"},
                                                      {"refuted", "failed"},
                                                      {"noise", "skipped"},
                                                      {"open", "skipped"},
                                                      {"seconds", "skipped"},
                                                      {"absent", "skipped"}}));
  EXPECT_EQ(attribute(suite, "tests"), "7");
  EXPECT_EQ(attribute(suite, "failures"), "1");
  EXPECT_EQ(attribute(suite, "skipped"), "4");
}

TEST(JunitXml, SaysVerdictBasisAndExpectationOfEachClaim) {
  const Document document = parsed(junit_xml(EveryVerdict().judged, false));
  ASSERT_NE(document, nullptr);
  const xmlNode* refuted = children(suite_of(document), "testcase").at(2);
  EXPECT_EQ(attribute(refuted, "classname"), "p.Trees-leaves-Growth");
  const auto properties = properties_of(refuted);
  EXPECT_EQ(properties.at("verdict"), "not reproduced");
  EXPECT_EQ(properties.at("basis"), "paper");
  EXPECT_EQ(properties.at("expected"), "reproduced");
  EXPECT_EQ(properties.at("measured"), "5 ? < 6");
  EXPECT_EQ(attribute(children(refuted, "failure").at(0), "message"),
            "not reproduced, expected reproduced");
}

TEST(JunitXml, SaysWithoutAFailureWhereAVerdictDependsOnTheMachine) {
  EveryVerdict run;
  run.judged.papers[0].claims.claims[2].machine_dependence = "below 2 < there";
  run.judged.papers[0].judgements[2].varies = true;
  const Document document = parsed(junit_xml(run.judged, false));
  ASSERT_NE(document, nullptr);
  EXPECT_EQ(attribute(suite_of(document), "failures"), "0");
  const xmlNode* refuted = children(suite_of(document), "testcase").at(2);
  EXPECT_EQ(properties_of(refuted).at("expectation"), "depends on the machine");
  ASSERT_EQ(children(refuted, "system-out").size(), 1u);
  EXPECT_THAT(
      junit_xml(run.judged, false),
      HasSubstr("not reproduced, expected reproduced; depends on the machine: below 2 &lt;"));
  EXPECT_THAT(junit_xml(run.judged, true), testing::Not(HasSubstr("system-out"))) << "hidden";
}

TEST(JunitXml, KeepsLinesOfAMessageApart) {
  const Document document = parsed(junit_xml(EveryVerdict().judged, false));
  ASSERT_NE(document, nullptr);
  const xmlNode* noise = children(suite_of(document), "testcase").at(3);
  EXPECT_EQ(attribute(children(noise, "skipped").at(0), "message"),
            "inconclusive: two\nlines & \"more\"");
}

TEST(JunitXml, NamesTheRunsByTheirLettersInEachSuite) {
  const EveryVerdict run;
  RunComparison comparison;
  comparison.runs = {{"GCC 12 on <X>", {}}, {"Clang on X", {}}};
  const Document document = parsed(junit_xml(run.judged, false, &comparison));
  ASSERT_NE(document, nullptr);
  EXPECT_EQ(
      properties_of(suite_of(document)),
      (std::map<std::string, std::string>{{"run A", "GCC 12 on <X>"}, {"run B", "Clang on X"}}));
  const Document alone = parsed(junit_xml(run.judged, false));
  ASSERT_NE(alone, nullptr);
  EXPECT_TRUE(children(suite_of(alone), "properties").empty());
}

TEST(JunitXml, SkipsWhatRestsOnTimesOnRequest) {
  EveryVerdict run;
  run.judged.papers[0].judgements[2].varies = true;
  const std::string xml = junit_xml(run.judged, true);
  EXPECT_THAT(xml, HasSubstr("failures=\"0\""));
  const Document document = parsed(xml);
  ASSERT_NE(document, nullptr);
  const xmlNode* refuted = children(suite_of(document), "testcase").at(2);
  EXPECT_EQ(children(refuted, "skipped").size(), 1u);
  EXPECT_FALSE(properties_of(refuted).contains("verdict"));
  EXPECT_FALSE(properties_of(refuted).contains("measured"));
}

TEST(JunitXmlLaw, HoldsEveryClaimOfEveryWork) {
  RunContents nothing;
  nothing.header = {Tier::smoke, 0};
  const JudgedRun judged = judge_run(std::move(nothing));
  const Document document = parsed(junit_xml(judged, false));
  ASSERT_NE(document, nullptr);
  const auto suites = children(xmlDocGetRootElement(document.get()), "testsuite");
  ASSERT_EQ(suites.size(), judged.papers.size());
  for (std::size_t i = 0; i < suites.size(); ++i) {
    const auto tests = children(suites[i], "testcase");
    EXPECT_EQ(tests.size(), judged.papers[i].judgements.size());
    EXPECT_EQ(attribute(suites[i], "tests"), std::to_string(tests.size()));
  }
}

}  // namespace
}  // namespace phytobench
