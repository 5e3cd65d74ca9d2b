// SPDX-License-Identifier: MIT
// Code from outside runs in a child process, where it can neither crash nor hang the program.
#pragma once

#include <functional>
#include <limits>
#include <string>

#include "core/nearest_node/plugin/plugin_pulse.hpp"

namespace phytobench {

struct SupervisionLimits {
  double silence_s = 30.0;  ///< a single call of a plugin may take so long; > 0
  double total_s = std::numeric_limits<double>::infinity();  ///< and the whole work so long; > 0
  std::function<bool()> is_interrupted = {};                 ///< may be empty
};

/// How a child ended.
struct SupervisedRun {
  enum class End {
    finished,  ///< the work returned
    signal,    ///< it was killed
    exit,      ///< it ended itself in the middle of the work
    silence,   ///< a plugin did not return; it was killed then
    overtime,  ///< the work took too long altogether; it was killed then
    lost,      ///< the work returned, but its output did not arrive: the pipe was closed
  };

  End end = End::finished;
  int code = 0;                        ///< what the work returned, the signal, or the exit code
  std::string output;                  ///< of finished work
  std::int32_t plugin = 0;             ///< whose call was the latest
  PluginCall call = PluginCall::none;  ///< the latest call
  std::int32_t number = 0;             ///< of that call
  bool was_inside = false;             ///< it had not returned from it
};

/// "SIGSEGV in associate() in iteration 3", "no answer for 30 s in create()", "ended the program
/// with exit code 0 after destroy()": what happened to a run that did not finish.
std::string described(const SupervisedRun& run, const SupervisionLimits& limits);

/// What shall be done: fills the output and returns a code from 0 to 99.
using SupervisedWork = std::function<int(PluginPulse& pulse, std::string& output)>;

/// Does the work in a forked child and waits for it. What the work throws is thrown here, as the
/// same type where it is one of errors.hpp or PluginMisbehaved. The child reads nothing from
/// standard input, writes to standard error where it would write to standard output, leaves the
/// program without its exit handlers, may take no more memory than the machine has, and dies with
/// its parent. It has a process group of its own: Ctrl-C reaches this process alone, and whatever
/// the child has started ends with it. Throws Interrupted when asked to stop, and EnvironmentError
/// where the system refuses a process or does not tell how it ended.
///
/// Call it before this process has started any thread: a child has only the thread that forked it,
/// and would wait for the others for ever (oneTBB's, as soon as work is shared out).
SupervisedRun run_supervised(const SupervisedWork& work, const SupervisionLimits& limits);

}  // namespace phytobench
