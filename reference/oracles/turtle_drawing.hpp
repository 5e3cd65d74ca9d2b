// SPDX-License-Identifier: MIT
// How a turtle reads a word: moves, brackets, polygons, and the tree graph of [Liebemann2017]
// sec. 2.4.1. What moving and turning mean is the state's business: turtle_2d.hpp, turtle_3d.hpp.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <stdexcept>
#include <string>
#include <vector>

#include "reference/oracles/parametric_word.hpp"

namespace phytobench::oracles {

struct TurtleDefaults {
  double length = 1;      // l of F and f without a parameter
  double angle_deg = 90;  // d of turns without a parameter
  std::string draws = "F";
  std::string moves = "f";
};

template <class State>
struct TurtleDrawing {
  using Point = decltype(State::position);
  struct Segment {
    Point from, to;
  };
  std::vector<Segment> segments;             // in the order of drawing
  std::vector<std::vector<Point>> polygons;  // the place of { and the ends of the moves behind it
  std::vector<Point> nodes;                  // the root first, then the end of each segment
  std::vector<int> parents;                  // -1 for the root
  State end{};
};

// A State has `position`, `move(length)` and `turn(letter, degrees)`, which does nothing for
// letters that do not turn. Throws std::invalid_argument if brackets or braces do not match.
template <class State>
TurtleDrawing<State> drawing_of(const ParametricWord& word, State state,
                                const TurtleDefaults& defaults) {
  struct Stored {
    State state;
    int node;
  };
  TurtleDrawing<State> drawing;
  drawing.nodes.push_back(state.position);
  drawing.parents.push_back(-1);
  std::vector<Stored> stack;
  int node = 0;
  bool in_polygon = false;
  for (const auto& [letter, parameters] : word) {
    const bool draws = letter.size() == 1 && defaults.draws.find(letter) != std::string::npos;
    const bool moves = letter.size() == 1 && defaults.moves.find(letter) != std::string::npos;
    if (draws || moves) {
      const auto from = state.position;
      state.move(parameters.empty() ? defaults.length : parameters[0]);
      if (in_polygon) drawing.polygons.back().push_back(state.position);
      if (!draws) continue;
      drawing.segments.push_back({from, state.position});
      drawing.nodes.push_back(state.position);
      drawing.parents.push_back(node);
      node = static_cast<int>(drawing.nodes.size()) - 1;
    } else if (letter == "[") {
      stack.push_back({state, node});
    } else if (letter == "]") {
      if (stack.empty()) throw std::invalid_argument("] without [");
      state = stack.back().state;
      node = stack.back().node;
      stack.pop_back();
    } else if (letter == "{" || letter == "}") {
      if (in_polygon == (letter == "{")) throw std::invalid_argument("braces do not match");
      in_polygon = letter == "{";
      if (in_polygon) drawing.polygons.push_back({state.position});
    } else {
      state.turn(letter, parameters.empty() ? defaults.angle_deg : parameters[0]);
    }
  }
  if (!stack.empty() || in_polygon) throw std::invalid_argument("brackets do not match");
  drawing.end = state;
  return drawing;
}

}  // namespace phytobench::oracles
