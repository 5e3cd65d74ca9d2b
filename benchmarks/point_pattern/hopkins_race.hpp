// SPDX-License-Identifier: MIT
// Ways to the Hopkins index side by side: by integration over Voronoi cells, and by sampling as
// many places as there are points.
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "core/point_pattern/hopkins.hpp"

namespace phytobench {

struct HopkinsWay {
  std::string name;
  std::string missing;    ///< what was not found, if it is not built
  HopkinsIndex index;     ///< as it was timed
  std::string objection;  ///< why it got no time; empty if it did
  std::vector<double> seconds;
};

struct HopkinsRaceRequest {
  std::vector<Point2> points;  ///< at least two, in the window
  Rectangle window;            ///< with edges: k-d trees know no torus
  int threads = 1;             ///< of what can use them
  int rounds = 7;
  std::uint64_t seed = 0;  ///< of the places and of the order within each round
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

/// What is wrong with an index that should be another up to a relative tolerance; empty if nothing.
/// NaN and infinity are equal to nothing.
std::string objection_to(const HopkinsIndex& found, const HopkinsIndex& expected, double tolerance);

/// Exact first, then sampled through the suite's grid and through a k-d tree. Before any is timed
/// the two sampled ones must agree to 1e-9 at the same places, and the exact one with them within
/// five standard errors of sampling. Throws Interrupted when asked to stop.
std::vector<HopkinsWay> race_hopkins(const HopkinsRaceRequest& request);

}  // namespace phytobench
