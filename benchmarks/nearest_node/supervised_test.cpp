// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/supervised.hpp"

#include <unistd.h>

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
