// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/instruction_report.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/gate_junit.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;

JudgedInstructions judged(const std::string& name, std::uint64_t base, std::uint64_t other) {
  CountedPair pair{.benchmark = name};
  pair.base = {.outcome = CountOutcome::counted,
               .reason = "",
               .totals = {.instructions = base, .misses = CacheMisses{5, 6}},
               .inputs = "i",
               .answer = "o"};
  pair.other = pair.base;
  pair.other.totals.instructions = other;
  return judge_instructions(pair, {}, "0123456789ab");
}

InstructionReport some_report() {
  InstructionReport report;
  report.base = {.given = "HEAD~1", .kind = "revision", .commit = "0123456789ab"};
  report.other = {.given = "this build", .kind = "build"};
  report.judged = {judged("a/same", 1000000, 1000000), judged("b/<more>", 1000000, 1052000)};
  JudgedInstructions missing = judged("c/missing", 1, 1);
  missing.verdict = InstructionVerdict::unsupported;
  missing.reason = "valgrind is not installed";
  missing.change.reset();
  report.judged.push_back(missing);
  return report;
}

TEST(InstructionReport, SaysWhatMattersFirst) {
  const std::string table = instruction_table(some_report());
  EXPECT_THAT(table, HasSubstr("+5.20 %"));
  EXPECT_THAT(table, HasSubstr("1,052,000"));
  EXPECT_LT(table.find("b/<more>"), table.find("c/missing"));
  EXPECT_LT(table.find("c/missing"), table.find("a/same"));
  EXPECT_EQ(counts_in_words(some_report()), "1 more, 1 unsupported, 1 same of 3 benchmarks");
  EXPECT_EQ(counts_in_words(InstructionReport{}), "0 more of 0 benchmarks");
}

TEST(InstructionReport, SaysWhatASimulatedCacheMissed) {
  InstructionReport report = some_report();
  report.judged.front().pair.other.totals.misses = CacheMisses{1234567, 89};
  EXPECT_THAT(instruction_table(report),
              testing::ContainsRegex("\n +5 +6 +1,234,567 +89  a/same\n"));
  for (JudgedInstructions& one : report.judged)
    one.pair.base.totals.misses = one.pair.other.totals.misses = std::nullopt;
  EXPECT_THAT(instruction_table(report), Not(HasSubstr("cache")));
}

TEST(InstructionReport, ForTestRunnersOnlyARegressionFails) {
  const std::string xml = instruction_junit(some_report());
  EXPECT_THAT(xml, HasSubstr("tests=\"3\" failures=\"1\" errors=\"0\" skipped=\"1\""));
  EXPECT_THAT(xml, HasSubstr("name=\"b/&lt;more&gt;\""));
  EXPECT_THAT(xml, HasSubstr("<skipped message=\"unsupported: valgrind is not installed\"/>"));
}

TEST(InstructionReport, ThousandsOfBenchmarksStillFitIntoAComment) {
  InstructionReport report = some_report();
  for (int i = 0; i < 3000; ++i)
    report.judged.push_back(judged("z/```/" + std::to_string(i), 1000, 1000));
  const std::string markdown = instruction_markdown(report);
  EXPECT_LT(markdown.size(), 60000u);
  EXPECT_THAT(markdown, HasSubstr("more in the JSON document"));
  EXPECT_THAT(markdown, HasSubstr("b/<more>"));
  EXPECT_THAT(markdown.substr(markdown.find("```text") + 7), Not(HasSubstr("z/```")));
}

TEST(InstructionReport, TheDocumentHoldsBothCounts) {
  const auto json = nlohmann::json::parse(instruction_json(some_report()));
  EXPECT_EQ(json["schema"], "phytobench/instructions-1");
  EXPECT_EQ(json["base"]["commit"], "0123456789ab");
  EXPECT_EQ(json["benchmarks"][1]["verdict"], "more");
  EXPECT_EQ(json["benchmarks"][1]["new"]["instructions"], 1052000);
  EXPECT_EQ(json["benchmarks"][1]["new"]["last_level_misses"], 6);
  EXPECT_TRUE(json["benchmarks"][2]["change"].is_null());
}

TEST(GateJunit, NamesItsSuiteAfterTheCommand) {
  EXPECT_THAT(gate_junit("compare", {}), HasSubstr("<testsuite name=\"phytobench compare\""));
  EXPECT_THAT(gate_junit("bench counters", {}),
              HasSubstr("<testsuite name=\"phytobench bench counters\""));
  EXPECT_THAT(instruction_junit(some_report()),
              HasSubstr("<testsuite name=\"phytobench bench instructions\""));
}

TEST(GateJunit, WritesOutWhatXmlReserves) {
  const std::string xml = gate_junit(
      "bench counters",
      {{"a.b/<c>", GateOutcome::failed, "1 & \x01 2"}, {"d/e", GateOutcome::passed, ""}});
  EXPECT_THAT(xml, HasSubstr("classname=\"counters.a_b\" name=\"a.b/&lt;c&gt;\""));
  EXPECT_THAT(xml, HasSubstr("<failure message=\"1 &amp;   2\">"));
  EXPECT_THAT(xml, HasSubstr("tests=\"2\" failures=\"1\""));
}

}  // namespace
}  // namespace phytobench
