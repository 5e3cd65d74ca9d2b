// SPDX-License-Identifier: MIT
// Several runs of the same suite - on other machines, with other compilers - side by side, and as
// one. Each run is judged alone; nothing is computed across runs, so that a ratio of times never
// mixes two machines.
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Whether the verdict says that a claim holds or that it does not.
bool is_decided(Verdict verdict);

/// A run and what tells it from the others.
struct LabelledRun {
  std::string label;  ///< "GCC 12.2.0 on AMD EPYC"; no two are equal
  JudgedRun judged;
  std::string folder = {};  ///< as the user named it; empty: not to be shown
};

/// The short name of the run in that place, from 0: A to Z, then AA, AB and so on.
std::string run_letter(std::size_t place);

/// The verdict of several runs on one claim.
struct MergedVerdict {
  Verdict verdict = Verdict::not_measured;
  std::size_t run = 0;  ///< the first run that says so; of a contradiction the first to decide
  bool contradicted = false;  ///< two runs decided it differently
};

/// Decided by no run: the one that says most about
/// why, inconclusive before the rest. Decided alike wherever decided: that. Else inconclusive.
MergedVerdict merged_verdict(std::span<const Verdict> verdicts);

struct ComparedClaim {
  std::string id;
  std::vector<Verdict> verdicts;      ///< of each run
  std::vector<std::string> measured;  ///< by each run
  Verdict merged = Verdict::not_measured;
  bool contradicted = false;
  bool varies = false;  ///< rests on times
};

/// A measurement that is not the same in all runs that have it.
struct DifferingRecord {
  std::string experiment;
  std::string measurement;
  std::vector<std::optional<std::string>> values;  ///< of each run that has it
  std::optional<double> relative;  ///< largest difference over the larger magnitude; numbers only
};

struct RecordComparison {
  std::size_t in_all = 0;  ///< measurements that all runs have
  std::size_t shared = 0;  ///< that at least two runs have
  std::size_t equal = 0;   ///< of those, the same bit for bit in each run that has them
  /// The others of those, experiment by experiment: the one with the largest relative difference
  /// first, and so within each; what has no such difference (texts) comes last.
  std::vector<DifferingRecord> differing;
  std::vector<std::size_t> only_in;                   ///< for each run, those that no other has
  std::map<std::string, std::size_t> shared_of = {};  ///< the shared ones by experiment
};

struct ComparedRun {
  std::string label;
  RunContents contents;
  std::string folder = {};  ///< as the user named it; empty: not to be shown
};

struct RunComparison {
  std::vector<ComparedRun> runs;
  std::vector<ComparedClaim> claims;  ///< in the order of the papers and their claims
  RecordComparison records;
};

/// What several runs say together, in the shape of one.
struct MergedRuns {
  JudgedRun judged;
  RunComparison comparison;
};

/// Of at least two runs. A claim has the merged verdict and the evidence of the run that gives it;
/// a contradicted one has the evidence of all, which calls the runs by their letters. Tables,
/// studies and experiments are those of the first run that has them.
MergedRuns merge_runs(std::vector<LabelledRun> runs);

/// Value, unit, size and spread of each sample, bit for bit; seeds are not compared.
RecordComparison compare_records(std::span<const RunContents* const> runs);

}  // namespace phytobench
