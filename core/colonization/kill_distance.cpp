// SPDX-License-Identifier: MIT
#include "core/colonization/kill_distance.hpp"

#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

double sigmoid(double x) {
  return 1.0 / (1.0 + std::exp(-x));
}

double KillDistanceSchedule::at(int i, int iterations) const {
  PHYTOBENCH_EXPECT(0 <= i && i < iterations);
  if (iterations == 1) return begin;
  const double stretch = (sigmoid_end - sigmoid_begin) / (iterations - 1);
  const double share = sigmoid(sigmoid_begin + stretch * i);
  if (interpolation == KillInterpolation::linear) return begin - share * (begin - end);
  return std::sqrt(begin * begin - share * (begin * begin - end * end));
}

double GnarlinessCoupling::kill_distance(double branch_density) const {
  const double largest = kill_distance_max * kill_distance_max;
  const double smallest = kill_distance_min * kill_distance_min;
  return std::sqrt(largest - branch_density * (largest - smallest));
}

GnarlinessCoupling couple_to_gnarliness(double gnarliness) {
  PHYTOBENCH_EXPECT(gnarliness >= 0.0 && gnarliness <= 1.0);
  return {.influence_distance = 1.3 - 0.8 * gnarliness,
          .kill_distance_min = 0.1 - 0.05 * gnarliness,
          .kill_distance_max = 1.25 - 0.8375 * gnarliness,
          .cloud_density = 12.0 + 18.0 * gnarliness};
}

}  // namespace phytobench
