// SPDX-License-Identifier: MIT
// How many instructions a benchmark takes, counted by Callgrind: the same number at every run of
// one program, however busy the machine is.
#pragma once

#include <cstdint>
#include <filesystem>
#include <functional>
#include <optional>
#include <string>

namespace phytobench {

/// Of a simulated cache: 32 KiB at the first level, 8 MiB at the last, lines of 64 bytes, whatever
/// this machine has.
struct CacheMisses {
  std::uint64_t first_level_data = 0;
  std::uint64_t last_level = 0;  ///< of instructions and data
  friend bool operator==(const CacheMisses&, const CacheMisses&) = default;
};

struct CallgrindTotals {
  std::uint64_t instructions = 0;
  std::optional<CacheMisses> misses;  ///< where a cache was simulated
  friend bool operator==(const CallgrindTotals&, const CallgrindTotals&) = default;
};

/// The totals of a file that Callgrind has written (its format: "events:" names the columns of
/// "totals:", the last line). Throws InputError that begins with `whose` for a file that breaks
/// off, holds several counts, or is something else.
CallgrindTotals callgrind_totals_from(const std::string& text, const std::string& whose);

enum class CountOutcome {
  counted,
  unsupported,  ///< cannot be counted here: that is no pass
  failed,       ///< the program itself does not do what it should
};

struct InstructionCount {
  CountOutcome outcome = CountOutcome::failed;
  std::string reason;      ///< one clause; empty if counted
  CallgrindTotals totals;  ///< zero unless counted
  std::string inputs;      ///< SHA-256 of the run's inputs; empty unless counted
  std::string answer;      ///< SHA-256 of what came out, not judged; the same
};

struct CountRequest {
  std::filesystem::path worker;  ///< a phytobench_worker
  std::filesystem::path data;    ///< its share folder; empty: the worker finds its own
  std::string benchmark;
  bool simulate_cache = false;  ///< takes twice as long
  double limit_s = 300.0;
  std::function<bool()> is_interrupted = {};
};

/// Runs the worker under Valgrind, with fixed addresses, environment and paths of fixed length:
/// builds in other folders count alike. May be called from several threads at once. Throws
/// Interrupted, and EnvironmentError where no temporary folder can be made.
InstructionCount count_instructions(const CountRequest& request);

}  // namespace phytobench
