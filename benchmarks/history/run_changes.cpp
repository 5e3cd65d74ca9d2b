// SPDX-License-Identifier: MIT
#include "benchmarks/history/run_changes.hpp"

#include <limits>
#include <map>
#include <utility>

namespace phytobench {

namespace {

std::string caution_of(const HistoryRun& before, const HistoryRun& after) {
  if (before.machine_class() != after.machine_class())
    return "the runs are of different machines: the C library chooses its instructions by the "
           "processor";
  if (before.compiler != after.compiler || before.flags != after.flags)
    return "the runs are of different compilers or flags";
  return "";
}

}  // namespace

double HistoryChange::relative() const {
  if (is_equal()) return 0.0;
  if (before.number() == 0.0) return std::numeric_limits<double>::infinity();
  return after.number() / before.number() - 1.0;
}

HistoryChanges changes_between(const HistoryRun& before,
                               const std::vector<HistoryValue>& before_values,
                               const HistoryRun& after,
                               const std::vector<HistoryValue>& after_values) {
  std::map<std::pair<std::string, std::string>, const HistoryValue*> known;
  for (const HistoryValue& value : after_values)
    known[{value.benchmark(), value.quantity().text()}] = &value;
  HistoryChanges changes;
  bool has_instructions = false;
  for (const HistoryValue& value : before_values) {
    const auto match = known.find({value.benchmark(), value.quantity().text()});
    if (match == known.end()) {
      ++changes.only_before;
      continue;
    }
    const HistoryValue& now = *match->second;
    known.erase(match);
    if (value.quantity().is_ratio() && before.machine_class() != after.machine_class()) {
      ++changes.ratios_left_out;
      continue;
    }
    has_instructions = has_instructions || value.quantity() == HistoryQuantity::instructions();
    const bool has_same_inputs =
        value.inputs().empty() || now.inputs().empty() || value.inputs() == now.inputs();
    changes.values.push_back({value, now, has_same_inputs});
  }
  changes.only_after = known.size();
  if (has_instructions) changes.caution = caution_of(before, after);
  return changes;
}

}  // namespace phytobench
