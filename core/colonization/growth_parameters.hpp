// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <limits>
#include <string_view>

#include "core/colonization/kill_distance.hpp"
#include "core/geometry/vector3.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// When tropism joins the growth direction.
enum class TropismOrder {
  before_normalising,  ///< (sum + g) / |sum + g|: the published trees
  after_normalising,   ///< sum / |sum| first, [Brzoska2019] eq. 10 as printed
};

/// What is summed over a node's attraction points.
enum class AttractionSum {
  unit_vectors,  ///< [Brzoska2019] eq. 9
  raw_vectors,   ///< the sentence before eq. 8, read literally
};

/// When the perception angle is tested.
enum class PerceptionTest {
  during_search,  ///< the nearest node among those that perceive the point
  after_search,   ///< the nearest node, given up if it does not perceive the point
};

/// Whether a node may get a second child at exactly the same place.
enum class RepeatGuard { on, off };

/// Which nodes that exist before the crown grows remove points.
enum class StartKillers {
  crown_root,      ///< only the crown root
  crown_stem_too,  ///< the procedural trunk inside the crown as well
};

/// The kill distance of a deferred removal pass.
enum class DeferredKillDistance {
  previous_iteration,  ///< that of the iteration whose removal is made up for
  current_iteration,   ///< a mistake that grows another tree
};

/// Whether a deferred removal already happens in the very first pass.
enum class DeferredFirstPass {
  skip,  ///< nothing has grown yet
  kill,  ///< a mistake that grows another tree
};

/// Whether what lies exactly at a distance is within it; [Liebemann2017] sec. 3.3 says "within".
enum class Boundary { inclusive, exclusive };

/// Readings of the model under which published trees differ. The defaults are those that reproduce
/// the published counts; each field names the alternative.
struct GrowthVariant {
  TropismOrder tropism_order = TropismOrder::before_normalising;
  AttractionSum attraction_sum = AttractionSum::unit_vectors;
  PerceptionTest perception_test = PerceptionTest::during_search;
  RepeatGuard repeat_guard = RepeatGuard::on;
  StartKillers start_killers = StartKillers::crown_root;
  DeferredKillDistance deferred_kill_distance = DeferredKillDistance::previous_iteration;
  DeferredFirstPass deferred_first_pass = DeferredFirstPass::skip;
  Boundary influence_boundary = Boundary::inclusive;
  Boundary kill_boundary = Boundary::inclusive;
};

/// How far a new node is from its parent.
enum class StepWeighting {
  none,             ///< step_length everywhere
  by_branch_depth,  ///< step_length (2 - Z / most_branch_depth): twice as far at branch depth 0
};

/// Conditions on growth ([Liebemann2017] sec. 3.5). The defaults forbid nothing.
struct GrowthLimits {
  static constexpr std::int32_t unlimited = std::numeric_limits<std::int32_t>::max();

  std::int32_t most_children = unlimited;      ///< max_grad, of any node, >= 1
  std::int32_t most_branch_depth = unlimited;  ///< max_Z, by eq. 3.5 at creation, >= 0
  /// max_NG, >= 1: a node without a new child in so many iterations in a row rests. Its points go
  /// to the nearest node that does not.
  std::int32_t rest_iterations = unlimited;
  /// Weighting needs a most_branch_depth that is neither 0 nor unlimited.
  StepWeighting step_weighting = StepWeighting::none;
};

/// What the crown's growth needs to know ([Brzoska2019] sec. 3.4.4, 4.1, 5.2.1).
struct GrowthParameters {
  int iterations = 30;                 ///< at most; growth may stop earlier
  double step_length = 0.25;           ///< D of eq. 8, length units, > 0
  double influence_distance = 0.66;    ///< d_i, length units, > 0; infinity is allowed
  double perception_angle_rad = 0.0;   ///< full angle, (0, 2 pi]; 2 pi perceives all around
  KillDistanceSchedule kill_distance;  ///< d_c, never above influence_distance
  Vector3 tropism;                     ///< g, already weighted; length is its strength
  GrowthVariant variant;
  GrowthLimits limits;
};

/// The largest distance that is still within `distance`: itself, or the next smaller number.
/// Infinity stays.
double largest_within(double distance, Boundary boundary);

/// When points near new nodes are removed ([Brzoska2019] sec. 5.2.2, option D).
enum class KillTiming {
  immediate,  ///< at the end of the iteration
  deferred,   ///< at the start of the next one
};

/// The loop options of Table 1, written s, d, n and dn. They never change the tree.
struct LoopOptions {
  KillTiming kill_timing = KillTiming::immediate;
  PointFilter point_filter = PointFilter::none;
};

inline constexpr std::string_view loop_option_names[] = {"s", "d", "n", "dn"};

/// Options of that name (either case, "d&n" too). Throws InputError naming the four.
LoopOptions loop_options_named(std::string_view name);

}  // namespace phytobench
