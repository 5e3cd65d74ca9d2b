// SPDX-License-Identifier: MIT
// The whole of a comparison, schema phytobench/comparison-1:
//   base, new      {given, kind, commit, changed, compiler, flags, program_digest}
//   same_program   whether both have the same code and data; nothing is timed then
//   seed           of the order of processes and all that they drew
//   settings       {tolerance, alpha, noise_factor, budget_s, least_blocks, most_blocks, samples,
//                  sample_ms}
//   run            {seconds, redone_blocks, busy_blocks, dead_blocks, interrupted}
//   summary        one line
//   counts         {slower, faster, same, inconclusive, same_binary, nothing_measured,
//                  wrong_answer}
//
//   differences    [sentences]: in what the sides differ besides their sources
//   advice, notes  [sentences]
//   failed_trials  [{side, given, verdict, detail}]: plugins that were not fit to be timed; nothing
//                  was then, and there are no benchmarks
//   benchmarks     [{name, verdict, reason, objection, same_work, ratio, control, noise_floor, p,
//                  iterations, blocks, control_blocks}]
//   results        {base, new}: of a side that was timed alone, because the other one was stored,
//                  the whole phytobench/result-1 with all samples (stored_result.hpp), else null
//   environment    as in a run's environment.json, or null
// ratio and control are {value, low, high}, new / base and base / base with 95 % intervals, or
// null. noise_floor is a share: 0.01 is one per cent. Blocks are {block, order, redone, log_ratio,
// base_s, new_s, processes}: base_s and new_s have a number for each process, the median of its
// samples in seconds per iteration; in control blocks both are base. processes are the four in
// their order, {side, involuntary_switches, samples}, with samples as [iterations, processor
// seconds of all iterations, the same by the clock].
#pragma once

#include <string>

#include "benchmarks/comparison/comparison_report.hpp"

namespace phytobench {

inline constexpr const char* comparison_schema = "phytobench/comparison-1";

/// One document with a line end.
std::string comparison_json(const ComparisonReport& report);

}  // namespace phytobench
