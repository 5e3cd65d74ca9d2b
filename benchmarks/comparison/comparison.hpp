// SPDX-License-Identifier: MIT
// Is one build slower than another? What was measured, kept apart from what is concluded from it:
// measure_*() fills Measured, conclude() is a pure function of it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/statistics/estimate.hpp"

namespace phytobench {

/// One side of a comparison.
struct SideOrigin {
  std::string given;     ///< as the user named it
  std::string kind;      ///< "revision", "build", "plugin", "result"
  std::string commit;    ///< empty if unknown
  bool changed = false;  ///< its sources differ from that commit
  std::string compiler;
  std::string flags;
  std::string program_digest;  ///< of its worker's code and data; empty for results
};

/// Seconds per iteration: one number for each process, the median of its samples.
struct BlockTimes {
  int block = 0;              ///< 0-based
  std::string order;          ///< "ABBA" or "BAAB"
  std::vector<double> base;   ///< two processes
  std::vector<double> other;  ///< two processes
  int redone = 0;             ///< how often it was thrown away because the machine was busy

  /// Log ratio other / base: (ln B1 + ln B2 - ln A1 - ln A2) / 2. In it cancels what the processes
  /// of the block share, and in either order what grows evenly from one to the next. Two positive,
  /// finite times of each side; ContractViolation otherwise.
  double log_ratio() const;
};

/// All that was measured of one benchmark.
struct MeasuredBenchmark {
  std::string name;
  std::string objection;     ///< why nothing was timed; a wrong answer, or none because the worker
                             ///< died, if it is the same work
  bool is_same_work = true;  ///< false: nothing to compare; inputs or right answers differ, one
                             ///< side does not have it, or a run takes no time
  std::vector<BlockTimes> control;  ///< base against itself
  std::vector<BlockTimes> blocks;   ///< base against new
};

struct Measured {
  SideOrigin base;
  SideOrigin other;
  std::uint64_t seed = 0;
  bool is_same_program = false;  ///< both workers have the same code and data
  std::vector<MeasuredBenchmark> benchmarks;
};

enum class SpeedVerdict {
  slower,
  faster,
  same,              ///< the whole interval lies within the tolerance
  inconclusive,      ///< too noisy to say
  same_binary,       ///< nothing to compare
  nothing_measured,  ///< not a pass
  wrong_answer,      ///< refused, with all its times; also where new's workers die of it
};

std::string_view name_of(SpeedVerdict verdict);

/// Why nothing was measured where base is to blame: the benchmark is new, or was wrong before, or
/// died before.
inline constexpr std::string_view only_new_has_it = "base does not have it";
inline constexpr std::string_view base_is_wrong = "base is wrong: ";  ///< and how

struct VerdictSettings {
  double tolerance = 0.03;    ///< a change of less does not matter; > 0
  double alpha = 0.05;        ///< of the test, over all benchmarks together; in (0, 1)
  double noise_factor = 1.0;  ///< a change must exceed so many times the noise floor; >= 0
  int least_blocks = 8;       ///< of fewer, or of fewer of the control, nothing is concluded; >= 1
  int resamples = 10000;      ///< of the bootstrap of each interval; > 0
};

struct ConcludedBenchmark {
  std::string name;
  SpeedVerdict verdict = SpeedVerdict::nothing_measured;
  std::string reason;               ///< one clause
  std::optional<Estimate> ratio;    ///< new / base with its 95 % interval; none of too few blocks
  std::optional<Estimate> control;  ///< base / base, likewise
  double noise_floor = 0.0;         ///< how far from 1 the control's interval reaches: 0.02
  /// Of Wilcoxon's signed-rank test towards the side of the ratio, doubled because either side
  /// could have been it, adjusted over all benchmarks so tested (Benjamini and Hochberg 1995). 1
  /// where nothing was tested.
  double p = 1.0;
  std::size_t blocks = 0;
};

/// Whether nothing was measured, and base is the reason.
bool is_base_to_blame(const ConcludedBenchmark& benchmark);

/// The verdicts on what was measured, in its order. Intervals are those of the bootstrapped median
/// of the blocks' log ratios. A benchmark is
///   slower or faster  if its whole interval is beyond the tolerance and beyond the noise floor (as
///                     often as settings.noise_factor says), and p < alpha;
///   same              if its whole interval lies within the tolerance, and the control's, too;
///   inconclusive      else, and whatever it shows where the control shows a change beyond the
///                     tolerance that cannot be.
/// Signs of block ratios are fair coins where both sides are alike and the orders of the blocks
/// were drawn, so p holds for any law of the noise. ContractViolation for settings out of range.
std::vector<ConcludedBenchmark> conclude(const Measured& measured,
                                         const VerdictSettings& settings = {});

/// Blocks of which p can fall below alpha if but one of so many benchmarks has changed: at best it
/// is 2^(1 - blocks) times their number. At least settings.least_blocks. Fewer can only give
/// "same" and "inconclusive": 8 are enough for 6 benchmarks, 10 for 25, 12 for 102.
int blocks_needed(std::size_t benchmarks, const VerdictSettings& settings = {});

}  // namespace phytobench
