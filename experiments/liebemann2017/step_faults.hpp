// SPDX-License-Identifier: MIT
// The three steps of [Liebemann2017] sec. 3.3 against distances of all points to all nodes.
#pragma once

#include <algorithm>
#include <cstdint>
#include <limits>
#include <utility>
#include <vector>

#include "experiments/liebemann2017/influence_scenes.hpp"

namespace phytobench::experiments::liebemann2017 {

/// What is wrong with the steps, over all iterations of a tree.
struct Faults {
  std::int64_t iterations = 0;
  std::int64_t influencing_points = 0;  // step 1: other ones than the nearest node's, within d_i
  std::int64_t growing_nodes = 0;       // step 2: not one successor for each S(v) with points
  std::int64_t points_left = 0;         // step 3: others than those farther than d_k
};

/// Follows one run by brute force: distances of every point to every node there is.
class Follower {
 public:
  explicit Follower(const Seedling& seedling)
      : points_(seedling.attraction_points),
        shortest_(points_.size(), std::numeric_limits<double>::max()),
        nearest_(points_.size(), -1) {}

  void add(const Vector3& node) {
    for (std::size_t s = 0; s < points_.size(); ++s) {
      const double distance = norm(points_[s] - node);
      if (!(distance < shortest_[s])) continue;
      shortest_[s] = distance;
      nearest_[s] = nodes_;
    }
    ++nodes_;
  }
  /// How many points are nearer to a node than `far` and not within `near`, and of how many nodes.
  std::pair<std::size_t, std::size_t> between(double near, double far) const {
    std::vector<std::int32_t> owners;
    for (std::size_t s = 0; s < points_.size(); ++s)
      if (shortest_[s] > near && shortest_[s] <= far) owners.push_back(nearest_[s]);
    const std::size_t count = owners.size();
    std::sort(owners.begin(), owners.end());
    owners.erase(std::unique(owners.begin(), owners.end()), owners.end());
    return {count, owners.size()};
  }

 private:
  const std::vector<Vector3>& points_;
  std::vector<double> shortest_;
  std::vector<std::int32_t> nearest_;
  std::int32_t nodes_ = 0;
};

inline void follow(const Seedling& seedling, const GrowthResult& result, Faults& faults) {
  Follower follower(seedling);
  follower.add(result.skeleton.position(0));
  std::size_t known = 1;
  // The first iteration has points near the root, which step 3 has not seen yet.
  double removed_within = -1.0;
  for (const PassStatistics& pass : result.passes) {
    const auto [points, owners] = follower.between(removed_within, influence_radius);
    ++faults.iterations;
    faults.influencing_points += points != pass.associated_points;
    faults.growing_nodes += owners != pass.new_nodes + pass.suppressed_repeats;
    for (std::size_t i = 0; i < pass.new_nodes; ++i)
      follower.add(result.skeleton.positions()[known++]);
    if (pass.new_nodes == 0) continue;
    removed_within = minimal_radius;
    const auto left = follower.between(minimal_radius, std::numeric_limits<double>::max()).first;
    faults.points_left += left != pass.live_points - pass.removed_points;
  }
}

}  // namespace phytobench::experiments::liebemann2017
