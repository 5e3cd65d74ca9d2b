// SPDX-License-Identifier: MIT
// Counting of real programs: gate_breakage_test.cpp.
#include "benchmarks/comparison/instruction_counts.hpp"

#include <sys/stat.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "benchmarks/comparison/text_fixture.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::StartsWith;

const std::string callgrind_file =
    "# callgrind format\nversion: 1\ncreator: callgrind-3.19.0\npid: 4711\n"
    "cmd:  ./worker once a/b\npart: 1\n\n\ndesc: I1 cache: \ndesc: Trigger: Program termination\n\n"
    "positions: line\nevents: Ir\nsummary: 130632\n\n\nob=(1) /usr/lib/ld.so\nfl=(1) ???\n"
    "fn=(1) 0x1\n0 130632\n\ntotals: 130632\n";

void expect_callgrind_refused(const std::string& text, const std::string& problem) {
  try {
    callgrind_totals_from(text, "this count");
    ADD_FAILURE() << "accepted: " << text;
  } catch (const InputError& error) {
    EXPECT_THAT(error.what(), StartsWith("this count: "));
    EXPECT_THAT(error.what(), HasSubstr(problem));
  }
}

TEST(CallgrindTotals, AreReadFromTheLastLine) {
  EXPECT_EQ(callgrind_totals_from(callgrind_file, "x"), (CallgrindTotals{130632, std::nullopt}));
}

TEST(CallgrindTotals, HaveMissesWhereACacheWasSimulated) {
  const std::string text =
      replaced(callgrind_file, "totals: 130632", "totals: 1000 200 100 1 30 4 5 6 7");
  const std::string events = "events: Ir Dr Dw I1mr D1mr D1mw ILmr DLmr DLmw";
  std::string simulated = text;
  simulated.replace(simulated.find("events: Ir"), std::string("events: Ir").size(), events);
  EXPECT_EQ(callgrind_totals_from(simulated, "x"), (CallgrindTotals{1000, CacheMisses{34, 18}}));
}

TEST(CallgrindTotals, ZerosAtTheEndMayBeMissing) {
  std::string text = replaced(callgrind_file, "totals: 130632", "totals: 77");
  text.replace(text.find("events: Ir"), std::string("events: Ir").size(), "events: Ir Bc Bcm");
  EXPECT_EQ(callgrind_totals_from(text, "x").instructions, 77u);
}

TEST(CallgrindTotals, DamageIsNamed) {
  expect_callgrind_refused("", "events:");
  expect_callgrind_refused(callgrind_file.substr(0, callgrind_file.find("totals:")),
                           "no line 'totals:'");
  expect_callgrind_refused(replaced(callgrind_file, "events: Ir", "events: Bc"), "no instructions");
  expect_callgrind_refused(replaced(callgrind_file, "totals: 130632", "totals:"), "0 totals");
  expect_callgrind_refused(replaced(callgrind_file, "totals: 130632", "totals: 13x"), "'13x'");
  expect_callgrind_refused(replaced(callgrind_file, "totals: 130632", "totals: -5"), "'-5'");
  expect_callgrind_refused(
      replaced(callgrind_file, "totals: 130632", "totals: 99999999999999999999"), "no count");
  expect_callgrind_refused(replaced(callgrind_file, "totals: 130632", "totals: 1 2"),
                           "2 totals of 1");
  expect_callgrind_refused(callgrind_file + callgrind_file, "twice");
}

/// A shell script in the place of the worker.
class CountedProgram : public testing::Test {
 protected:
  CountedProgram()
      : folder_(fs::path(testing::TempDir()) /
                ("phytobench-counted-" + std::to_string(::getpid()))) {
    fs::remove_all(folder_);
    fs::create_directories(folder_ / "share");
    fs::create_directories(folder_ / "temporary");
    ::setenv("TMPDIR", (folder_ / "temporary").c_str(), 1);
  }
  ~CountedProgram() override {
    ::unsetenv("TMPDIR");
    std::error_code ignored;
    fs::remove_all(folder_, ignored);
  }

  InstructionCount count_of(const std::string& script) const {
    const fs::path file = folder_ / "script";
    std::ofstream(file) << "#!/bin/sh\n" << script << "\n";
    EXPECT_EQ(::chmod(file.c_str(), 0755), 0);
    return count_instructions({.worker = file, .data = folder_ / "share", .benchmark = "a/b"});
  }

  fs::path folder_;
};

TEST_F(CountedProgram, WithoutValgrindNothingIsCountedAndThatIsNoPass) {
  const char* const before = ::getenv("PATH");
  const std::string path = before == nullptr ? "" : before;
  ::setenv("PATH", folder_.c_str(), 1);
  const InstructionCount count = count_of("exit 0");
  ::setenv("PATH", path.c_str(), 1);
  EXPECT_EQ(count.outcome, CountOutcome::unsupported);
  EXPECT_THAT(count.reason, HasSubstr("not installed"));
}

/// In the place of Valgrind: a script that does what its options would make it do.
class CountedByStandIn : public CountedProgram {
 protected:
  InstructionCount count_with(const std::string& valgrind) const {
    const fs::path file = folder_ / "valgrind";
    std::ofstream(file) << "#!/bin/sh\n" << valgrind << "\n";
    EXPECT_EQ(::chmod(file.c_str(), 0755), 0);
    const char* const before = ::getenv("PATH");
    const std::string path = before == nullptr ? "" : before;
    ::setenv("PATH", (folder_.string() + ":/usr/bin:/bin").c_str(), 1);
    const InstructionCount count = count_of("exit 0");
    ::setenv("PATH", path.c_str(), 1);
    return count;
  }
};

const std::string answer =
    R"(echo '{"schema":"phytobench/worker-1","answers":"verify","benchmarks":[{"name":"a/b",)"
    R"("inputs":"i","answer":"o","objection":"","work":{}}]}')";

TEST_F(CountedByStandIn, ACountIsTakenFromItsFile) {
  const InstructionCount count =
      count_with(answer + "\nprintf 'events: Ir\\ntotals: 42\\n' > callgrind.out");
  EXPECT_EQ(count.outcome, CountOutcome::counted) << count.reason;
  EXPECT_EQ(count.totals.instructions, 42u);
  EXPECT_EQ(count.inputs, "i");
  EXPECT_EQ(count.answer, "o");
}

TEST_F(CountedByStandIn, TheProgramSeesTheSameWhereverItsBuildIs) {
  const InstructionCount count = count_with(
      "test \"$LC_ALL\" = C || exit 9\n"
      "test -z \"$GLIBC_TUNABLES$VALGRIND_OPTS\" || exit 9\n"
      "test \"$PHYTOBENCH_DATA\" -ef share || exit 9\n" +
      answer + "\nprintf 'events: Ir\\ntotals: 1\\n' > callgrind.out");
  ASSERT_EQ(count.outcome, CountOutcome::counted) << count.reason;
}

TEST_F(CountedByStandIn, AnUnknownInstructionIsUnsupported) {
  EXPECT_EQ(count_with("kill -ILL $$").outcome, CountOutcome::unsupported);
  EXPECT_EQ(count_with("echo '==1== Unrecognised instruction at 0x1.' >&2; exit 1").outcome,
            CountOutcome::unsupported);
  EXPECT_EQ(count_with("echo 'valgrind: failed to start tool' >&2; exit 1").outcome,
            CountOutcome::unsupported);
}

TEST_F(CountedByStandIn, AWorkerWithoutItsHeaderIsUnsupported) {
  const InstructionCount count = count_with(
      "echo \"phytobench_worker: built without callgrind's header; install it\" >&2; exit 3");
  EXPECT_EQ(count.outcome, CountOutcome::unsupported);
  EXPECT_THAT(count.reason, HasSubstr("without callgrind's header"));
}

TEST_F(CountedByStandIn, WhatElseGoesWrongIsAFailureWithItsReason) {
  const InstructionCount refused =
      count_with("echo 'phytobench_worker: unknown benchmark' >&2; exit 2");
  EXPECT_EQ(refused.outcome, CountOutcome::failed);
  EXPECT_THAT(refused.reason, HasSubstr("exit code 2: phytobench_worker: unknown benchmark"));
  EXPECT_THAT(count_with("kill -SEGV $$").reason, HasSubstr("signal 11"));
  EXPECT_THAT(count_with(answer).reason, HasSubstr("callgrind.out"));
  EXPECT_THAT(count_with("printf 'events: Ir\\ntotals: 7\\n' > callgrind.out").reason,
              HasSubstr("the count of a/b"));
  EXPECT_THAT(count_with(answer + "\nprintf 'events: Ir\\ntotals: 0\\n' > callgrind.out").reason,
              HasSubstr("no instruction was counted"));
}

TEST_F(CountedByStandIn, NothingIsLeftBehind) {
  count_with("exit 1");
  EXPECT_TRUE(fs::is_empty(folder_ / "temporary"));
}

}  // namespace
}  // namespace phytobench
