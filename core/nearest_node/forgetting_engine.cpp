// SPDX-License-Identifier: MIT
#include "core/nearest_node/forgetting_engine.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

void ForgettingEngine::reset(std::span<const Vector3> points, const EngineSetup& setup) {
  setup_ = setup;
  points_ = points;
  is_removed_.assign(points.size(), 0);
  live_points_ = points.size();
  nodes_.clear();
  is_forgotten_.clear();
  node_of_its_.clear();
  is_outdated_ = false;
  work_before_ = {};
  point_of_its_.resize(points.size());
  for (std::size_t i = 0; i < points.size(); ++i) point_of_its_[i] = static_cast<PointIndex>(i);
  node_of_point_.assign(points.size(), no_node);
  associated_.reset(points.size());
  engine_.reset(points, setup);
}

Assignment ForgettingEngine::associate(std::span<const SearchableNode> new_nodes) {
  const std::size_t known = nodes_.size();
  nodes_.insert(nodes_.end(), new_nodes.begin(), new_nodes.end());
  is_forgotten_.resize(nodes_.size(), 0);
  if (is_outdated_) start_afresh();
  std::vector<SearchableNode> its_new;
  for (std::size_t i = is_outdated_ ? 0 : known; i < nodes_.size(); ++i) {
    if (is_forgotten_[i] != 0) continue;
    its_new.push_back(nodes_[i]);
    node_of_its_.push_back(static_cast<NodeIndex>(i));
  }
  is_outdated_ = false;
  std::fill(node_of_point_.begin(), node_of_point_.end(), no_node);
  associated_.clear();
  // Without any node there is nothing to ask, and not every engine has an answer.
  if (!node_of_its_.empty()) translate(engine_.associate(its_new));
  return {node_of_point_, associated_};
}

void ForgettingEngine::start_afresh() {
  work_before_ += engine_.counters();
  its_points_.clear();
  point_of_its_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i) {
    if (is_removed_[i] != 0) continue;
    its_points_.push_back(points_[i]);
    point_of_its_.push_back(static_cast<PointIndex>(i));
  }
  node_of_its_.clear();
  engine_.reset(its_points_, setup_);
}

void ForgettingEngine::translate(const Assignment& assignment) {
  its_associated_.clear();
  assignment.associated.append_to(its_associated_);
  for (const PointIndex its : its_associated_) {
    const auto i = static_cast<std::size_t>(its);
    const PointIndex point = point_of_its_[i];
    node_of_point_[static_cast<std::size_t>(point)] =
        node_of_its_[static_cast<std::size_t>(assignment.node[i])];
    associated_.insert(point);
  }
}

std::span<const PointIndex> ForgettingEngine::kill(std::span<const SearchableNode> killers,
                                                   double kill_distance) {
  removed_.clear();
  for (const PointIndex its : engine_.kill(killers, kill_distance)) {
    const PointIndex point = point_of_its_[static_cast<std::size_t>(its)];
    removed_.push_back(point);
    is_removed_[static_cast<std::size_t>(point)] = 1;
    node_of_point_[static_cast<std::size_t>(point)] = no_node;
    associated_.erase(point);
  }
  live_points_ -= removed_.size();
  return removed_;
}

WorkCounters ForgettingEngine::counters() const {
  WorkCounters work = work_before_;
  return work += engine_.counters();
}

void ForgettingEngine::forget(std::span<const NodeIndex> nodes) {
  for (const NodeIndex node : nodes) {
    const auto i = static_cast<std::size_t>(node);
    PHYTOBENCH_EXPECT(node >= 0 && i < nodes_.size() && is_forgotten_[i] == 0);
    is_forgotten_[i] = 1;
  }
  is_outdated_ = is_outdated_ || !nodes.empty();
}

}  // namespace phytobench
