// SPDX-License-Identifier: MIT
// What the symbols of a system make the turtle do, looked up once: while a word is drawn nobody
// compares letters.
#pragma once

#include <array>
#include <cstdint>

#include "core/lsystem/drawing.hpp"
#include "core/lsystem/lsystem.hpp"
#include "core/lsystem/word.hpp"

namespace phytobench {

enum class TurtleAction : std::uint8_t {
  nothing,
  draw,
  move,
  turn,       ///< + -
  pitch,      ///< & ^
  roll,       ///< \ and /
  turn_back,  ///< |
  level,      ///< $
  store,
  restore,
  open_polygon,
  close_polygon,
  corner,
  width,
  colour,
  cut,
  query_position,
  query_heading,
  query_left,
  query_up,
};

struct TurtleCommand {
  TurtleAction action = TurtleAction::nothing;
  std::uint8_t arity = 0;
  std::uint32_t headings = 0;  ///< turns of a PlaneTable: how many headings further
  double sign = 1.0;           ///< of turns: -1 the other way; the convention included
  double amount = 0.0;  ///< without a parameter: degrees with their sign, or length, or factor

  /// Degrees with their sign, or length.
  double value(const double* parameters) const {
    return arity == 0 ? amount : sign * parameters[0];
  }
};

struct TurtleCommands {
  std::array<TurtleCommand, most_symbols> of;  ///< per symbol
  bool planar = true;                          ///< no symbol pitches, rolls or levels
  bool turns_by_parameters = false;            ///< + or - with a parameter occurs
  bool queries = false;                        ///< some ? occurs
};

TurtleCommands turtle_commands(const LSystem& system);

/// Modules of the word that draw, those after a cut included.
std::size_t count_drawing_modules(const TurtleCommands& commands, const Word& word);

/// Who says how wide the lines of the word are, what is cut off included.
WidthSource width_source(const LSystem& system, const TurtleCommands& commands, const Word& word);

}  // namespace phytobench
