// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/comparison_junit.hpp"

#include <map>
#include <string>

#include <gtest/gtest.h>

#include "benchmarks/comparison/example_report.hpp"
#include "core/contract/xml_fixture.hpp"

namespace phytobench {
namespace {

using namespace xml_fixture;

/// By the names of test cases, the first element within: failure, skipped or system-out.
std::map<std::string, std::string> outcomes(const xmlNode* node) {
  std::map<std::string, std::string> found;
  for (const xmlNode* child : children(node)) {
    found.merge(outcomes(child));
    if (name_of(child) != "testcase") continue;
    const auto within = children(child);
    found[attribute(child, "name")] = within.empty() ? "" : name_of(within.front());
  }
  return found;
}

TEST(ComparisonJunit, FailsWhatIsSlowerWrongOrNotMeasured) {
  const Document document = parsed(comparison_junit(example_report()));
  ASSERT_TRUE(document);
  const xmlNode* root = xmlDocGetRootElement(document.get());
  EXPECT_EQ(attribute(root, "tests"), "6");
  EXPECT_EQ(attribute(root, "failures"), "3");
  EXPECT_EQ(attribute(root, "skipped"), "1");
  const auto found = outcomes(root);
  ASSERT_EQ(found.size(), 6u);
  for (const char* name : {"engine/slower", "engine/wrong", "engine/absent"})
    EXPECT_EQ(found.at(name), "failure") << name;
  EXPECT_EQ(found.at("engine/noisy"), "skipped");
  EXPECT_NE(found.at("engine/same"), "failure");
  EXPECT_NE(found.at("engine/faster"), "failure");
}

TEST(ComparisonJunit, FailsWhatFailedItsTrial) {
  ComparisonReport report;
  report.failed_trials = {{"new", "b.so", "crashed", "SIGSEGV in associate() in iteration 2"}};
  const std::string xml = comparison_junit(report);
  const Document document = parsed(xml);
  ASSERT_TRUE(document);
  const xmlNode* root = xmlDocGetRootElement(document.get());
  EXPECT_EQ(attribute(root, "failures"), "1");
  EXPECT_EQ(outcomes(root).at("plugin trial of new"), "failure");
  EXPECT_NE(xml.find("SIGSEGV in associate() in iteration 2"), std::string::npos);
}

TEST(ComparisonJunit, IsWellFormedWhateverTheReason) {
  ComparisonReport report = example_report();
  for (ConcludedBenchmark& concluded : report.concluded)
    concluded.reason = "a < b && \"c\" ]]> \x01\n";
  EXPECT_TRUE(parsed(comparison_junit(report)));
  EXPECT_FALSE(parsed("<a>" + comparison_junit(report))) << "the parser sees faults";
}

}  // namespace
}  // namespace phytobench
