// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Killers in a grid over their bounding box, cells no narrower than the kill distance: a point
/// looks at its own cell and those around it. The removal of engines whose search is a library's:
/// looking at every pair would hide what they differ in.
class KillGrid {
 public:
  /// Sorts the killers into cells.
  void build(std::span<const SearchableNode> killers, double kill_distance);

  /// Whether a killer lies within the kill distance. Adds the distances computed to `evaluations`.
  bool reaches(const Vector3& point, std::uint64_t& evaluations) const;

 private:
  struct Axis {
    double low = 0.0;
    std::int32_t cells = 1;
    /// Monotone, and clamped to one cell beyond either end.
    std::int32_t cell_of(double value, double inverse_edge) const;
  };
  std::size_t cell_of(const Vector3& v) const;
  std::size_t number(std::int32_t x, std::int32_t y, std::int32_t z) const;

  double squared_reach_ = 0.0;
  double inverse_edge_ = 1.0;
  BoundingBox within_reach_;
  Axis x_, y_, z_;
  std::vector<std::uint32_t> begins_;  // per cell, and the end
  std::vector<Vector3> killers_;       // by cell
};

}  // namespace phytobench
