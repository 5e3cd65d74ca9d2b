// SPDX-License-Identifier: MIT
#pragma once

namespace phytobench {

/// What is interpolated between the first and the last kill distance.
enum class KillInterpolation {
  squared,  ///< the squares; the published trees need it
  linear,   ///< the distances themselves, as eq. 17 prints it
};

/// Kill distance that shrinks along a stretch of the sigmoid while the tree grows ([Brzoska2019]
/// eq. 17).
struct KillDistanceSchedule {
  double begin = 0.58;         ///< kill distance of the first iteration, length units, > 0
  double end = 0.2649;         ///< approached in the last iteration, > 0
  double sigmoid_begin = -12;  ///< argument of the sigmoid in the first iteration
  double sigmoid_end = 6;      ///< argument in the last; eq. 17's worked example has -8 and 8
  KillInterpolation interpolation = KillInterpolation::squared;

  /// Kill distance of iteration `i` of `iterations`. For a single iteration, where eq. 17 divides
  /// by zero, it is `begin`.
  double at(int i, int iterations) const;
};

/// 1 / (1 + exp(-x)), the function of [Brzoska2019] fig. 33 (eq. 16 is missing in print).
double sigmoid(double x);

/// Interval of kill distances that gnarliness allows, and the kill distance for a branch density in
/// it
/// ([Brzoska2019] sec. 5.2.1; numbers as published by its author): density 0 gives the largest, 1
/// the smallest, linear in the square.
struct GnarlinessCoupling {
  double influence_distance;
  double kill_distance_min;
  double kill_distance_max;
  double cloud_density;  ///< points per unit volume

  double kill_distance(double branch_density) const;
};

/// gnarliness in [0, 1].
GnarlinessCoupling couple_to_gnarliness(double gnarliness);

}  // namespace phytobench
