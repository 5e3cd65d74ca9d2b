// SPDX-License-Identifier: MIT
// How the curves of one picture look, and the list of their names.
#pragma once

#include <string>
#include <vector>

#include "core/picture/curve_svg.hpp"

namespace phytobench {

/// The attributes of a path that is drawn in a style; a step of length zero makes a dot.
std::string curve_stroke(CurveStyle style, const std::string& colour);

/// Hands out colours in the order in which names come, and lists what it gave.
class CurveLegend {
 public:
  /// Throws ContractViolation for the number of a colour that does not exist.
  std::string colour_of(const Curve& curve);

  /// Appends the names, row below row from `top` on, between `left` and `right`; returns where the
  /// last row stands: above `top` if there is no name.
  double draw(double left, double top, double right, std::string& svg) const;

 private:
  struct Entry {
    std::string name;
    CurveStyle style;
    std::string colour;
  };

  void add(const Entry& entry);

  std::vector<std::string> names_;
  std::vector<Entry> entries_;
};

}  // namespace phytobench
