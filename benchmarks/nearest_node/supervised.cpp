// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/supervised.hpp"

#include <fcntl.h>
#include <sys/mman.h>
#include <unistd.h>

#include <array>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <new>

#include <fmt/format.h>

#include "benchmarks/nearest_node/supervised_child.hpp"
#include "benchmarks/nearest_node/supervisor.hpp"
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

/// While it lives, ended children wait to be waited for, even if whoever started this program has
/// it ignore their ends: the system would forget them at once.
class ChildrenStay {
 public:
  ChildrenStay() {
    struct sigaction usual {};
    usual.sa_handler = SIG_DFL;
    ::sigaction(SIGCHLD, &usual, &before_);
  }
  ~ChildrenStay() { ::sigaction(SIGCHLD, &before_, nullptr); }
  ChildrenStay(const ChildrenStay&) = delete;
  ChildrenStay& operator=(const ChildrenStay&) = delete;

 private:
  struct sigaction before_ {};
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
    case SupervisedRun::End::overtime:
      return fmt::format("not done after {:g} s, {}", limits.total_s, place);
    case SupervisedRun::End::lost:
      return fmt::format("its result was lost, because it closed files of others (noticed {})",
                         place);
  }
  return {};
}

SupervisedRun run_supervised(const SupervisedWork& work, const SupervisionLimits& limits) {
  PHYTOBENCH_EXPECT(limits.silence_s > 0.0 && limits.total_s > 0.0);
  const ChildrenStay until_reaped;
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
  ::setpgid(child, child);  // as the child does itself: whoever comes first
  write_end.close();
  return Supervisor(child, read_end.number(), *shared, limits).wait();
}

}  // namespace phytobench
