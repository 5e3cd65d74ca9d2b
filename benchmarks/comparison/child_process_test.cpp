// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/child_process.hpp"

#include <signal.h>

#include <cstdlib>

#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/side_fixture.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

ChildOptions shell(const std::string& script) {
  return {.command = {"/bin/sh", "-c", script}};
}

class ChildProcesses : public SideFolder, public testing::WithParamInterface<ChildWait> {
 protected:
  ChildResult run(ChildOptions options) const {
    options.wait = GetParam();
    return run_child(options);
  }

  /// Leaves the number of its process in a file, and sleeps longer than any test.
  ChildOptions sleeper() const {
    ChildOptions options = shell("echo $$ > part; mv part number; exec sleep 60");
    options.folder = folder_;
    return options;
  }
  std::filesystem::path number_file() const { return folder_ / "number"; }
};

TEST_P(ChildProcesses, TellHowTheyEndedAndWhatTheySaid) {
  const ChildResult result = run(shell("echo out; echo err >&2; exit 3"));
  EXPECT_EQ(result.exit_code, 3);
  EXPECT_EQ(result.signal, 0);
  EXPECT_EQ(result.out, "out\n");
  EXPECT_EQ(result.err, "err\n");
  EXPECT_FALSE(result.is_ok());
  EXPECT_TRUE(run(shell("exit 0")).is_ok());
}

TEST_P(ChildProcesses, ReadAndWriteMoreThanAPipeHolds) {
  ChildOptions options = shell("cat");
  options.input.assign(1 << 20, 'x');
  options.input += std::string("\0end", 4);
  EXPECT_EQ(run(options).out, options.input);
  EXPECT_EQ(run(shell("cat")).out, "");
}

TEST_P(ChildProcesses, KilledBySignalsSaySo) {
  const ChildResult result = run(shell("kill -SEGV $$"));
  EXPECT_EQ(result.exit_code, -1);
  EXPECT_EQ(result.signal, SIGSEGV);
  EXPECT_FALSE(result.is_ok());
  EXPECT_THAT(ending_of(result, 5.0), HasSubstr("killed by signal 11"));
}

TEST_P(ChildProcesses, EndAtTheirLimitWithAllTheyStarted) {
  ChildOptions options = shell("sleep 60 & echo $!; wait");
  options.limit_s = 0.3;
  const ChildResult result = run(options);
  EXPECT_TRUE(result.timed_out);
  EXPECT_FALSE(result.is_ok());
  EXPECT_GE(result.wall_s, 0.3);
  EXPECT_TRUE(ends(last_line(result.out))) << result.out;
  EXPECT_EQ(ending_of(result, options.limit_s), "took longer than 0.3 s");
}

TEST_P(ChildProcesses, ThatDoNotWantToEndAreKilled) {
  ChildOptions options = shell("trap '' TERM; while :; do sleep 0.05; done");
  options.limit_s = 1.0;  // a busy machine needs a while to set the trap
  options.grace_s = 0.1;
  const ChildResult result = run(options);
  EXPECT_TRUE(result.timed_out);
  EXPECT_EQ(result.signal, SIGKILL);
}

TEST_P(ChildProcesses, LeaveNothingRunningBehind) {
  const ChildResult result = run(shell("sleep 60 >/dev/null 2>&1 & echo $!"));
  EXPECT_TRUE(result.is_ok());
  EXPECT_TRUE(ends(last_line(result.out))) << result.out;
}

TEST_P(ChildProcesses, EndWhenInterrupted) {
  ChildOptions options = sleeper();
  options.is_interrupted = [this] { return std::filesystem::exists(number_file()); };
  EXPECT_THROW(run(options), Interrupted);
  EXPECT_TRUE(ends(last_line(read_text_file(number_file()))));
}

TEST_P(ChildProcesses, EndWhereAskingForInterruptionsFails) {
  ChildOptions options = sleeper();
  options.is_interrupted = [this] {
    if (std::filesystem::exists(number_file())) throw InputError("no answer");
    return false;
  };
  EXPECT_THROW(run(options), InputError);
  EXPECT_TRUE(ends(last_line(read_text_file(number_file()))));
}

TEST_P(ChildProcesses, AreNotStartedAfterAnInterruption) {
  ChildOptions options = shell("touch started");
  options.folder = folder_;
  options.is_interrupted = [] { return true; };
  EXPECT_THROW(run(options), Interrupted);
  EXPECT_TRUE(std::filesystem::is_empty(folder_));
}

TEST_P(ChildProcesses, GetTheEnvironmentThatIsAskedFor) {
  ::setenv("PHYTOBENCH_TEST_KEPT", "kept", 1);
  ::setenv("PHYTOBENCH_TEST_GONE", "gone", 1);
  ChildOptions options =
      shell("echo $PHYTOBENCH_TEST_KEPT,${PHYTOBENCH_TEST_GONE-unset},$PHYTOBENCH_TEST_NEW");
  options.environment = {{"PHYTOBENCH_TEST_GONE", std::nullopt}, {"PHYTOBENCH_TEST_NEW", "new"}};
  EXPECT_EQ(run(options).out, "kept,unset,new\n");
  options.inherited = InheritedEnvironment::nothing;
  EXPECT_EQ(run(options).out, ",unset,new\n");
  ::unsetenv("PHYTOBENCH_TEST_KEPT");
  ::unsetenv("PHYTOBENCH_TEST_GONE");
}

TEST_P(ChildProcesses, AppendToALog) {
  ChildOptions options = shell("echo out; echo err >&2");
  options.log = write("log", "before\n");
  const ChildResult result = run(options);
  EXPECT_EQ(result.out + result.err, "");
  EXPECT_EQ(read_text_file(options.log), "before\nout\nerr\n");
  options.log = folder_ / "missing" / "log";
  EXPECT_THAT(message_of<EnvironmentError>([&] { run(options); }), HasSubstr("missing/log"));
}

TEST_P(ChildProcesses, ThatAreMissingAreErrorsOfTheEnvironment) {
  for (const char* program : {"phytobench-no-such-program", "/no/such/program", "/", ""})
    EXPECT_THAT(message_of<EnvironmentError>([&] { run({.command = {program}}); }),
                HasSubstr("is missing or cannot be run"))
        << program;
}

TEST_P(ChildProcesses, ThatCannotStartAreErrorsOfTheEnvironment) {
  const std::filesystem::path file = write("no_program", std::string("\x7f") + "ELF");
  std::filesystem::permissions(file, std::filesystem::perms::owner_all);
  EXPECT_THAT(message_of<EnvironmentError>([&] { run({.command = {file.string()}}); }),
              HasSubstr("no_program cannot be started: "));
  ChildOptions options = shell("exit 0");
  options.folder = folder_ / "missing";
  EXPECT_THAT(message_of<EnvironmentError>([&] { run(options); }), HasSubstr("cannot be started"));
  options.folder.clear();
  options.processor = 1000;
  EXPECT_THAT(message_of<EnvironmentError>([&] { run(options); }), HasSubstr("cannot be started"));
}

TEST_P(ChildProcesses, StayOnTheirProcessor) {
  const std::vector<int> allowed = allowed_processors();
  ASSERT_FALSE(allowed.empty());
  ChildOptions options = shell("grep Cpus_allowed_list /proc/self/status");
  options.processor = allowed.back();
  EXPECT_EQ(last_line(run(options).out), "Cpus_allowed_list: " + std::to_string(allowed.back()));
  EXPECT_EQ(allowed_processors(), allowed);
}

TEST_P(ChildProcesses, HearSignalsThatWeDoNot) {
  sigset_t blocked, before;
  sigemptyset(&blocked);
  sigaddset(&blocked, SIGTERM);
  ::sigprocmask(SIG_BLOCK, &blocked, &before);
  const ChildResult result = run(shell("kill -TERM $$; sleep 1; exit 0"));
  ::sigprocmask(SIG_SETMASK, &before, nullptr);
  EXPECT_EQ(result.signal, SIGTERM);
}

INSTANTIATE_TEST_SUITE_P(BothWays, ChildProcesses,
                         testing::Values(ChildWait::by_descriptor, ChildWait::by_looking),
                         [](const auto& test) {
                           return test.param == ChildWait::by_descriptor ? "ByDescriptor"
                                                                         : "ByLooking";
                         });

TEST(LastLine, IsTheLastThatIsNotEmpty) {
  EXPECT_EQ(last_line(""), "");
  EXPECT_EQ(last_line(" \n\n"), "");
  EXPECT_EQ(last_line("only"), "only");
  EXPECT_EQ(last_line("first\nlast\n\n"), "last");
  EXPECT_EQ(last_line("first\nla\x1bst\r\n"), "la st");
}

}  // namespace
}  // namespace phytobench
