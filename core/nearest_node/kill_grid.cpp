// SPDX-License-Identifier: MIT
#include "core/nearest_node/kill_grid.hpp"

#include <algorithm>
#include <cmath>

namespace phytobench {

std::int32_t KillGrid::Axis::cell_of(double value, double inverse_edge) const {
  const double cell = std::floor((value - low) * inverse_edge);
  return static_cast<std::int32_t>(std::clamp(cell, -1.0, static_cast<double>(cells)));
}

std::size_t KillGrid::number(std::int32_t x, std::int32_t y, std::int32_t z) const {
  return (static_cast<std::size_t>(x) * static_cast<std::size_t>(y_.cells) +
          static_cast<std::size_t>(y)) *
             static_cast<std::size_t>(z_.cells) +
         static_cast<std::size_t>(z);
}

std::size_t KillGrid::cell_of(const Vector3& v) const {
  const auto along = [this](const Axis& axis, double value) {
    return std::clamp(axis.cell_of(value, inverse_edge_), 0, axis.cells - 1);
  };
  return number(along(x_, v.x), along(y_, v.y), along(z_, v.z));
}

/// Below it squares underflow: whatever is nearer is within any reach.
constexpr double smallest_edge = 1e-150;

void KillGrid::build(std::span<const SearchableNode> killers, double kill_distance) {
  squared_reach_ = kill_distance * kill_distance;
  BoundingBox box;
  for (const SearchableNode& killer : killers) box.extend(killer.position);
  within_reach_ = killers.empty() ? box : box.widened(std::max(kill_distance, smallest_edge));
  begins_.clear();
  killers_.resize(killers.size());
  if (killers.empty()) return;

  const Vector3 low = box.low(), extent = box.extent();
  double largest = 0.0;
  for (const Vector3& corner : {box.low(), box.high()})
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  // Wider than the distance by more than rounding can move a coordinate across a border.
  double edge = std::max(kill_distance * (1.0 + 0x1p-20) + largest * 0x1p-40, smallest_edge);
  const double most_cells = 4.0 * static_cast<double>(killers.size()) + 64.0;
  const auto cells = [&edge](double length) { return std::floor(length / edge) + 1.0; };
  while (cells(extent.x) * cells(extent.y) * cells(extent.z) > most_cells) edge *= 1.25;
  inverse_edge_ = 1.0 / edge;
  x_ = {low.x, static_cast<std::int32_t>(cells(extent.x))};
  y_ = {low.y, static_cast<std::int32_t>(cells(extent.y))};
  z_ = {low.z, static_cast<std::int32_t>(cells(extent.z))};

  begins_.assign(number(x_.cells - 1, y_.cells - 1, z_.cells - 1) + 2, 0);
  for (const SearchableNode& killer : killers) ++begins_[cell_of(killer.position)];
  std::uint32_t end = 0;
  for (std::uint32_t& begin : begins_) begin = end += begin;
  for (const SearchableNode& killer : killers)
    killers_[--begins_[cell_of(killer.position)]] = killer.position;
}

bool KillGrid::reaches(const Vector3& point, std::uint64_t& evaluations) const {
  if (begins_.empty() || !within_reach_.contains(point)) return false;
  const std::int32_t x = x_.cell_of(point.x, inverse_edge_);
  const std::int32_t y = y_.cell_of(point.y, inverse_edge_);
  const std::int32_t z = z_.cell_of(point.z, inverse_edge_);
  const std::int32_t first_z = std::max(z - 1, 0), last_z = std::min(z + 1, z_.cells - 1);
  if (first_z > last_z) return false;
  for (std::int32_t i = std::max(x - 1, 0); i <= std::min(x + 1, x_.cells - 1); ++i)
    for (std::int32_t j = std::max(y - 1, 0); j <= std::min(y + 1, y_.cells - 1); ++j) {
      const std::uint32_t end = begins_[number(i, j, last_z) + 1];
      for (std::uint32_t k = begins_[number(i, j, first_z)]; k < end; ++k) {
        ++evaluations;
        if (squared_distance(point, killers_[k]) <= squared_reach_) return true;
      }
    }
  return false;
}

}  // namespace phytobench
