// SPDX-License-Identifier: MIT
// Is an engine from outside fit to be raced? Found out where it can do no harm.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/nearest_node/awkward_seedlings.hpp"
#include "benchmarks/nearest_node/supervised.hpp"

namespace phytobench {

struct PluginVerdict {
  enum class Kind {
    exact,    ///< every answer is the literal oracle's, and the memory came back
    wrong,    ///< an answer is not, or cannot be; or it changed what is not its own: the
              ///< floating-point environment, files
    crashed,  ///< a signal, or it ended the program
    hangs,    ///< a call did not return in time, or all together took too long
    leaks,    ///< each growth leaves memory behind
    refused,  ///< could not be loaded, or its table is not as phytobench_engine.h says
  };

  Kind kind = Kind::refused;
  std::string engine;  ///< its name; empty if it did not live long enough to tell
  std::string detail;  ///< one line: where and what

  bool is_exact() const { return kind == Kind::exact; }
};

/// "exact", "wrong", "crashed", "hangs", "leaks", "refused".
std::string_view name_of(PluginVerdict::Kind kind);

/// Small trees that tell right from wrong: ties, repeated points, no limit of influence, and the
/// test tree. Throws as scaled_test_tree() does.
std::vector<NamedSeedling> trial_seedlings();

/// Grows each seedling with immediate and with deferred removal, and once more with two threads,
/// comparing every answer; makes calls that no growth makes (wrong_in_unusual_calls()); then grows
/// the last seedling six times, watching memory. All of that may take limits.total_s, but no longer
/// than 20 calls may (a minute, if that is longer). In a child process: call it before this process
/// starts any thread (see run_supervised(), whose exceptions for the system and for Ctrl-C this
/// lets through).
PluginVerdict try_plugin(const std::filesystem::path& file,
                         const std::vector<NamedSeedling>& seedlings,
                         const SupervisionLimits& limits = {});

/// The same on trial_seedlings().
PluginVerdict try_plugin(const std::filesystem::path& file, const SupervisionLimits& limits = {});

/// What a run that did not finish says of the plugin that was called last. Without its name.
PluginVerdict verdict_on_unfinished(const SupervisedRun& run, const SupervisionLimits& limits);

/// Memory after each of several equal growths, in bytes.
struct MemoryAfterGrowths {
  std::vector<double> heap;      ///< allocated and not freed; empty where unknown
  std::vector<double> resident;  ///< given by the system; empty where unknown
  double working = 0.0;          ///< the most that a growth held
};

/// Bytes that each growth leaves behind; 0 if none. Only what each of the last four growths added
/// counts, so that caches may fill. Of the heap, where every byte is known, that is a leak if it is
/// more than 1 % of the working memory or more than 1 KiB; less than 64 bytes is bookkeeping. Of
/// the resident memory, which comes in pages, if it is more than 1 % and more than 256 KiB.
double leaked_per_growth(const MemoryAfterGrowths& memory);

}  // namespace phytobench
