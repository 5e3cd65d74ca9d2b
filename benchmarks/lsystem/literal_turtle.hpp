// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <unordered_map>
#include <vector>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

/// A turtle as the books describe it, for judging others: on long doubles, one letter after the
/// other, headings in the plane by counting. Widths, colours and polygons are passed over. Only for
/// systems that objection_to_streaming() has nothing against.
class LiteralDrawer {
 public:
  using Vector = std::array<long double, 3>;
  using TakeSegment = std::function<void(const Vector& from, const Vector& to)>;

  explicit LiteralDrawer(const LSystem& system);

  /// Draws the axiom after so many steps without ever holding the word.
  void draw(int steps, const TakeSegment& take);

  bool planar() const { return planar_; }
  /// Of the longest way from the start to a segment.
  std::uint64_t most_moves() const { return most_moves_; }
  std::uint64_t most_turns() const { return most_turns_; }
  /// Largest coordinate, as a magnitude.
  long double extent() const { return extent_; }

 private:
  enum class Act : std::uint8_t { none, draw, move, turn, half_turn, pitch, roll, store, restore };
  struct Letter {
    Act act = Act::none;
    int sign = 1;
    bool changes = false;
    std::vector<SymbolIndex> successor;
  };
  struct State {
    Vector position{0, 0, 0}, heading{1, 0, 0}, left{0, 1, 0}, up{0, 0, 1};
    std::int64_t angles = 0;
    bool half = false;
    std::uint64_t moves = 0, turns = 0;
  };

  void obey(const Letter& letter, const TakeSegment& take);
  void step(bool draws, const TakeSegment& take);
  void rotate(Vector& a, Vector& b, long double degrees);
  Vector heading();

  const LSystem& system_;
  std::vector<Letter> letters_;
  bool planar_ = true;
  State now_;
  std::vector<State> stack_;
  std::unordered_map<std::int64_t, Vector> headings_;
  std::uint64_t most_moves_ = 0, most_turns_ = 0;
  long double extent_ = 0;
};

}  // namespace phytobench
