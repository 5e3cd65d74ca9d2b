// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reference/assumptions.hpp"
#include "reference/errata.hpp"
#include "reference/papers.hpp"
#include "reports/judge/judge.hpp"
#include "reports/judge/scaling.hpp"

namespace phytobench {

/// Another quantity of a table's cells: work counters, phases.
struct JudgedCompanion {
  std::string name;
  bool timed = false;
  std::vector<std::vector<MedianOfRounds>> values;
};

/// A published table beside what was measured, in its own layout.
struct JudgedTable {
  const PublishedTable* table = nullptr;
  bool measured = false;                             ///< every cell has evidence
  bool timed = false;                                ///< cells are times
  std::vector<std::vector<MedianOfRounds>> values;   ///< per row and column
  std::vector<std::vector<double>> published_share;  ///< of the largest published cell
  std::vector<std::vector<MedianOfRounds>>
      share;                                ///< of the largest measured cell, paired by round
  std::vector<JudgedCompanion> companions;  ///< those with evidence in every cell
  std::vector<std::vector<double>>
      published_per;                              ///< published value per unit of work; empty: none
  std::vector<std::vector<double>> measured_per;  ///< median per unit of work; empty: none
};

struct JudgedPaper {
  Paper paper;
  PaperClaims claims;
  std::vector<Erratum> errata;
  std::vector<Assumption> assumptions;
  std::vector<Judgement> judgements;  ///< in the order of the claims
  std::vector<JudgedTable> tables;
};

/// Everything a report prints.
struct JudgedRun {
  RunContents run;
  std::vector<JudgedPaper> papers;
  JudgedScaling scaling;
};

/// Judges all claims of all papers on the evidence of a run.
JudgedRun judge_run(RunContents run);

/// The judgement of a table alone (a pure function, for tests).
JudgedTable judge_table(const PublishedTable& table, const Evidence& evidence);

}  // namespace phytobench
