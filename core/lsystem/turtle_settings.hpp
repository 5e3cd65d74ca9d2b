// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// Which way the turtle turns on + & \ with a positive angle. The words of the books are "left",
/// "down" and "roll left"; programs and printed matrices differ. Counts, lengths, areas and
/// branchings do not depend on it, boxes and chirality do.
enum class TurtleConvention {
  words,  ///< left, down, left: [Liebemann2017] eq. 2.7-2.16, L-Py, lpfg with its correction
  abop_matrices,  ///< all three the other way: the matrices of The Algorithmic Beauty of Plants, p.
                  ///< 19, read by columns
  cpfg,           ///< left, down, roll right: cpfg; [Lintermann1997] table 1 by the right-hand rule
  lpfg_uncorrected,  ///< left, up, roll right
};

/// The turtle's first heading; left and up follow such that H x L = U.
enum class TurtleStart {
  upwards,  ///< H = +y, L = -x, U = +z: plants, and all drawings in the plane
  local,    ///< H = +x, L = +y, U = +z: [Liebemann2017] sec. 2.3.3
};

/// How a turtle draws. Angles in degrees, lengths in length units.
struct TurtleSettings {
  double angle_deg = 90.0;      ///< of turns without a parameter
  double step = 1.0;            ///< of moves without a parameter, > 0
  double width = 1.0;           ///< of the first segments, > 0
  bool width_is_given = false;  ///< by `width:`, in length units
  double width_factor = 0.7;    ///< by which ! without a parameter multiplies the width, > 0
  TurtleConvention convention = TurtleConvention::words;
  TurtleStart start = TurtleStart::upwards;
  std::string draws = "F";           ///< letters that move and draw, each one character
  std::string moves = "f";           ///< letters that move only
  std::vector<std::string> colours;  ///< "#rrggbb" that ' steps through; empty: the drawer's own
};

/// Signs of turn, pitch and roll of a convention, relative to `words`.
struct TurtleSigns {
  double turn = 1.0;
  double pitch = 1.0;
  double roll = 1.0;
};
TurtleSigns signs_of(TurtleConvention convention);

std::string_view name_of(TurtleConvention convention);  ///< "words", "abop_matrices", ...
/// Throws InputError naming the four.
TurtleConvention turtle_convention_named(std::string_view name);

}  // namespace phytobench
