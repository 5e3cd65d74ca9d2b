// SPDX-License-Identifier: MIT
// Ranges of what a tree has many of.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <string>
#include <vector>

#include "core/lsystem/drawing_measures.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::liebemann2017 {

/// Least and greatest of what was measured many times.
struct Range {
  double least = std::numeric_limits<double>::max(),
         greatest = std::numeric_limits<double>::lowest();

  void extend(double value) {
    least = std::min(least, value);
    greatest = std::max(greatest, value);
  }
  void record(ExperimentContext& context, const std::string& name, const char* unit) const {
    context.record(name + "/least", least, unit);
    context.record(name + "/greatest", greatest, unit);
  }
};

/// Of the ways from the root to all tips.
inline Range tip_path_lengths(const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  const std::vector<double> lengths = path_lengths(skeleton);
  Range range;
  for (std::size_t node = 0; node < skeleton.node_count(); ++node)
    if (children.of(static_cast<std::int32_t>(node)).empty()) range.extend(lengths[node]);
  return range;
}

}  // namespace phytobench::experiments::liebemann2017
