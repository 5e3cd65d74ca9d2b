// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/start_child.hpp"

#include <fcntl.h>
#include <sched.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstring>
#include <string_view>

#include <fmt/format.h>

#include "benchmarks/comparison/found_program.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

[[noreturn]] void fail_to_start(const std::string& program, int error) {
  throw EnvironmentError(fmt::format("{} cannot be started: {}", program, std::strerror(error)));
}

std::vector<std::string> environment_of(const ChildOptions& options) {
  std::vector<std::string> variables;
  const auto is_changed = [&](std::string_view variable) {
    const std::string_view name = variable.substr(0, variable.find('='));
    return std::any_of(options.environment.begin(), options.environment.end(),
                       [&](const EnvironmentChange& change) { return change.first == name; });
  };
  if (options.inherited == InheritedEnvironment::everything)
    for (char** variable = environ; *variable != nullptr; ++variable)
      if (!is_changed(*variable)) variables.emplace_back(*variable);
  for (const auto& [name, value] : options.environment)
    if (value) variables.push_back(name + "=" + *value);
  return variables;
}

std::vector<char*> pointers_to(std::vector<std::string>& texts) {
  std::vector<char*> pointers;
  for (std::string& text : texts) pointers.push_back(text.data());
  pointers.push_back(nullptr);
  return pointers;
}

/// Everything the new process needs, ready before the fork: after it nothing may be allocated,
/// since another thread may have held the lock of the heap.
struct Start {
  const char* program = nullptr;
  char* const* argv = nullptr;
  char* const* envp = nullptr;
  const char* folder = nullptr;  ///< nullptr: stay
  int streams[3] = {-1, -1, -1};
  int report = -1;  ///< gets errno if the program cannot be started
  pid_t parent = 0;
  bool is_pinned = false;
  cpu_set_t processors{};
};

/// False, with errno, if something is refused.
bool settle(const Start& start) {
  sigset_t none;
  sigemptyset(&none);
  ::sigprocmask(SIG_SETMASK, &none, nullptr);
  for (const int signal : {SIGINT, SIGTERM, SIGPIPE}) ::signal(signal, SIG_DFL);
  for (int target = 0; target < 3; ++target)
    if (::dup2(start.streams[target], target) < 0 || ::fcntl(target, F_SETFD, 0) < 0) return false;
  if (start.folder != nullptr && ::chdir(start.folder) != 0) return false;
  return !start.is_pinned ||
         ::sched_setaffinity(0, sizeof start.processors, &start.processors) == 0;
}

[[noreturn]] void become(const Start& start) {
  ::setpgid(0, 0);
  // It does not outlive us, not even if we are killed.
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != start.parent) ::_exit(127);
  if (settle(start)) ::execve(start.program, start.argv, start.envp);
  const int error = errno;
  const ssize_t written = ::write(start.report, &error, sizeof error);
  ::_exit(written == static_cast<ssize_t>(sizeof error) ? 127 : 126);
}

}  // namespace

pid_t start_child(const ChildOptions& options, const ChildStreams& streams) {
  const std::optional<std::filesystem::path> found = found_program(options.command.front());
  if (!found)
    throw EnvironmentError(options.command.front() +
                           " is missing or cannot be run; install it, or check PATH");
  const std::string program = found->string();
  std::vector<std::string> words = options.command, variables = environment_of(options);
  const std::vector<char*> argv = pointers_to(words), envp = pointers_to(variables);
  int ends[2] = {-1, -1};
  if (::pipe2(ends, O_CLOEXEC) != 0) fail_to_start(program, errno);
  Descriptor read_end(ends[0]), write_end(ends[1]);
  Start start{.program = program.c_str(),
              .argv = argv.data(),
              .envp = envp.data(),
              .folder = options.folder.empty() ? nullptr : options.folder.c_str(),
              .streams = {streams.number(0), streams.number(1), streams.number(2)},
              .report = write_end.number(),
              .parent = ::getpid(),
              .is_pinned = options.processor.has_value()};
  if (options.processor) CPU_SET(static_cast<std::size_t>(*options.processor), &start.processors);

  const pid_t child = ::fork();
  if (child < 0) fail_to_start(program, errno);
  if (child == 0) become(start);
  write_end.close();
  int error = 0;
  ssize_t size = 0;
  while ((size = ::read(read_end.number(), &error, sizeof error)) < 0 && errno == EINTR) continue;
  if (size == 0) return child;
  ::waitpid(child, nullptr, 0);
  fail_to_start(program, error);
}

}  // namespace phytobench
