// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/lsystem/lsystem.hpp"
#include "core/lsystem/turtle_commands.hpp"

namespace phytobench {

/// What a symbol draws in so many steps: parts in order, or without parts what the turtle does.
struct SymbolDrawing {
  std::uint64_t segments = 0;  ///< saturating
  TurtleCommand command;
  std::uint32_t first_part = 0;
  std::uint32_t part_count = 0;
};

/// The drawings of all (symbol, steps left) that an axiom comes to, without repetition; how much
/// each draws follows from its parts by dynamic programming. Symbols and branches that leave no
/// trace are left out. For systems that objection_to_streaming() has nothing against.
class SymbolDrawings {
 public:
  using Index = std::uint32_t;
  static constexpr Index nothing = ~Index{0};  ///< neither draws nor moves nor turns
  static constexpr Index store = nothing - 1;  ///< as a part: [
  static constexpr Index restore = nothing - 2;
  static constexpr std::size_t most = 2'000'000;  ///< symbols times steps

  /// Throws InputError if steps are negative, or more than `most` allows.
  SymbolDrawings(const LSystem& system, int steps);

  /// Parts stand before what they are parts of.
  std::span<const SymbolDrawing> all() const { return drawings_; }
  std::span<const Index> parts() const { return parts_; }  ///< of all, those of the axiom last
  std::span<const Index> parts_of(Index drawing) const {
    return parts().subspan(drawings_[drawing].first_part, drawings_[drawing].part_count);
  }
  std::span<const Index> parts_of_axiom() const { return parts().last(axiom_parts_); }
  std::uint64_t segments() const { return segments_; }  ///< of the axiom, saturating

 private:
  friend class DrawingMaker;
  std::vector<SymbolDrawing> drawings_;
  std::vector<Index> parts_;
  std::size_t axiom_parts_ = 0;
  std::uint64_t segments_ = 0;
};

}  // namespace phytobench
