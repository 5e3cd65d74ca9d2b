// SPDX-License-Identifier: MIT
// Instruction counts of one build against those of another. What was counted is kept apart from
// what is concluded from it: judge_instructions() is a pure function.
#pragma once

#include <filesystem>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/comparison/accepted_instructions.hpp"
#include "benchmarks/comparison/instruction_counts.hpp"
#include "benchmarks/comparison/side.hpp"

namespace phytobench {

enum class InstructionVerdict {
  wrong_answer,   ///< the new build's, says the oracle
  failed,         ///< a run of the new build ended without a count
  more,           ///< by more than its limit
  unsupported,    ///< cannot be counted here: no pass, no regression
  accepted,       ///< more, but somebody wanted it
  slightly_more,  ///< by more than 0.2 %, within its limit: a note
  other_work,     ///< inputs or right answers differ: no comparison
  appeared,       ///< base lacks it
  gone,           ///< only base has it
  fewer,          ///< by more than 0.2 %
  same,
  same_binary,  ///< both builds have the same code and data: nothing was run
};

std::string_view name_of(InstructionVerdict verdict);

/// What was found out about one benchmark.
struct CountedPair {
  std::string benchmark;
  bool is_in_base = true;
  bool is_in_new = true;
  bool is_same_binary = false;
  std::string objection;        ///< of the oracle to the new side's answer
  std::string verified_answer;  ///< of the new build, that the oracle let pass; empty: not known
  InstructionCount base;        ///< without meaning where a side lacks it
  InstructionCount other;
  std::vector<double> earlier_changes;  ///< relative, of earlier comparisons: 0.01 is 1 %
};

struct InstructionRules {
  double least_limit = 0.01;      ///< an increase up to this never fails
  double noted = 0.002;           ///< a change up to this is none
  std::size_t least_history = 8;  ///< fewer earlier changes are no history
};

struct JudgedInstructions {
  std::string benchmark;
  InstructionVerdict verdict = InstructionVerdict::failed;
  std::string reason;            ///< one clause; may be empty
  std::optional<double> change;  ///< relative: 0.05 is 5 % more; where both were counted
  double limit = 0.0;            ///< that fails when exceeded, relative
  CountedPair pair;
};

/// max(least limit, Q3 + 3 IQR of the sizes of earlier changes): a benchmark whose counts have
/// always moved may move, after rustc-perf.
double change_limit(std::span<const double> earlier_changes, const InstructionRules& rules = {});

JudgedInstructions judge_instructions(const CountedPair& pair,
                                      const std::vector<AcceptedIncrease>& accepted,
                                      std::string_view base_commit,
                                      const InstructionRules& rules = {});

/// Whether a verdict stops a merge.
bool is_failure(InstructionVerdict verdict);

/// 1 if any fails, 3 if any is unsupported, 4 if nothing was compared at all, else 0.
int exit_code_of(const std::vector<JudgedInstructions>& judged);

/// One build to count.
struct CountedBuild {
  std::filesystem::path worker;
  std::filesystem::path data;
  std::vector<std::string> benchmarks;  ///< that it has, of those that are wanted
};

/// Of a side that is built, with its share folder where one is found.
CountedBuild counted_build(const Side& side, std::vector<std::string> benchmarks);

struct InstructionGateRequest {
  CountedBuild base;
  CountedBuild other;
  bool is_same_binary = false;
  int threads = 1;  ///< processes at a time; counts are the same for any number
  bool simulate_cache = false;
  /// Objection of the oracle to an answer of the new build, empty if it is right; by name.
  std::function<std::string(const std::string&)> objection_to = {};
  /// The answer that was right, empty if it is not known; by name. May be empty.
  std::function<std::string(const std::string&)> verified_answer_of = {};
  /// See CountedPair::earlier_changes; may be empty.
  std::function<std::vector<double>(const std::string&)> earlier_changes = {};
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

/// Counts every benchmark of either build, in the order of names. Throws Interrupted.
std::vector<CountedPair> count_pairs(const InstructionGateRequest& request);

}  // namespace phytobench
