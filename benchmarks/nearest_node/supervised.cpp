// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/supervised.hpp"

#include <fcntl.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

#include <fmt/format.h>

#include "benchmarks/nearest_node/supervised_child.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

/// Memory that parent and child both see.
class SharedMemory {
 public:
  SharedMemory() {
    void* memory = ::mmap(nullptr, sizeof(SharedWithChild), PROT_READ | PROT_WRITE,
                          MAP_SHARED | MAP_ANONYMOUS, -1, 0);
    if (memory == MAP_FAILED) throw EnvironmentError("no memory to share with a child process");
    shared_ = new (memory) SharedWithChild;
  }
  ~SharedMemory() { ::munmap(shared_, sizeof(SharedWithChild)); }
  SharedMemory(const SharedMemory&) = delete;
  SharedMemory& operator=(const SharedMemory&) = delete;

  SharedWithChild& operator*() const { return *shared_; }
  SharedWithChild* operator->() const { return shared_; }

 private:
  SharedWithChild* shared_;
};

/// Closed when it goes.
class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) {}
  ~Descriptor() { close(); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;

  int number() const { return number_; }
  void close() {
    if (number_ >= 0) ::close(number_);
    number_ = -1;
  }

 private:
  int number_;
};

/// Looks after one child until it has ended.
class Supervisor {
 public:
  Supervisor(pid_t child, int pipe, const SharedWithChild& shared, const SupervisionLimits& limits)
      : child_(child), pipe_(pipe), shared_(shared), limits_(limits) {}

  /// Reaps a child that is still there: something was thrown.
  ~Supervisor() {
    if (!is_reaped_) end_child();
  }
  Supervisor(const Supervisor&) = delete;
  Supervisor& operator=(const Supervisor&) = delete;

  SupervisedRun wait() {
    bool is_silent = false;
    while (!has_ended()) {
      read_output(look_every_ms);
      if (limits_.is_interrupted && limits_.is_interrupted()) throw Interrupted();
      is_silent = has_been_silent_too_long();
      if (is_silent) end_child();
    }
    while (read_output(0)) {
    }
    return outcome(is_silent);
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr int look_every_ms = 100;

  bool has_ended() {
    if (!is_reaped_) is_reaped_ = ::waitpid(child_, &status_, WNOHANG) == child_;
    return is_reaped_;
  }

  void end_child() {
    ::kill(child_, SIGKILL);
    while (::waitpid(child_, &status_, 0) < 0 && errno == EINTR) {
    }
    is_reaped_ = true;
  }

  /// Waits for output, or for the child's end, at most so long. True if there was some.
  bool read_output(int milliseconds) {
    pollfd wanted{is_open_ ? pipe_ : -1, POLLIN, 0};
    // Once the pipe is closed, only the time counts.
    if (::poll(&wanted, 1, is_open_ ? milliseconds : std::min(milliseconds, 5)) <= 0) return false;
    std::array<char, 65536> buffer;
    const ssize_t count = ::read(pipe_, buffer.data(), buffer.size());
    if (count > 0) output_.append(buffer.data(), static_cast<std::size_t>(count));
    if (count == 0) is_open_ = false;
    return count > 0;
  }

  /// Only a plugin's call is limited: our own work may take its time.
  bool has_been_silent_too_long() {
    const std::uint64_t beats = shared_.pulse.beats;
    if (beats != beats_ || !shared_.pulse.is_inside) {
      beats_ = beats;
      since_ = Clock::now();
      return false;
    }
    return std::chrono::duration<double>(Clock::now() - since_).count() > limits_.silence_s;
  }

  SupervisedRun outcome(bool is_silent) const {
    SupervisedRun run{.plugin = shared_.pulse.plugin,
                      .call = shared_.pulse.call,
                      .number = shared_.pulse.number,
                      .was_inside = shared_.pulse.is_inside};
    const WorkEnding ending = shared_.ending;
    if (is_silent) {
      run.end = SupervisedRun::End::silence;
    } else if (WIFSIGNALED(status_)) {
      run.end = SupervisedRun::End::signal;
      run.code = WTERMSIG(status_);
    } else if (ending == WorkEnding::none) {
      run.end = SupervisedRun::End::exit;
      run.code = WEXITSTATUS(status_);
    } else if (ending != WorkEnding::returned) {
      rethrow(ending, output_);
    } else {
      run.code = WEXITSTATUS(status_);
      run.output = output_;
    }
    return run;
  }

  pid_t child_;
  int pipe_;
  const SharedWithChild& shared_;
  const SupervisionLimits& limits_;
  int status_ = 0;
  bool is_reaped_ = false;
  bool is_open_ = true;
  std::string output_;
  std::uint64_t beats_ = 0;
  Clock::time_point since_ = Clock::now();
};

std::string signal_name(int signal) {
  const char* name = ::sigabbrev_np(signal);
  return name != nullptr ? fmt::format("SIG{}", name) : fmt::format("signal {}", signal);
}

}  // namespace

std::string described(const SupervisedRun& run, const SupervisionLimits& limits) {
  const std::string place =
      fmt::format("{} {}", run.was_inside ? "in" : "after", described(run.call, run.number));
  switch (run.end) {
    case SupervisedRun::End::finished:
      return "finished";
    case SupervisedRun::End::signal:
      return fmt::format("{} {}", signal_name(run.code), place);
    case SupervisedRun::End::exit:
      return fmt::format("ended the program with exit code {} {}", run.code, place);
    case SupervisedRun::End::silence:
      return fmt::format("no answer for {:g} s {}", limits.silence_s, place);
  }
  return {};
}

SupervisedRun run_supervised(const SupervisedWork& work, const SupervisionLimits& limits) {
  PHYTOBENCH_EXPECT(limits.silence_s > 0.0);
  SharedMemory shared;
  std::array<int, 2> ends{};
  if (::pipe2(ends.data(), O_CLOEXEC) != 0)
    throw EnvironmentError("no pipe to a child process; close other programs and try again");
  const Descriptor read_end(ends[0]);
  Descriptor write_end(ends[1]);
  std::fflush(nullptr);  // or the child would write it once more
  const pid_t parent = ::getpid();
  const pid_t child = ::fork();
  if (child < 0)
    throw EnvironmentError("cannot start a child process; close other programs and try again");
  if (child == 0) be_child(work, *shared, write_end.number(), parent);
  write_end.close();
  return Supervisor(child, read_end.number(), *shared, limits).wait();
}

}  // namespace phytobench
