// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include "benchmarks/history/history_file.hpp"

namespace phytobench {

/// A value that both runs have.
struct HistoryChange {
  HistoryValue before;
  HistoryValue after;
  bool has_same_inputs = true;  ///< false: it was counted or timed on something else

  bool is_equal() const { return before.number() == after.number(); }

  /// after / before - 1; infinite for what was zero before, and 0 where both are.
  double relative() const;
};

struct HistoryChanges {
  std::vector<HistoryChange> values;  ///< in the order of `before`
  std::size_t only_before = 0;        ///< values that one run has alone
  std::size_t only_after = 0;
  std::size_t ratios_left_out = 0;  ///< of both, but of different machine classes
  std::string caution;              ///< why instructions may differ without reason; empty if not
};

/// What changed between two runs. Pure. Counters and instructions are compared exactly; ratios only
/// within one machine class.
HistoryChanges changes_between(const HistoryRun& before,
                               const std::vector<HistoryValue>& before_values,
                               const HistoryRun& after,
                               const std::vector<HistoryValue>& after_values);

}  // namespace phytobench
