// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/supervisor.hpp"

#include <poll.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr int look_every_ms = 100;

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

}  // namespace

SupervisedRun Supervisor::wait() {
  while (!has_ended()) {
    read_output(look_every_ms);
    if (limits_.is_interrupted && limits_.is_interrupted()) throw Interrupted();
    stopped_ = reason_to_stop();
    if (stopped_) end_child();
  }
  while (read_output(0)) {
  }
  return outcome();
}

/// An ended child is left unreaped until its group is gone: its number cannot become another's.
bool Supervisor::has_ended() {
  if (is_reaped_) return true;
  siginfo_t info{};
  const int result = ::waitid(P_PID, static_cast<id_t>(child_), &info, WEXITED | WNOHANG | WNOWAIT);
  if (result != 0 && errno != EINTR) {
    is_reaped_ = true;  // by somebody else: nothing may be killed under that number any more
    throw EnvironmentError(
        "the system does not tell how a child process ended; something else waited for it");
  }
  if (result == 0 && info.si_pid == child_) end_child();
  return is_reaped_;
}

/// Kills what is left of the child and of what it has started, and reaps it.
void Supervisor::end_child() {
  ::kill(-child_, SIGKILL);
  ::kill(child_, SIGKILL);  // without effect on one that has ended
  while (::waitpid(child_, &status_, 0) < 0 && errno == EINTR) {
  }
  is_reaped_ = true;
}

/// Waits for output, or for the child's end, at most so long. True if there was some.
bool Supervisor::read_output(int milliseconds) {
  pollfd wanted{is_open_ ? pipe_ : -1, POLLIN, 0};
  // Once the pipe is closed, only the time counts.
  if (::poll(&wanted, 1, is_open_ ? milliseconds : std::min(milliseconds, 5)) <= 0) return false;
  std::array<char, 65536> buffer;
  const ssize_t count = ::read(pipe_, buffer.data(), buffer.size());
  if (count > 0) output_.append(buffer.data(), static_cast<std::size_t>(count));
  if (count == 0) is_open_ = false;
  return count > 0;
}

std::optional<SupervisedRun::End> Supervisor::reason_to_stop() {
  if (is_silent_for_too_long()) return SupervisedRun::End::silence;
  if (seconds_since(started_) > limits_.total_s) return SupervisedRun::End::overtime;
  return std::nullopt;
}

/// Only a plugin's call is limited: our own work may take its time.
bool Supervisor::is_silent_for_too_long() {
  const std::uint64_t beats = shared_.pulse.beats;
  if (beats != beats_ || !shared_.pulse.is_inside) {
    beats_ = beats;
    since_ = Clock::now();
    return false;
  }
  return seconds_since(since_) > limits_.silence_s;
}

SupervisedRun Supervisor::outcome() const {
  SupervisedRun run{.plugin = shared_.pulse.plugin,
                    .call = shared_.pulse.call,
                    .number = shared_.pulse.number,
                    .was_inside = shared_.pulse.is_inside};
  const WorkEnding ending = shared_.ending;
  if (stopped_) {
    run.end = *stopped_;
  } else if (WIFSIGNALED(status_)) {
    run.end = SupervisedRun::End::signal;
    run.code = WTERMSIG(status_);
  } else if (ending == WorkEnding::none) {
    run.end = SupervisedRun::End::exit;
    run.code = WEXITSTATUS(status_);
  } else if (output_.size() != shared_.output_bytes) {
    run.end = SupervisedRun::End::lost;
  } else if (ending != WorkEnding::returned) {
    rethrow(ending, output_);
  } else {
    run.code = WEXITSTATUS(status_);
    run.output = output_;
  }
  return run;
}

}  // namespace phytobench
