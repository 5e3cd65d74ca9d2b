// SPDX-License-Identifier: MIT
#include "core/lsystem/turtle.hpp"

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

bool is_planar(const LSystem& system) {
  return turtle_commands(system).planar;
}

void refuse_nested_polygon(const LSystem& system) {
  throw InputError(system.source +
                   ": a polygon begins inside another one ({ before the } of the last); polygons "
                   "cannot nest, close the first before");
}

void refuse_lone_brace(const LSystem& system) {
  throw InputError(system.source +
                   ": a polygon ends where none began (} without {); write { before its corners");
}

void refuse_open_polygon(const LSystem& system) {
  throw InputError(system.source +
                   ": a polygon never ends ({ without }); write } after its corners");
}

void refuse_deep_word(const LSystem& system) {
  throw InputError(
      fmt::format("{}: more than {} branches lie inside each other; derive fewer steps",
                  system.source, most_turtle_states));
}

void refuse_reach(const LSystem& system) {
  throw InputError(
      fmt::format("{}: the turtle comes farther than {:g} length units; derive fewer steps or make "
                  "moves shorter",
                  system.source, turtle_reach));
}

double checked_width(const LSystem& system, double width) {
  if (width >= 0.0 && width <= turtle_reach) return width;
  throw InputError(fmt::format("{}: {} is no width of a line; let widths be 0 to {:g}",
                               system.source, width, turtle_reach));
}

std::uint16_t checked_colour(const LSystem& system, double colour) {
  if (colour >= 0.0 && colour <= 65535.0) return static_cast<std::uint16_t>(colour);
  throw InputError(fmt::format("{}: {} is no number of a colour; let '(c) be 0 to 65535",
                               system.source, colour));
}

}  // namespace phytobench
