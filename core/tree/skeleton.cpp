// SPDX-License-Identifier: MIT
#include "core/tree/skeleton.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

std::int32_t Skeleton::append(std::int32_t parent, const Vector3& position) {
  const auto index = static_cast<std::int32_t>(positions_.size());
  PHYTOBENCH_EXPECT(parent < index && (parent >= 0) == (index > 0));
  PHYTOBENCH_EXPECT(is_finite(position));
  positions_.push_back(position);
  parents_.push_back(parent);
  newest_child_.push_back(-1);
  older_sibling_.push_back(-1);
  if (parent >= 0) {
    auto& newest = newest_child_[static_cast<std::size_t>(parent)];
    older_sibling_.back() = newest;
    newest = index;
  }
  return index;
}

void Skeleton::reserve(std::size_t node_count) {
  positions_.reserve(node_count);
  parents_.reserve(node_count);
  newest_child_.reserve(node_count);
  older_sibling_.reserve(node_count);
}

bool Skeleton::has_child_at(std::int32_t parent, const Vector3& position) const {
  for (std::int32_t child = newest_child_[static_cast<std::size_t>(parent)]; child >= 0;
       child = older_sibling_[static_cast<std::size_t>(child)])
    if (positions_[static_cast<std::size_t>(child)] == position) return true;
  return false;
}

std::size_t tip_count(const Skeleton& skeleton) {
  std::vector<bool> has_child(skeleton.node_count(), false);
  for (const std::int32_t parent : skeleton.parents())
    if (parent >= 0) has_child[static_cast<std::size_t>(parent)] = true;
  has_child[0] = true;
  return static_cast<std::size_t>(std::count(has_child.begin(), has_child.end(), false));
}

double highest_y(const Skeleton& skeleton) {
  double highest = skeleton.positions().front().y;
  for (const Vector3& position : skeleton.positions()) highest = std::max(highest, position.y);
  return highest;
}

std::size_t edge_depth(const Skeleton& skeleton) {
  std::vector<std::size_t> depth(skeleton.node_count(), 0);
  std::size_t deepest = 0;
  for (std::size_t i = 1; i < depth.size(); ++i) {
    depth[i] = depth[static_cast<std::size_t>(skeleton.parents()[i])] + 1;
    deepest = std::max(deepest, depth[i]);
  }
  return deepest;
}

std::string tree_hash(const Skeleton& skeleton) {
  std::uint64_t hash = 0xcbf29ce484222325ULL;
  const auto add = [&hash](std::uint64_t word) {
    for (int byte = 0; byte < 8; ++byte) {
      hash ^= (word >> (8 * byte)) & 0xff;
      hash *= 0x100000001b3ULL;
    }
  };
  for (std::size_t i = 0; i < skeleton.node_count(); ++i) {
    const Vector3& p = skeleton.positions()[i];
    add(std::bit_cast<std::uint64_t>(p.x));
    add(std::bit_cast<std::uint64_t>(p.y));
    add(std::bit_cast<std::uint64_t>(p.z));
    add(static_cast<std::uint64_t>(static_cast<std::int64_t>(skeleton.parents()[i])));
  }
  return fmt::format("{:016x}", hash);
}

}  // namespace phytobench
