// SPDX-License-Identifier: MIT
#include "reports/run_labels.hpp"

#include <string>
#include <vector>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

namespace phytobench {
namespace {

using testing::ElementsAre;

RunOrigin origin(const std::string& compiler, const std::string& processor,
                 const std::string& folder) {
  return {
      R"({"compiler": ")" + compiler + R"(", "machine": {"processor": ")" + processor + R"("}})",
      folder};
}

std::vector<std::string> labels(const std::vector<RunOrigin>& runs) {
  return run_labels(runs);
}

TEST(RunLabels, AreCompilerAndProcessorWhereTheseDiffer) {
  EXPECT_THAT(labels({origin("GNU 12.2.0", "X", "a"), origin("Clang 14.0.6", "X", "b"),
                      origin("GNU 12.2.0", "Y", "c")}),
              ElementsAre("GCC 12.2.0 on X", "Clang 14.0.6 on X", "GCC 12.2.0 on Y"));
}

TEST(RunLabels, NameTheFolderWhereTheseAreEqual) {
  EXPECT_THAT(labels({origin("GNU 12.2.0", "X", "results/a/"), origin("GNU 12.2.0", "X", "b/."),
                      origin("Clang 14.0.6", "X", "c")}),
              ElementsAre("GCC 12.2.0 on X (a)", "GCC 12.2.0 on X (b)", "Clang 14.0.6 on X"));
}

TEST(RunLabels, NameTheWholePathWhereFoldersAreCalledTheSame) {
  EXPECT_THAT(labels({origin("GNU 12.2.0", "X", "a/run"), origin("GNU 12.2.0", "X", "b/run")}),
              ElementsAre("GCC 12.2.0 on X (a/run)", "GCC 12.2.0 on X (b/run)"));
}

TEST(RunLabels, DoWithoutAnEnvironment) {
  EXPECT_THAT(labels({{"{}", "a/run"}, {R"({"machine": "odd"})", "b/run"}, {"{}", "other"}}),
              ElementsAre("a/run", "b/run", "other"));
}

}  // namespace
}  // namespace phytobench
