// SPDX-License-Identifier: MIT
// For tests: strings rewritten and read by a turtle as literally as can be, and how to compare with
// that.
#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
#include <limits>
#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "core/lsystem/segment_stream.hpp"

namespace phytobench {

/// The word, letter by letter.
inline std::string literal_word(const LSystem& system, int steps) {
  const auto letter = [&](SymbolIndex symbol) { return system.symbols[symbol].letter[0]; };
  std::string word;
  for (const AxiomModule& module : system.axiom) word += letter(module.symbol);
  for (int step = 0; step < steps; ++step) {
    std::string next;
    for (const char c : word) {
      const Production* found = nullptr;
      for (const Production& production : system.productions)
        if (letter(production.predecessor.symbol) == c) found = &production;
      if (found == nullptr)
        next += c;
      else
        for (const SuccessorModule& module : found->successor) next += letter(module.symbol);
    }
    word = next;
  }
  return word;
}

struct LiteralSegment {
  std::array<long double, 3> from, to;
};

/// Every letter as the books say it, with eleven bits more than the engines have. Vectors are
/// turned by angles that are counted, not added up: exactly by multiples of 90 degrees.
class LiteralTurtle {
 public:
  explicit LiteralTurtle(const LSystem& system) : settings_(system.turtle) {
    if (settings_.start == TurtleStart::upwards)
      now_ = {{0, 0, 0}, {0, 1, 0}, {-1, 0, 0}, {0, 0, 1}};
    is_planar_ = true;
    for (const Symbol& symbol : system.symbols)
      if (std::string("&^\\/").find(symbol.letter) != std::string::npos) is_planar_ = false;
  }

  std::vector<LiteralSegment> segments_of(const std::string& word) {
    for (const char c : word) obey(c);
    return segments_;
  }
  /// The longest way to a segment, in moves, and the turns on it.
  std::size_t most_moves() const { return most_moves_; }
  std::size_t most_turns() const { return most_turns_; }

 private:
  using Vector = std::array<long double, 3>;
  struct State {
    Vector position{0, 0, 0}, heading{1, 0, 0}, left{0, 1, 0}, up{0, 0, 1};
    long angles = 0;
    int halves = 0;
    std::size_t moves = 0, turns = 0;
  };

  static long double cosine(long double degrees) {
    const long double rest = std::fmod(degrees, 360.0L);
    if (std::fmod(rest, 90.0L) == 0.0L) {
      const int quarter = ((static_cast<int>(rest / 90.0L) % 4) + 4) % 4;
      return quarter == 0 ? 1.0L : quarter == 2 ? -1.0L : 0.0L;
    }
    return std::cos(rest * std::numbers::pi_v<long double> / 180.0L);
  }

  static void rotate(Vector& a, Vector& b, long double degrees) {
    const long double c = cosine(degrees), s = cosine(degrees - 90.0L);
    for (std::size_t k = 0; k < 3; ++k) {
      const long double turned = c * a[k] + s * b[k];
      b[k] = c * b[k] - s * a[k];
      a[k] = turned;
    }
  }

  Vector heading() const {
    if (!is_planar_) return now_.heading;
    const long double start = settings_.start == TurtleStart::upwards ? 90.0L : 0.0L;
    const long double angle = static_cast<long double>(settings_.angle_deg);
    const long double degrees = start + static_cast<long double>(now_.angles) * angle +
                                180.0L * static_cast<long double>(now_.halves);
    return {cosine(degrees), cosine(degrees - 90.0L), 0};
  }

  void step(bool draws) {
    const Vector along = heading();
    const Vector from = now_.position;
    for (std::size_t k = 0; k < 3; ++k)
      now_.position[k] += static_cast<long double>(settings_.step) * along[k];
    ++now_.moves;
    if (!draws) return;
    segments_.push_back({from, now_.position});
    most_moves_ = std::max(most_moves_, now_.moves);
    most_turns_ = std::max(most_turns_, now_.turns);
  }

  void obey(char c) {
    const TurtleSigns signs = signs_of(settings_.convention);
    const long double angle = static_cast<long double>(settings_.angle_deg);
    const long double turn = static_cast<long double>(signs.turn) * angle,
                      pitch = static_cast<long double>(signs.pitch) * angle,
                      roll = static_cast<long double>(signs.roll) * angle;
    if (settings_.draws.find(c) != std::string::npos) return step(true);
    if (settings_.moves.find(c) != std::string::npos) return step(false);
    if (std::string("+-|&^\\/").find(c) != std::string::npos) ++now_.turns;
    if (c == '+' || c == '-') {
      now_.angles += (c == '+' ? 1 : -1) * (signs.turn < 0 ? -1 : 1);
      rotate(now_.heading, now_.left, c == '+' ? turn : -turn);
    }
    if (c == '|') {
      ++now_.halves;
      rotate(now_.heading, now_.left, 180.0L);
    }
    if (c == '&' || c == '^') rotate(now_.up, now_.heading, c == '&' ? pitch : -pitch);
    if (c == '\\' || c == '/') rotate(now_.up, now_.left, c == '\\' ? roll : -roll);
    if (c == '[') stack_.push_back(now_);
    if (c == ']') {
      now_ = stack_.back();
      stack_.pop_back();
    }
  }

  const TurtleSettings& settings_;
  bool is_planar_ = false;
  State now_;
  std::vector<State> stack_;
  std::vector<LiteralSegment> segments_;
  std::size_t most_moves_ = 0, most_turns_ = 0;
};

struct LiteralDrawing {
  std::vector<LiteralSegment> segments;
  double bound = 0.0;  ///< of what rounding to doubles can do to a coordinate; 0: nothing
};

/// Each move rounds a place, at most as far away as all moves together, and each turn a heading by
/// a few units in the last place, which all later moves feel. Degrees that an engine adds up are
/// off by as much of a full turn: 2 pi times more.
inline LiteralDrawing literal_drawing(const LSystem& system, int steps) {
  LiteralTurtle turtle(system);
  LiteralDrawing drawing{.segments = turtle.segments_of(literal_word(system, steps))};
  if (std::fmod(system.turtle.angle_deg, 90.0) == 0.0) return drawing;
  const double eps = std::numeric_limits<double>::epsilon();
  const double moves = static_cast<double>(turtle.most_moves()),
               turns = static_cast<double>(turtle.most_turns());
  const double farthest = system.turtle.step * moves;
  drawing.bound = eps * farthest * (moves + 8.0 + 2.0 * std::numbers::pi * turns);
  return drawing;
}

/// "" if found is what is expected, else the first difference.
inline std::string difference_from(const LiteralDrawing& expected,
                                   const std::vector<SpatialSegment>& found) {
  if (found.size() != expected.segments.size())
    return std::to_string(found.size()) + " segments instead of " +
           std::to_string(expected.segments.size());
  for (std::size_t i = 0; i < found.size(); ++i) {
    const Vector3 ends[] = {found[i].from, found[i].to};
    const std::array<long double, 3> right[] = {expected.segments[i].from, expected.segments[i].to};
    for (std::size_t e = 0; e < 2; ++e) {
      const double coordinates[] = {ends[e].x, ends[e].y, ends[e].z};
      for (std::size_t k = 0; k < 3; ++k) {
        const long double off = std::abs(static_cast<long double>(coordinates[k]) - right[e][k]);
        if (!(off <= static_cast<long double>(expected.bound)))
          return "segment " + std::to_string(i) + ": " + std::to_string(coordinates[k]) +
                 " instead of " + std::to_string(static_cast<double>(right[e][k]));
      }
    }
  }
  return "";
}

inline SpatialSegment in_space(const PlanarSegment& s) {
  return {{s.from_x, s.from_y, 0.0}, {s.to_x, s.to_y, 0.0}};
}
inline SpatialSegment in_space(const SpatialSegment& s) {
  return s;
}

/// A sink that keeps everything, in space.
template <class Segment>
SegmentSink<Segment> collector(std::vector<SpatialSegment>& all) {
  return [&all](std::span<const Segment> block) {
    for (const Segment& segment : block) all.push_back(in_space(segment));
  };
}

/// Whether both have the same bits.
template <class Segment>
bool are_equal(std::span<const Segment> a, std::span<const Segment> b) {
  return a.size() == b.size() &&
         (a.empty() || std::memcmp(a.data(), b.data(), a.size_bytes()) == 0);
}
inline bool are_equal(const std::vector<SpatialSegment>& a, const std::vector<SpatialSegment>& b) {
  return are_equal(std::span(a), std::span(b));
}

}  // namespace phytobench
