// SPDX-License-Identifier: MIT
// Times two builds against each other, in turns, on one machine: first base against itself, which
// shows how much this machine makes equal things differ, then base against new. Nothing is
// concluded here; what is stopped early is stopped by the width of its interval, never by what it
// says.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/timed_side.hpp"

namespace phytobench {

/// The objection to a benchmark whose run is over before a clock can tell.
inline constexpr std::string_view no_time_to_measure = "a run takes no time that can be measured";

struct TimingSettings {
  std::uint64_t seed = 0;   ///< of the order of processes and all that they draw
  double budget_s = 300.0;  ///< of all blocks together, at most half of it for the control; each
                            ///< has one block whatever it takes. Answers are judged before.
  int least_blocks = 8;     ///< of control and comparison each, unless the budget ends before; >= 6
  int most_blocks = 60;     ///< at least as many
  int samples = 5;          ///< of each benchmark in each process; >= 1
  double sample_ms = 10.0;  ///< length of a sample, roughly; > 0
  double tolerance = 0.03;  ///< a benchmark is done when half its 95 % interval, of the median of
                            ///< log ratios, is below log(1 + tolerance) / 2
};

struct PairRequest {
  TimedSide* base = nullptr;
  TimedSide* other = nullptr;
  SideOrigin base_origin;
  SideOrigin other_origin;
  std::vector<std::string> names;  ///< benchmarks; one that a side lacks is reported as such
  bool is_same_program = false;    ///< both have equal code: answers are judged, nothing is timed
  TimingSettings settings;
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
  std::function<double()> stolen_share = {};                   ///< see BlockHooks; may be empty
  std::function<double()> clock_s = {};                        ///< empty: the steady clock
};

/// All samples of one benchmark in one process.
struct ProcessSamples {
  std::string benchmark;
  bool is_control = false;
  int block = 0;
  int position = 0;        ///< 0 to 3, in the order of the block
  bool is_second = false;  ///< B: new, and base once more in the control
  SampledBenchmark sampled;
};

/// What conclude() needs, and what else is worth keeping.
struct PairTiming {
  Measured measured;
  std::vector<ProcessSamples> samples;          ///< of blocks that were kept, as they were taken
  std::vector<CalibratedBenchmark> calibrated;  ///< on base, for both
  int redone_blocks = 0;         ///< thrown away, with both sides, because the machine was busy
  int busy_blocks = 0;           ///< kept although it was: it had been busy before, too
  int dead_blocks = 0;           ///< thrown away, with both sides, because a worker died in it
  double seconds = 0.0;          ///< that all blocks took
  bool was_interrupted = false;  ///< blocks that were finished before are kept
};

/// A block in which a worker dies is thrown away and measured again, see WorkerDeaths; a benchmark
/// that is given up has an objection that names the side, and where that is base it is not the same
/// work. Throws Interrupted while there is no block to keep, and what the sides throw besides.
/// ContractViolation for settings outside their ranges.
PairTiming measure_pair(const PairRequest& request);

}  // namespace phytobench
