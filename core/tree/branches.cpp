// SPDX-License-Identifier: MIT
#include "core/tree/branches.hpp"

#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

std::size_t parent_of(const Skeleton& skeleton, std::size_t node) {
  return static_cast<std::size_t>(skeleton.parents()[node]);
}

}  // namespace

ChildLists::ChildLists(const Skeleton& skeleton) : begins_(skeleton.node_count() + 1, 0) {
  const std::size_t nodes = skeleton.node_count();
  for (std::size_t i = 1; i < nodes; ++i) ++begins_[parent_of(skeleton, i) + 1];
  for (std::size_t i = 1; i <= nodes; ++i) begins_[i] += begins_[i - 1];
  children_.resize(skeleton.edge_count());
  std::vector<std::size_t> next(begins_.begin(), begins_.end() - 1);
  for (std::size_t i = 1; i < nodes; ++i)
    children_[next[parent_of(skeleton, i)]++] = static_cast<std::int32_t>(i);
}

std::vector<std::int32_t> tips_above(const Skeleton& skeleton) {
  std::vector<std::int32_t> tips(skeleton.node_count(), 0);
  for (std::size_t i = skeleton.node_count(); i-- > 1;) {
    if (tips[i] == 0) tips[i] = 1;
    tips[parent_of(skeleton, i)] += tips[i];
  }
  if (tips[0] == 0) tips[0] = 1;
  return tips;
}

std::vector<std::int32_t> node_depths(const Skeleton& skeleton) {
  std::vector<std::int32_t> depths(skeleton.node_count(), 0);
  for (std::size_t i = 1; i < depths.size(); ++i) depths[i] = depths[parent_of(skeleton, i)] + 1;
  return depths;
}

std::vector<std::int32_t> branch_orders(const Skeleton& skeleton, std::span<const double> radii) {
  PHYTOBENCH_EXPECT(radii.size() == skeleton.node_count());
  constexpr std::int32_t none = -1;
  std::vector<std::int32_t> leader(skeleton.node_count(),
                                   none);  // the child that continues the axis
  for (std::size_t i = 1; i < leader.size(); ++i) {
    std::int32_t& thickest = leader[parent_of(skeleton, i)];
    if (thickest == none || radii[i] > radii[static_cast<std::size_t>(thickest)])
      thickest = static_cast<std::int32_t>(i);
  }
  std::vector<std::int32_t> orders(skeleton.node_count(), 0);
  for (std::size_t i = 1; i < orders.size(); ++i) {
    const std::size_t parent = parent_of(skeleton, i);
    orders[i] = orders[parent] + (leader[parent] == static_cast<std::int32_t>(i) ? 0 : 1);
  }
  return orders;
}

std::vector<double> branch_radii(const Skeleton& skeleton, double tip_radius, double exponent) {
  PHYTOBENCH_EXPECT(tip_radius > 0.0 && exponent > 0.0);
  const double root = 1.0 / exponent;
  std::vector<double> of_few;  // most nodes have few tips above them
  for (int tips = 0; tips < 64; ++tips) of_few.push_back(tip_radius * std::pow(tips, root));
  std::vector<double> radii;
  radii.reserve(skeleton.node_count());
  for (const std::int32_t tips : tips_above(skeleton)) {
    const auto few = static_cast<std::size_t>(tips);
    radii.push_back(few < of_few.size() ? of_few[few] : tip_radius * std::pow(tips, root));
  }
  return radii;
}

}  // namespace phytobench
