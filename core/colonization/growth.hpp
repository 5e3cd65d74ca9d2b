// SPDX-License-Identifier: MIT
// The space colonization loop ([Brzoska2019] sec. 3.4.4): associate, grow, remove, repeat.
#pragma once

#include <functional>
#include <string_view>
#include <vector>

#include "core/colonization/growth_parameters.hpp"
#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Everything that exists before the crown grows.
struct Seedling {
  std::vector<Vector3> attraction_points;
  Skeleton skeleton{Vector3{}};  ///< stem, then crown root, then the stem inside the crown
  std::int32_t crown_root = 0;   ///< nodes from here on are searchable; the stem below is not
  Vector3 crown_root_direction{0, 1, 0};  ///< along the last stem piece
  GrowthParameters growth;
};

/// Work and result of one executed iteration. Work is stated per pass: `search` for the
/// association, `kill` for the removal that ran in this iteration (with option d that of the
/// iteration before).
struct PassStatistics {
  int iteration = 0;
  std::size_t live_points = 0;       ///< at the association
  std::size_t searchable_nodes = 0;  ///< at the association; without those that rest
  std::size_t queried_points = 0;    ///< live points that passed option n
  std::size_t associated_points = 0;
  std::size_t new_nodes = 0;
  std::size_t suppressed_repeats = 0;
  std::size_t refused_children = 0;  ///< by most_children or most_branch_depth
  std::size_t removed_points = 0;
  std::uint64_t search_evaluations = 0;
  std::uint64_t kill_evaluations = 0;
};

enum class StopReason {
  iteration_limit,
  no_points_left,     ///< every attraction point has been removed
  no_point_in_range,  ///< no live point is perceived by any node
  no_new_node,        ///< points are perceived, but every child would repeat an existing one
  no_child_allowed,   ///< or, for at least one of them, is refused by the limits of growth
  every_node_rests,   ///< no node has got a child for rest_iterations
  interrupted,        ///< the observer asked to stop
};

std::string_view name_of(StopReason reason);

/// Wall-clock seconds spent in the parts of the loop; not part of any deterministic result.
struct PhaseSeconds {
  double association = 0.0;
  double kill = 0.0;
  double growth = 0.0;
  double total = 0.0;  ///< reset included
};

struct GrowthResult {
  Skeleton skeleton{Vector3{}};
  StopReason stop_reason = StopReason::iteration_limit;
  std::vector<PassStatistics> passes;  ///< one per executed iteration
  std::size_t live_points = 0;         ///< at the end; option d leaves the last removal undone
  WorkCounters work;
  PhaseSeconds seconds;
};

/// Called after each iteration; returning false stops growth before the next one.
using GrowthObserver = std::function<bool(const PassStatistics&)>;

struct GrowthRun {
  LoopOptions options;
  int threads = 1;
  GrowthObserver observer = {};  ///< may be empty
  bool count_work = true;        ///< false while timed, see EngineSetup
};

/// Grows the crown of `seedling` with `engine`. The tree depends on the seedling alone: not on the
/// engine, the loop options or the threads. While nodes can come to rest (GrowthLimits), an
/// iteration without a new node does not end growth: when they rest, others get their points.
GrowthResult grow_crown(const Seedling& seedling, NearestNodeEngine& engine,
                        const GrowthRun& run = {});

/// The searchable nodes that exist before growth: crown root and stem inside the crown, each with
/// the direction it looks in.
std::vector<SearchableNode> start_nodes(const Seedling& seedling);

}  // namespace phytobench
