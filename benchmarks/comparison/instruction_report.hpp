// SPDX-License-Identifier: MIT
// What the gate on instruction counts has to say, for a terminal, a merge request, a test runner
// and programs.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"
#include "benchmarks/comparison/instruction_gate.hpp"

namespace phytobench {

struct InstructionReport {
  SideOrigin base;
  SideOrigin other;
  std::vector<JudgedInstructions> judged;
};

/// "1 more, 20 same of 21 benchmarks"; "more" is there even if none is.
std::string counts_in_words(const InstructionReport& report);

/// A line for each benchmark, from the verdict that matters most; then one with the misses of each
/// for which a cache was simulated.
std::string instruction_table(const InstructionReport& report);

/// The same for a merge request or the summary of a job, without misses; below 60,000 bytes.
std::string instruction_markdown(const InstructionReport& report);

/// What stops a merge has failed, what could not be counted or compared was skipped.
std::string instruction_junit(const InstructionReport& report);

/// Schema "phytobench/instructions-1".
std::string instruction_json(const InstructionReport& report);

}  // namespace phytobench
