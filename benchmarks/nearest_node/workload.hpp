// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "core/colonization/growth.hpp"

namespace phytobench {

/// A growth to race engines on.
struct Workload {
  std::string name;
  std::uint64_t seed = 0;
  double density = 0.0;  ///< attraction points per unit volume
  Seedling seedling;
};

/// What may differ from the thesis' test tree.
struct WorkloadRequest {
  double points = 25298.0;
  double density = 0.0;  ///< 0: the test tree's
  int iterations = 0;    ///< 0: as many as the size asks for
  std::uint64_t seed = 0;
};

/// The test tree of [Brzoska2019] Table 1 (figure 51) at another size: radii times
/// c = cbrt(points / points of the test tree), and round(c * its iterations), so that the local
/// work stays the same and only its amount grows. About `points` points come out. Throws
/// InputError for an absurd size.
Workload scaled_test_tree(const WorkloadRequest& request);

/// The user's own points. The crown root is below the middle of the lowest points; lengths are the
/// test tree's, scaled so that a node reaches as many points on average.
Workload workload_from_points(std::vector<Vector3> points, const std::string& name, int iterations);

/// Reads columns x, y, z. Throws InputError with file and line.
std::vector<Vector3> read_points(const std::filesystem::path& file);

}  // namespace phytobench
