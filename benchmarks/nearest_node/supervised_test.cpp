// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/supervised.hpp"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench {
namespace {

using End = SupervisedRun::End;
using testing::HasSubstr;

/// Stands still, as a call that does not return does.
void sleep_for_ms(int milliseconds) {
  ::usleep(static_cast<useconds_t>(1000 * milliseconds));
}

TEST(SupervisedWork, GivesBackItsCodeAndItsOutput) {
  const std::string megabyte(1 << 20, 'x');  // more than a pipe holds
  const SupervisedRun run = run_supervised(
      [&](PluginPulse&, std::string& output) {
        output = megabyte;
        return 7;
      },
      {});
  EXPECT_EQ(run.end, End::finished);
  EXPECT_EQ(run.code, 7);
  EXPECT_TRUE(run.output == megabyte);
}

template <class Error>
void expect_passed_on() {
  const auto work = [](PluginPulse&, std::string&) -> int { throw Error("what it says"); };
  try {
    run_supervised(work, {});
    ADD_FAILURE() << "nothing was thrown";
  } catch (const Error& error) {
    EXPECT_THAT(error.what(), HasSubstr("what it says"));
  }
}

TEST(SupervisedWork, PassesOnWhatItThrows) {
  expect_passed_on<InputError>();
  expect_passed_on<EnvironmentError>();
  expect_passed_on<NothingSelected>();
  expect_passed_on<PluginMisbehaved>();
  expect_passed_on<ContractViolation>();
  EXPECT_THROW(run_supervised([](PluginPulse&, std::string&) -> int { throw Interrupted(); }, {}),
               Interrupted);
}

TEST(SupervisedWork, NamesTheSignalAndTheCall) {
  const SupervisedRun run = run_supervised(
      [](PluginPulse& pulse, std::string&) {
        const WatchedCall call({.pulse = &pulse, .plugin = 2}, PluginCall::associate, 5);
        ::raise(SIGABRT);
        return 0;
      },
      {});
  EXPECT_EQ(run.end, End::signal);
  EXPECT_EQ(run.code, SIGABRT);
  EXPECT_EQ(run.plugin, 2);
  EXPECT_EQ(described(run, {}), "SIGABRT in associate() in iteration 5");
}

TEST(SupervisedWork, SaysWhenTheCallHadReturned) {
  const SupervisedRun run = run_supervised(
      [](PluginPulse& pulse, std::string&) {
        { const WatchedCall call({.pulse = &pulse, .plugin = 0}, PluginCall::destroy, 0); }
        ::raise(SIGKILL);
        return 0;
      },
      {});
  EXPECT_EQ(described(run, {}), "SIGKILL after destroy()");
}

TEST(SupervisedWork, MayNotEndTheProgram) {
  const SupervisedRun run = run_supervised(
      [](PluginPulse& pulse, std::string&) -> int {
        const WatchedCall call({.pulse = &pulse, .plugin = 0}, PluginCall::create, 0);
        ::_exit(0);
      },
      {});
  EXPECT_EQ(run.end, End::exit);
  EXPECT_EQ(described(run, {}), "ended the program with exit code 0 in create()");
}

TEST(SupervisedWork, IsStoppedWhenACallDoesNotReturn) {
  const SupervisionLimits limits{.silence_s = 0.2};
  const SupervisedRun run = run_supervised(
      [](PluginPulse& pulse, std::string&) {
        const WatchedCall call({.pulse = &pulse, .plugin = 0}, PluginCall::remove, 4);
        for (;;) sleep_for_ms(1000);
        return 0;
      },
      limits);
  EXPECT_EQ(run.end, End::silence);
  EXPECT_EQ(described(run, limits), "no answer for 0.2 s in remove() in removal 4");
}

TEST(SupervisedWork, MayTakeItsTimeOutsideOfCallsAndInManyOfThem) {
  const SupervisedRun run = run_supervised(
      [](PluginPulse& pulse, std::string&) {
        sleep_for_ms(1500);
        for (int call = 0; call < 15; ++call) {
          const WatchedCall noted({.pulse = &pulse, .plugin = 0}, PluginCall::associate, call);
          sleep_for_ms(100);
        }
        return 0;
      },
      {.silence_s = 1.2});
  EXPECT_EQ(run.end, End::finished);
}

TEST(SupervisedWork, IsStoppedWhenItTakesTooLongAltogether) {
  const SupervisionLimits limits{.silence_s = 60.0, .total_s = 0.3};
  const SupervisedRun run = run_supervised(
      [](PluginPulse& pulse, std::string&) {
        for (;;) {
          const WatchedCall call({.pulse = &pulse, .plugin = 0}, PluginCall::associate, 8);
          sleep_for_ms(20);
        }
        return 0;
      },
      limits);
  EXPECT_EQ(run.end, End::overtime);
  EXPECT_THAT(described(run, limits), HasSubstr("not done after 0.3 s, "));
}

TEST(SupervisedWork, IsLostWithoutItsPipe) {
  for (const bool throws : {false, true}) {
    const SupervisedRun run = run_supervised(
        [&](PluginPulse&, std::string& output) {
          for (int descriptor = 3; descriptor < 256; ++descriptor) ::close(descriptor);
          if (throws) throw InputError("nobody hears that");
          output = "nobody reads that";
          return 0;
        },
        {});
    EXPECT_EQ(run.end, End::lost);
    EXPECT_THAT(described(run, {}), HasSubstr("closed files of others"));
  }
}

TEST(SupervisedWork, IsWaitedForEvenIfEndsOfChildrenAreIgnored) {
  const auto before = std::signal(SIGCHLD, SIG_IGN);
  const SupervisedRun run =
      run_supervised([](PluginPulse&, std::string&) { return 7; }, {.total_s = 60.0});
  EXPECT_EQ(std::signal(SIGCHLD, before), SIG_IGN) << "not as it was";
  EXPECT_EQ(run.end, End::finished);
  EXPECT_EQ(run.code, 7);
}

TEST(SupervisedWork, ReadsNothingFromStandardInput) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  ASSERT_EQ(::write(ends[1], "x", 1), 1);
  const int before = ::fcntl(STDIN_FILENO, F_DUPFD_CLOEXEC, 3);
  ::dup2(ends[0], STDIN_FILENO);
  const SupervisedRun run = run_supervised(
      [](PluginPulse&, std::string&) {
        char letter = 0;
        return static_cast<int>(::read(STDIN_FILENO, &letter, 1));
      },
      {});
  ::dup2(before, STDIN_FILENO);
  for (const int descriptor : {before, ends[0], ends[1]}) ::close(descriptor);
  EXPECT_EQ(run.end, End::finished);
  EXPECT_EQ(run.code, 0);
}

// The process that it leaves behind holds the pipe's other end.
TEST(SupervisedWork, LeavesNoProcessBehind) {
  std::array<int, 2> ends{};
  ASSERT_EQ(::pipe2(ends.data(), O_CLOEXEC), 0);
  const SupervisedRun run = run_supervised(
      [](PluginPulse&, std::string&) {
        if (::getpgrp() != ::getpid()) return 1;
        if (::fork() == 0)
          for (;;) sleep_for_ms(1000);
        return 0;
      },
      {});
  EXPECT_EQ(run.code, 0) << "it has no group of its own";
  ::close(ends[1]);
  pollfd wanted{ends[0], POLLIN, 0};
  EXPECT_EQ(::poll(&wanted, 1, 10'000), 1) << "the process lives on";
  EXPECT_NE(wanted.revents & POLLHUP, 0);
  ::close(ends[0]);
}

TEST(SupervisedWork, EndsWhenTheUserSaysSo) {
  const SupervisedWork sleeps = [](PluginPulse&, std::string&) {
    for (;;) sleep_for_ms(1000);
    return 0;
  };
  EXPECT_THROW(run_supervised(sleeps, {.is_interrupted = [] { return true; }}), Interrupted);
}

TEST(SupervisedWork, WritesNothingToStandardOutput) {
  testing::internal::CaptureStdout();
  testing::internal::CaptureStderr();
  run_supervised(
      [](PluginPulse&, std::string&) {
        std::printf("a plugin talks\n");
        return 0;
      },
      {});
  EXPECT_EQ(testing::internal::GetCapturedStdout(), "");
  EXPECT_EQ(testing::internal::GetCapturedStderr(), "a plugin talks\n");
}

}  // namespace
}  // namespace phytobench
