// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_markdown.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/example_report.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

TEST(ComparisonMarkdown, GoesFromTheSummaryToTheFacts) {
  const std::string text = comparison_markdown(example_report());
  EXPECT_THAT(text, StartsWith("**phytobench compare: 1 wrong answer, 1 slower"));
  std::size_t last = 0;
  for (const char* part : {"base: HEAD", "### What changed", "- **wrong answer** engine/wrong",
                           "- **slower** engine/slower", "### Time of new over base", "```text",
                           "<details>", "</details>", "Timed for 90 s"}) {
    const std::size_t place = text.find(part);
    ASSERT_NE(place, std::string::npos) << part << "\n" << text;
    EXPECT_GT(place + 1, last) << part;
    last = place;
  }
}

TEST(ComparisonMarkdown, NamesOnlyWhatChangedAsChanged) {
  const std::string text = comparison_markdown(example_report());
  const std::string changed =
      text.substr(text.find("### What"), text.find("### Time") - text.find("### What"));
  EXPECT_THAT(changed, HasSubstr("engine/faster"));
  EXPECT_THAT(changed, HasSubstr("engine/absent"));
  EXPECT_THAT(changed, Not(HasSubstr("engine/same")));
  EXPECT_THAT(changed, Not(HasSubstr("engine/noisy")));
  ComparisonReport quiet;
  add_example(quiet, "a", SpeedVerdict::same, 1.0);
  EXPECT_THAT(comparison_markdown(quiet), Not(HasSubstr("What changed")));
}

TEST(ComparisonMarkdown, SaysWhichTrialFailedAtWhichStep) {
  ComparisonReport report;
  report.failed_trials = {{"new", "b.so", "crashed", "SIGSEGV in associate() in iteration 2"}};
  const std::string text = comparison_markdown(report);
  EXPECT_THAT(text, StartsWith("**phytobench compare: new failed its trial"));
  EXPECT_THAT(text, HasSubstr("- new, b.so: crashed in its trial: SIGSEGV in associate() in "));
  EXPECT_THAT(text, Not(HasSubstr("benchmarks")));
  EXPECT_THAT(comparison_markdown(example_report()), Not(HasSubstr("Failed trials")));
}

TEST(ComparisonMarkdown, StaysBelowTheLimitOfACommentAndCountsWhatIsLeftOut) {
  ComparisonReport report;
  const std::string nasty(400, '<');
  for (int i = 0; i < 500; ++i)
    add_example(report, nasty + std::to_string(i), SpeedVerdict::slower, 1.1);
  for (ConcludedBenchmark& concluded : report.concluded) concluded.reason = nasty;
  report.notes = std::vector<std::string>(500, nasty);
  report.timing.measured.base.given = report.timing.measured.other.given = std::string(5000, '@');
  report.timing.measured.base.flags = std::string(5000, '<');
  report.timing.measured.other.flags = std::string(5000, '>');
  const std::string text = comparison_markdown(report);
  EXPECT_LE(text.size(), most_markdown_bytes);
  EXPECT_THAT(text, HasSubstr("more in the JSON document"));
  EXPECT_THAT(text, Not(HasSubstr("@")));
}

TEST(ComparisonMarkdown, FiveHundredOrdinaryBenchmarksFillMostOfIt) {
  ComparisonReport report;
  for (int i = 0; i < 500; ++i)
    add_example(report, "family/engine/option-" + std::to_string(i), SpeedVerdict::same, 1.0);
  const std::string text = comparison_markdown(report);
  EXPECT_LE(text.size(), most_markdown_bytes);
  EXPECT_THAT(text, HasSubstr("family/engine/option-100\n"));
}

}  // namespace
}  // namespace phytobench
