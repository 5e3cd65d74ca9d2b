// SPDX-License-Identifier: MIT
// The turtle of [Liebemann2017] sec. 2.3.1 and 2.3.2 in the plane, with the matrices as printed,
// and one that walks on whole numbers for right angles. Shares no code with core/.
#pragma once

#include <cmath>
#include <compare>
#include <cstdint>
#include <numbers>
#include <stdexcept>
#include <string>

#include "reference/oracles/turtle_drawing.hpp"

namespace phytobench::oracles {

struct PlanePoint {
  double x = 0, y = 0;
  friend auto operator<=>(const PlanePoint&, const PlanePoint&) = default;
};

// (p, H).
struct PlaneTurtle {
  PlanePoint position;
  PlanePoint H{0, 1};

  // Eq. 2.3.
  void move(double l) { position = {position.x + H.x * l, position.y + H.y * l}; }

  void turn(const std::string& letter, double d_deg) {
    const double d = d_deg * std::numbers::pi / 180;
    if (letter == "+") H = equation_2_4(d);
    if (letter == "-") H = equation_2_5(d);
    if (letter == "|") H = equation_2_4(std::numbers::pi);
  }

  PlanePoint equation_2_4(double d) const {
    return {std::cos(d) * H.x - std::sin(d) * H.y, std::sin(d) * H.x + std::cos(d) * H.y};
  }
  PlanePoint equation_2_5(double d) const {
    return {std::cos(d) * H.x + std::sin(d) * H.y, -std::sin(d) * H.x + std::cos(d) * H.y};
  }
};

using PlaneDrawing = TurtleDrawing<PlaneTurtle>;

// From the origin, with the heading +y.
inline PlaneDrawing turtle_2d(const ParametricWord& word, const TurtleDefaults& defaults) {
  return drawing_of(word, PlaneTurtle{}, defaults);
}

struct GridPoint {
  std::int64_t x = 0, y = 0;
  friend auto operator<=>(const GridPoint&, const GridPoint&) = default;
};

// The same for whole lengths and multiples of 90 degrees, exactly: the matrices have 0, 1 and -1.
struct GridTurtle {
  GridPoint position;
  GridPoint H{0, 1};

  void move(double l) {
    const std::int64_t whole = std::llround(l);
    if (static_cast<double>(whole) != l) throw std::invalid_argument("the length is not whole");
    position = {position.x + H.x * whole, position.y + H.y * whole};
  }

  void turn(const std::string& letter, double d_deg) {
    if (letter != "+" && letter != "-" && letter != "|") return;
    const double angle_deg = letter == "|" ? 180 : letter == "-" ? -d_deg : d_deg;
    const std::int64_t quarters = std::llround(angle_deg / 90);
    if (static_cast<double>(quarters) * 90 != angle_deg)
      throw std::invalid_argument("the angle is no multiple of 90 degrees");
    for (std::int64_t i = 0; i < (quarters % 4 + 4) % 4; ++i) H = {-H.y, H.x};
  }
};

using GridDrawing = TurtleDrawing<GridTurtle>;

inline GridDrawing turtle_on_grid(const ParametricWord& word, const TurtleDefaults& defaults) {
  return drawing_of(word, GridTurtle{}, defaults);
}

}  // namespace phytobench::oracles
