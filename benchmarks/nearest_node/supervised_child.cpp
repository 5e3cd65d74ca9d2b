// SPDX-License-Identifier: MIT
#include "benchmarks/nearest_node/supervised_child.hpp"

#include <fcntl.h>
#include <sys/prctl.h>
#include <sys/resource.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <new>

#include "core/contract/errors.hpp"
#include "core/nearest_node/plugin/engine_plugin.hpp"

namespace phytobench {

namespace {

/// The machine's memory, as a limit: a plugin without one would take it all and the system would
/// kill whom it likes. Sanitizers reserve more than any machine has.
void limit_memory() {
#ifndef __SANITIZE_ADDRESS__
  const long pages = ::sysconf(_SC_PHYS_PAGES), page = ::sysconf(_SC_PAGESIZE);
  if (pages <= 0 || page <= 0) return;
  rlimit limit{};
  if (::getrlimit(RLIMIT_DATA, &limit) != 0) return;
  limit.rlim_cur = std::min(limit.rlim_max, static_cast<rlim_t>(pages) * static_cast<rlim_t>(page));
  ::setrlimit(RLIMIT_DATA, &limit);
#endif
}

/// A crash that is reported needs no file that holds the whole memory.
void leave_no_core_file() {
  const rlimit none{0, 0};
  ::setrlimit(RLIMIT_CORE, &none);
}

/// Signals that end a process do so again, whatever handled them before; Ctrl-C stays as it is.
void restore_deadly_signals() {
  for (const int deadly : {SIGSEGV, SIGBUS, SIGFPE, SIGILL, SIGABRT, SIGTRAP, SIGSYS})
    std::signal(deadly, SIG_DFL);
}

/// Nothing to read, and standard error in place of standard output, which belongs to results.
void redirect_standard_files() {
  const int nothing = ::open("/dev/null", O_RDWR);
  ::dup2(nothing, STDIN_FILENO);
  if (::dup2(STDERR_FILENO, STDOUT_FILENO) < 0) ::dup2(nothing, STDOUT_FILENO);
  if (nothing > STDERR_FILENO) ::close(nothing);
}

/// A group of its own, so that nothing it starts outlives it. A terminal that stops groups in the
/// background when they write lets those write that ignore it.
void lead_a_group() {
  ::setpgid(0, 0);
  std::signal(SIGTTOU, SIG_IGN);
}

void write_all(int descriptor, const std::string& text) {
  for (std::size_t done = 0; done < text.size();) {
    const ssize_t wrote = ::write(descriptor, text.data() + done, text.size() - done);
    if (wrote < 0 && errno == EINTR) continue;
    if (wrote <= 0) return;  // the parent is gone, or a plugin closed the pipe
    done += static_cast<std::size_t>(wrote);
  }
}

/// Runs the work and says how it ended. Nothing gets out.
WorkEnding ending_of(const SupervisedWork& work, PluginPulse& pulse, std::string& output,
                     int& code) {
  try {
    code = work(pulse, output);
    return WorkEnding::returned;
  } catch (const InputError& error) {
    output = error.what();
    return WorkEnding::input_error;
  } catch (const EnvironmentError& error) {
    output = error.what();
    return WorkEnding::environment_error;
  } catch (const NothingSelected& error) {
    output = error.what();
    return WorkEnding::nothing_selected;
  } catch (const Interrupted& error) {
    output = error.what();
    return WorkEnding::interrupted;
  } catch (const PluginMisbehaved& error) {
    output = error.what();
    return WorkEnding::misbehaved;
  } catch (const std::bad_alloc&) {
    output = "not enough memory; take fewer points or fewer threads";
    return WorkEnding::environment_error;
  } catch (const std::exception& error) {
    output = error.what();
    return WorkEnding::violation;
  }
}

}  // namespace

void be_child(const SupervisedWork& work, SharedWithChild& shared, int pipe, pid_t parent) {
  lead_a_group();
  ::prctl(PR_SET_PDEATHSIG, SIGKILL);
  if (::getppid() != parent) ::_exit(0);  // it died before that took effect
  // Whoever started this program may have given it no standard files.
  pipe = ::fcntl(pipe, F_DUPFD_CLOEXEC, STDERR_FILENO + 1);
  redirect_standard_files();
  restore_deadly_signals();
  limit_memory();
  leave_no_core_file();
  std::string output;
  int code = 0;
  const WorkEnding ending = ending_of(work, shared.pulse, output, code);
  std::fflush(nullptr);  // what a plugin printed
  shared.output_bytes = output.size();
  write_all(pipe, output);
  shared.ending = ending;
  ::_exit(code);
}

void rethrow(WorkEnding ending, const std::string& what) {
  switch (ending) {
    case WorkEnding::input_error:
      throw InputError(what);
    case WorkEnding::environment_error:
      throw EnvironmentError(what);
    case WorkEnding::nothing_selected:
      throw NothingSelected(what);
    case WorkEnding::interrupted:
      throw Interrupted();
    case WorkEnding::misbehaved:
      throw PluginMisbehaved(what);
    case WorkEnding::none:
    case WorkEnding::returned:
    case WorkEnding::violation:
      break;
  }
  throw ContractViolation(what);
}

}  // namespace phytobench
