// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench {

enum class AxisScale { linear, logarithmic };

/// Both ends of an axis, in the axis' units; low < high, and 0 < low if logarithmic.
struct AxisRange {
  double low = 0.0;
  double high = 1.0;
};

struct AxisTick {
  double value = 0.0;
  std::string label;  ///< empty: a stroke without a number
};

/// Where values lie along an axis, and which of them are named.
class CurveAxis {
 public:
  /// Throws ContractViolation for a range that is empty, not finite, or not positive on a
  /// logarithmic scale.
  CurveAxis(AxisRange range, AxisScale scale);

  /// 0 at the low end, 1 at the high end; beyond them outside. Of a value that the scale can show.
  double position(double value) const;

  /// Linear: multiples of 1, 2 or 5 times a power of ten, from three to nine of them for
  /// `wanted` = 6. Logarithmic: every power of ten named, and 2 and 5 times it within three
  /// decades, strokes without a number between; within one decade as if linear. A number that would
  /// stand too close to another one is left out within three decades. Never outside the range.
  std::vector<AxisTick> ticks(int wanted = 6) const;

  const AxisRange& range() const { return range_; }

 private:
  std::vector<AxisTick> linear_ticks(int wanted) const;
  std::vector<AxisTick> logarithmic_ticks(int wanted) const;
  /// Clears labels that stand too close to another one; those of powers of ten come first.
  std::vector<AxisTick> with_room(std::vector<AxisTick> ticks) const;

  AxisRange range_;
  AxisScale scale_;
};

/// From the least to the largest value, with some room where all are equal.
AxisRange range_of(const std::vector<double>& values, AxisScale scale);

/// The range widened to whole ticks (linear), or by a twentieth of its length at both ends
/// (logarithmic).
AxisRange rounded_outwards(AxisRange range, AxisScale scale, int wanted = 6);

}  // namespace phytobench
