// SPDX-License-Identifier: MIT
// Does the instrument tell what it should? Base is compared against itself, where it must find
// nothing, on one steady benchmark and on some of the suite as `compare` would; against itself with
// a loss of speed of known size, which it must find; and it is given broken benchmarks, which it
// must refuse. A machine too noisy for an answer is not a broken instrument, but proves nothing,
// either.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/paired_timing.hpp"

namespace phytobench {

struct InstrumentRequest {
  /// This build with its broken benchmarks, each iteration slower by that share.
  std::function<std::unique_ptr<TimedSide>(double handicap)> side;
  int repetitions = 40;       ///< comparisons of base with itself; >= 1
  int slow_repetitions = 10;  ///< comparisons with the handicap; >= 1
  double handicap = 0.1;      ///< > 0
  /// Benchmarks of the suite that base is compared with itself on, together and as `compare` does
  /// by default: blocks until the interval is narrow, p adjusted over them. Empty where there are
  /// no such comparisons.
  std::vector<std::string> usual_names = {};
  int usual_repetitions = 0;  ///< such comparisons; >= 0
  double most_s = 480.0;      ///< no comparison begins later
  std::uint64_t seed = 0;
  /// Of each comparison; its seed is drawn from the one above. Control and comparison of ten blocks
  /// each, always: then all comparisons are alike.
  TimingSettings timing = {
      .budget_s = 60.0, .least_blocks = 10, .most_blocks = 10, .samples = 3, .sample_ms = 5.0};
  /// Of the usual comparisons; all defaults of `compare` but the budget, which is the smaller of
  /// this one and of what gives all of them two fifths of most_s. They begin with as many blocks
  /// as so many benchmarks need.
  TimingSettings usual_timing = {.budget_s = 60.0};
  VerdictSettings verdicts = {};
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
  std::function<double()> stolen_share = {};                   ///< see BlockHooks; may be empty
  std::function<double()> clock_s = {};                        ///< empty: the steady clock
};

/// How often a comparison of two sides of known difference came out how.
struct VerdictTally {
  int slower = 0, faster = 0, same = 0, inconclusive = 0;
  int other = 0;  ///< a wrong answer, or nothing measured

  int all() const { return slower + faster + same + inconclusive + other; }
};

/// A broken benchmark and what became of it.
struct RefusalCheck {
  std::string benchmark;
  std::string demanded;     ///< what must become of it
  std::string found;        ///< what did
  bool is_refused = false;  ///< as demanded, and without a single time
};

struct InstrumentCheck {
  VerdictTally alike;        ///< base against itself
  VerdictTally usual;        ///< the same on benchmarks of the suite; a comparison counts once, by
                             ///< the worst of its verdicts
  VerdictTally handicapped;  ///< base against itself with the handicap
  int wanted_alike = 0;      ///< comparisons that were asked for
  int wanted_usual = 0;
  int wanted_handicapped = 0;
  std::vector<std::string> usual_names;
  double handicap = 0.0;
  double noise_floor = 0.0;     ///< median over all comparisons of the steady benchmark
  double found_handicap = 0.0;  ///< median of the ratios found with the handicap, less 1
  std::vector<RefusalCheck> refusals;
  double seconds = 0.0;
};

/// Throws InputError, beginning with `whose`, for a build with work counters.
void refuse_to_time_counters(const WorkerDescription& description, const std::string& whose);

/// Throws Interrupted and what the sides throw.
InstrumentCheck check_instrument(const InstrumentRequest& request);

}  // namespace phytobench
