// SPDX-License-Identifier: MIT
// phytobench compare old.so new.so as the author of an engine meets it.
#include "cli/command_line_fixture.hpp"

namespace phytobench {
namespace {

using nlohmann::json;
using testing::HasSubstr;

class ComparePlugin : public CommandLine {
 protected:
  static std::string good() { return PHYTOBENCH_EXAMPLE_PLUGINS "/nearest_scan.so"; }
  static std::string faulty(const std::string& name) {
    return PHYTOBENCH_EXAMPLE_PLUGINS "/faulty/" + name + ".so";
  }
};

TEST_F(ComparePlugin, EveryDocumentSaysWhichTrialFailedAtWhichStep) {
  const std::string step = "SIGSEGV in associate() in iteration 2";
  const Outcome outcome = run({"compare", good(), faulty("crashing"), "--out", "c.json",
                               "--markdown", "c.md", "--junit", "c.xml"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  EXPECT_THAT(outcome.out, HasSubstr("new failed its trial, so nothing was timed"));
  EXPECT_THAT(outcome.out, HasSubstr(step));
  const json document = json::parse(read("c.json"));
  ASSERT_EQ(document["failed_trials"].size(), 1u);
  EXPECT_EQ(document["failed_trials"][0]["side"], "new");
  EXPECT_EQ(document["failed_trials"][0]["given"], faulty("crashing"));
  EXPECT_EQ(document["failed_trials"][0]["verdict"], "crashed");
  EXPECT_EQ(document["failed_trials"][0]["detail"], step);
  EXPECT_THAT(read("c.md"), HasSubstr(step));
  EXPECT_THAT(read("c.xml"), HasSubstr("plugin trial of new"));
  EXPECT_THAT(read("c.xml"), HasSubstr(step));
}

TEST_F(ComparePlugin, BothSidesAreTriedAndTheDocumentIsTheOnlyOutput) {
  const Outcome outcome = run({"compare", faulty("wrong"), faulty("crashing"), "--json"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const json document = json::parse(outcome.out);
  ASSERT_EQ(document["failed_trials"].size(), 2u);
  EXPECT_EQ(document["failed_trials"][0]["side"], "base");
  EXPECT_EQ(document["failed_trials"][0]["verdict"], "wrong");
  EXPECT_EQ(document["failed_trials"][1]["side"], "new");
}

TEST_F(ComparePlugin, ACallMayTakeAsLongAsIsSaid) {
  const Outcome outcome =
      run({"compare", good(), faulty("hanging"), "--plugin-limit", "0.5", "--json"});
  EXPECT_EQ(outcome.code, 1) << outcome.err;
  const json failed = json::parse(outcome.out)["failed_trials"][0];
  EXPECT_EQ(failed["verdict"], "hangs");
  EXPECT_THAT(text_at(failed, "detail"), HasSubstr("no answer for 0.5 s in removed()"));
}

TEST_F(ComparePlugin, WhatCannotBeLoadedIsWrongInput) {
  expect_refused({"compare", good(), faulty("no_symbol"), "--out", "c.json"}, 2,
                 "exports no function");
  EXPECT_FALSE(exists("c.json"));
}

}  // namespace
}  // namespace phytobench
