// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/lsystem/plane_turtle.hpp"
#include "core/lsystem/space_turtle.hpp"
#include "core/lsystem/symbol_drawings.hpp"

namespace phytobench {

/// Drawings that are kept, each in the frame in which it begins, and how every drawing without
/// parts, or without segments, or kept, moves the turtle. A drawing is kept if it is small and a
/// part of a large one.
template <class Turtle>
class DrawingBlocks {
 public:
  /// No kept drawing has more.
  static constexpr std::uint32_t most_segments = 512;

  DrawingBlocks(const SymbolDrawings& drawings, const Turtle& turtle);

  /// What to do with a drawing.
  struct Entry {
    enum class Kind : std::uint8_t {
      parts,   ///< draw its parts
      motion,  ///< move the turtle
      block,   ///< write the kept drawing, and move the turtle
    };
    Kind kind = Kind::parts;
    std::uint32_t first = 0;  ///< part, or segment
    std::uint32_t count = 0;  ///< of parts, or segments
    typename Turtle::State motion;
  };

  const std::vector<Entry>& entries() const { return entries_; }
  const typename Turtle::Blocks& blocks() const { return blocks_; }

 private:
  using Kind = typename Entry::Kind;

  void make_leaves(const Turtle& turtle);
  std::vector<bool> kept_up_to(std::uint64_t limit) const;
  std::vector<bool> chosen() const;
  void keep(SymbolDrawings::Index drawing, const Turtle& turtle);

  const SymbolDrawings& drawings_;
  std::vector<Entry> entries_;
  typename Turtle::Blocks blocks_;
};

extern template class DrawingBlocks<PlaneTurtle>;
extern template class DrawingBlocks<SpaceTurtle>;

}  // namespace phytobench
