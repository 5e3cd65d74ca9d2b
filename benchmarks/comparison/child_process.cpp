// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/child_process.hpp"

#include <poll.h>
#include <sys/resource.h>
#include <sys/syscall.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstring>

#include <fmt/format.h>

#include "benchmarks/comparison/child_streams.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "benchmarks/comparison/start_child.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

/// Readable once the process has ended; negative where the system has no such thing. The C library
/// has no function for it before version 2.36.
int descriptor_of(pid_t process) {
  return static_cast<int>(::syscall(SYS_pidfd_open, process, 0));
}

/// A process group whose first process is ours to wait for; ended with it.
class RunningChild {
 public:
  RunningChild(pid_t child, const ChildOptions& options)
      : child_(child),
        end_(options.wait == ChildWait::by_descriptor ? descriptor_of(child) : -1),
        grace_s_(options.grace_s) {}
  ~RunningChild() {
    if (child_ > 0) end();
  }
  RunningChild(const RunningChild&) = delete;
  RunningChild& operator=(const RunningChild&) = delete;

  /// Sleeps until the program has ended, a signal arrives or the time is over.
  bool has_ended_within(double seconds) const {
    if (end_.number() >= 0) {
      pollfd event{.fd = end_.number(), .events = POLLIN, .revents = 0};
      ::poll(&event, 1, static_cast<int>(std::ceil(1000.0 * seconds)));
    } else if (!has_ended()) {
      ::usleep(5000);
    }
    return has_ended();
  }

  /// How a program that has ended did so. Kills what is left of the group.
  ChildResult collect() {
    // While its first process is not yet waited for, no other group can have its number.
    ::kill(-child_, SIGKILL);
    return wait();
  }

  /// Asks the group to end before it is killed. Those that outlive the first process need a moment,
  /// too: ninja ends compilers, which are in groups of their own.
  ChildResult end() {
    const pid_t group = child_;
    const Clock::time_point asked = Clock::now();
    ::kill(-group, SIGTERM);
    while (seconds_since(asked) < grace_s_ && !has_ended_within(0.05)) continue;
    if (!has_ended()) ::kill(-group, SIGKILL);
    const ChildResult result = wait();
    while (seconds_since(asked) < grace_s_ && ::kill(-group, 0) == 0) ::usleep(5000);
    ::kill(-group, SIGKILL);
    return result;
  }

 private:
  /// Also where somebody else has waited for it already; it is collected without a result then.
  bool has_ended() const {
    siginfo_t info{};
    const int error =
        ::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
    return error != 0 ? errno != EINTR : info.si_pid == child_;
  }

  ChildResult wait() {
    int status = 0;
    rusage used{};
    pid_t waited = 0;
    while ((waited = ::wait4(child_, &status, 0, &used)) < 0 && errno == EINTR) continue;
    child_ = 0;
    ChildResult result;
    if (waited > 0 && WIFEXITED(status)) result.exit_code = WEXITSTATUS(status);
    if (waited > 0 && WIFSIGNALED(status)) result.signal = WTERMSIG(status);
    result.user_s = static_cast<double>(used.ru_utime.tv_sec) +
                    1e-6 * static_cast<double>(used.ru_utime.tv_usec);
    return result;
  }

  pid_t child_;
  Descriptor end_;
  double grace_s_;
};

}  // namespace

ChildResult run_child(const ChildOptions& options) {
  PHYTOBENCH_EXPECT(!options.command.empty() && options.limit_s > 0.0);
  if (options.is_interrupted && options.is_interrupted()) throw Interrupted();
  const ChildStreams streams(options.input, options.log);
  const Clock::time_point start = Clock::now();
  RunningChild child(start_child(options, streams), options);
  bool timed_out = false;
  while (!timed_out &&
         !child.has_ended_within(std::clamp(options.limit_s - seconds_since(start), 0.001, 0.1))) {
    if (options.is_interrupted && options.is_interrupted()) throw Interrupted();
    timed_out = seconds_since(start) > options.limit_s;
  }
  const double wall_s = seconds_since(start);
  ChildResult result = timed_out ? child.end() : child.collect();
  result.timed_out = timed_out;
  result.wall_s = wall_s;
  result.out = streams.out();
  result.err = streams.err();
  return result;
}

std::string ending_of(const ChildResult& result, double limit_s) {
  if (result.timed_out) return fmt::format("took longer than {:g} s", limit_s);
  if (result.signal != 0)
    return fmt::format("was killed by signal {} ({})", result.signal, ::strsignal(result.signal));
  if (result.exit_code < 0) return "ended, nobody knows how";
  return fmt::format("ended with exit code {}", result.exit_code);
}

std::string last_line(const std::string& text) {
  const std::size_t last = text.find_last_not_of(" \t\r\n");
  if (last == std::string::npos) return "";
  const std::size_t before = text.rfind('\n', last);
  const std::size_t first = before == std::string::npos ? 0 : before + 1;
  return one_line(text.substr(first, last - first + 1), 1000);
}

}  // namespace phytobench
