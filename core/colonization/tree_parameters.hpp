// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include "core/colonization/attraction_cloud.hpp"
#include "core/colonization/attraction_region.hpp"
#include "core/colonization/growth.hpp"
#include "core/random/unit_stream.hpp"
#include "core/tree/plant.hpp"

namespace phytobench {

/// Whether upward tropism is damped for a crown that is not taller than wide.
enum class TropismDamping {
  none,
  cloud_shape,  ///< y weight min(1, (height / max(width, depth))^2) of the points' extents
};

/// A round region and how many points it gets, instead of the cut ellipsoid and its density.
struct RoundCloud {
  RoundRegion region{.radius = 5.0, .centre = {0, 5, 0}};  ///< centre relative to the crown root
  std::size_t points = 2000;
};

/// A whole tree: stem, cloud, growth and look. The defaults are the start settings of the 2019
/// program as its author published them.
struct TreeParameters {
  std::uint64_t seed = 0;
  StreamKind random = StreamKind::subtractive;
  CutEllipsoid cloud;
  double cloud_density = 26.4;            ///< attraction points per unit volume, > 0
  std::optional<RoundCloud> round_cloud;  ///< if given, `cloud` and its density are not looked at
  int iterations = 30;
  double step_length = 0.25;
  double influence_distance = 0.66;
  double perception_angle_deg = 160.0;  ///< full angle, (0, 360]
  KillDistanceSchedule kill_distance;
  Vector3 tropism_direction{0, 1, 0};
  Vector3 tropism_weights{1, 1, 1};  ///< component by component ([Brzoska2019] sec. 4.1)
  TropismDamping tropism_damping = TropismDamping::cloud_shape;
  double tropism_damping_density =
      0.0;  ///< density of the cloud whose extents are measured; 0: the crown's own
  double stem_length = 2.0;       ///< below the crown, length units, >= 0
  double stem_tilt_deg = 5.0;     ///< largest tilt of a stem piece, [0, 90]
  double crown_stem_ratio = 0.0;  ///< share of the cloud's height that a trunk runs through, [0, 1]
  GrowthVariant variant;
  GrowthLimits limits;
  PlantParameters plant;
};

/// Grows the stem and samples the cloud. Throws InputError for an absurd number of points or stem
/// pieces.
Seedling make_seedling(const TreeParameters& parameters);

/// A grown tree and where its crown begins.
struct TreeOnStem {
  Skeleton skeleton{Vector3{}};
  std::int32_t crown_root = 0;
};

/// Puts a grown crown on a stem of another length: the stem is grown anew from `parameters`, and
/// everything from the crown root on moves along, stem inside the crown included ([Brzoska2019]
/// sec. 5.2.1, RegrowStem). No crown edge changes, and nothing is searched.
TreeOnStem regrow_stem(const TreeOnStem& tree, const TreeParameters& parameters);

/// min(1, (height / max(width, depth))^2), the damping of upward tropism ([Brzoska2019] sec. 5.5.1
/// states the rule without a formula; the square is its author's).
double tropism_damping_weight(const Vector3& extent);

/// One line on why nothing grows although the cloud has points: which distance, how far, what to
/// change. Only meaningful for a result without a single new node.
std::string why_growth_cannot_start(const Seedling& seedling);

}  // namespace phytobench
