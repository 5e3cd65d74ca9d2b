// SPDX-License-Identifier: MIT
// Every way in which an engine from outside can fail, each by an engine that does.
#include "benchmarks/nearest_node/plugin_trial.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using Kind = PluginVerdict::Kind;
using testing::HasSubstr;

const std::filesystem::path built = PHYTOBENCH_EXAMPLE_PLUGINS;

std::filesystem::path faulty(const std::string& name) {
  return built / "faulty" / (name + ".so");
}

/// Ties everywhere.
std::vector<NamedSeedling> lattice_only() {
  return {{"lattice", with_crown_stem(seedling_with(lattice(4, 0.25), 0.5, 0.25, 10))}};
}

PluginVerdict quick_verdict(const std::string& name, double silence_s = 20.0) {
  return try_plugin(faulty(name), lattice_only(), {.silence_s = silence_s});
}

TEST(PluginTrial, FindsTheExampleExactOnEveryTrialTree) {
  const PluginVerdict verdict = try_plugin(built / "nearest_scan.so");
  EXPECT_EQ(verdict.kind, Kind::exact) << verdict.detail;
  EXPECT_EQ(verdict.engine, "nearest_scan");
  EXPECT_THAT(verdict.detail, HasSubstr("every answer on 4 trees"));
}

TEST(PluginTrial, FindsAnEngineExactThatRemovesPointsItself) {
  const PluginVerdict verdict = quick_verdict("removing");
  EXPECT_EQ(verdict.kind, Kind::exact) << verdict.detail;
  EXPECT_EQ(verdict.engine, "removing");
}

TEST(PluginTrial, GivesPlaceNodesAndDistancesOfAWrongAnswer) {
  const PluginVerdict verdict = quick_verdict("wrong");
  EXPECT_EQ(verdict.kind, Kind::wrong);
  EXPECT_EQ(verdict.engine, "wrong");
  for (const char* part : {"lattice, loop option s: iteration ", "point ", "node ",
                           "at squared distance ", "the judge has node "})
    EXPECT_THAT(verdict.detail, HasSubstr(part));
}

TEST(PluginTrial, TakesNonsenseForAWrongAnswer) {
  for (const char* name : {"node_beyond", "node_negative", "removed_twice", "removed_beyond",
                           "too_many", "reports_failure", "creates_nothing"})
    EXPECT_EQ(quick_verdict(name).kind, Kind::wrong) << name;
  EXPECT_THAT(quick_verdict("node_beyond").detail, HasSubstr("which does not exist"));
}

TEST(PluginTrial, TakesAChangedFloatingPointEnvironmentForAWrongAnswer) {
  for (const char* name : {"rounds_upward", "flushes_denormals", "rounds_at_the_end"}) {
    const PluginVerdict verdict = quick_verdict(name);
    EXPECT_EQ(verdict.kind, Kind::wrong) << name;
    EXPECT_THAT(verdict.detail, HasSubstr("changes the floating-point environment")) << name;
  }
  const PluginVerdict refused = quick_verdict("rounds_when_loaded");
  EXPECT_EQ(refused.kind, Kind::refused);
  EXPECT_THAT(refused.detail, HasSubstr("when it is loaded"));
}

TEST(PluginTrial, MakesCallsThatNoGrowthMakes) {
  for (const char* name : {"global_state", "needs_points", "needs_nodes"})
    EXPECT_EQ(quick_verdict(name).kind, Kind::wrong) << name;
  EXPECT_THAT(quick_verdict("needs_points").detail, HasSubstr("no points: "));
}

TEST(PluginTrial, GrowsWithTwoThreads) {
  const PluginVerdict verdict = quick_verdict("needs_one_thread");
  EXPECT_EQ(verdict.kind, Kind::wrong);
  EXPECT_THAT(verdict.detail, HasSubstr("lattice, loop option d, 2 threads: create() failed"));
}

TEST(PluginTrial, NoticesAnswersThatAreOtherOnesLater) {
  const PluginVerdict early = quick_verdict("changes_its_mind");
  EXPECT_EQ(early.kind, Kind::wrong) << early.detail;
  const PluginVerdict late = quick_verdict("changes_its_mind_late");
  EXPECT_EQ(late.kind, Kind::wrong) << late.detail;
  EXPECT_THAT(late.detail, HasSubstr("the same growth again: other answers"));
}

TEST(PluginTrial, NoticesThatItsFilesWereClosed) {
  const PluginVerdict verdict = quick_verdict("closes_files");
  EXPECT_EQ(verdict.kind, Kind::wrong);
  EXPECT_THAT(verdict.detail, HasSubstr("closed files of others"));
}

TEST(PluginTrial, EndsWhatTakesTooLongAltogether) {
  const PluginVerdict verdict =
      try_plugin(faulty("slow"), lattice_only(), {.silence_s = 60.0, .total_s = 0.5});
  EXPECT_EQ(verdict.kind, Kind::hangs);
  EXPECT_THAT(verdict.detail, HasSubstr("not done after 0.5 s"));
}

TEST(PluginTrial, SurvivesACrash) {
  const PluginVerdict verdict = quick_verdict("crashing");
  EXPECT_EQ(verdict.kind, Kind::crashed);
  EXPECT_EQ(verdict.detail, "SIGSEGV in associate() in iteration 2");
}

TEST(PluginTrial, EndsAnEngineThatHangs) {
  const PluginVerdict verdict = quick_verdict("hanging", 0.5);
  EXPECT_EQ(verdict.kind, Kind::hangs);
  EXPECT_THAT(verdict.detail, HasSubstr("no answer for 0.5 s in removed() in removal "));
}

TEST(PluginTrial, NoticesMemoryThatDoesNotComeBack) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer keeps freed memory, and does not tell what is allocated";
#endif
  const PluginVerdict verdict = quick_verdict("leaking");
  EXPECT_EQ(verdict.kind, Kind::leaks);
  EXPECT_EQ(verdict.engine, "leaking");
  EXPECT_THAT(verdict.detail, HasSubstr("bytes are left behind by each growth"));
}

TEST(PluginTrial, RefusesWhatIsNoEngine) {
  const PluginVerdict missing = try_plugin("nothing.so", lattice_only());
  EXPECT_EQ(missing.kind, Kind::refused);
  EXPECT_THAT(missing.detail, HasSubstr("nothing.so"));
  const PluginVerdict old = quick_verdict("wrong_abi");
  EXPECT_EQ(old.kind, Kind::refused);
  EXPECT_THAT(old.detail, HasSubstr("version 2"));
}

TEST(PluginTrial, ListensToCtrlC) {
  EXPECT_THROW(try_plugin(faulty("hanging"), lattice_only(),
                          {.silence_s = 60.0, .is_interrupted = [] { return true; }}),
               Interrupted);
}

std::vector<double> growing_by(double first, double each) {
  std::vector<double> bytes = {1e6, 1e6 + first};
  for (int i = 0; i < 4; ++i) bytes.push_back(bytes.back() + each);
  return bytes;
}

TEST(LeakedPerGrowth, CountsWhatEveryGrowthLeavesBehind) {
  EXPECT_EQ(leaked_per_growth({.heap = growing_by(0, 2000), .working = 1e6}), 2000.0);
  EXPECT_EQ(leaked_per_growth({.heap = growing_by(0, 200), .working = 1e4}), 200.0);
  EXPECT_EQ(leaked_per_growth({.resident = growing_by(0, 400000), .working = 1e6}), 400000.0);
}

TEST(LeakedPerGrowth, ForgivesCachesAndBookkeeping) {
  EXPECT_EQ(leaked_per_growth({.heap = growing_by(1e6, 0), .working = 1e6}), 0.0);
  EXPECT_EQ(leaked_per_growth({.heap = growing_by(0, 60), .working = 1e3}), 0.0);
  EXPECT_EQ(leaked_per_growth({.heap = growing_by(0, 1000), .working = 1e6}), 0.0);
  EXPECT_EQ(leaked_per_growth({.heap = growing_by(0, -5000), .working = 1e6}), 0.0);
  EXPECT_EQ(leaked_per_growth({.resident = growing_by(0, 100000), .working = 1e6}), 0.0);
  EXPECT_EQ(leaked_per_growth({.resident = growing_by(0, 400000), .working = 1e9}), 0.0);
  std::vector<double> once = growing_by(0, 5000);
  once.back() = once[once.size() - 2];
  EXPECT_EQ(leaked_per_growth({.heap = once, .working = 1e6}), 0.0);
  EXPECT_EQ(leaked_per_growth({}), 0.0);
}

}  // namespace
}  // namespace phytobench
