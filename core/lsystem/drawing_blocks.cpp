// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_blocks.hpp"

#include <type_traits>

#include "core/lsystem/drawing_walk.hpp"

namespace phytobench {

namespace {

/// Kept drawings are read again and again: all of them have to stay in a cache of the processor.
constexpr std::uint64_t most_kept_bytes = 256 * 1024;

}  // namespace

template <class Turtle>
DrawingBlocks<Turtle>::DrawingBlocks(const SymbolDrawings& drawings, const Turtle& turtle)
    : drawings_(drawings), entries_(drawings.all().size()) {
  make_leaves(turtle);
  const std::vector<bool> kept = chosen();
  for (SymbolDrawings::Index d = 0; d < entries_.size(); ++d)
    if (kept[d]) keep(d, turtle);
}

template <class Turtle>
void DrawingBlocks<Turtle>::make_leaves(const Turtle& turtle) {
  for (SymbolDrawings::Index d = 0; d < entries_.size(); ++d) {
    const SymbolDrawing& drawing = drawings_.all()[d];
    Entry& entry = entries_[d];
    entry.first = drawing.first_part;
    entry.count = drawing.part_count;
    if (drawing.part_count == 0) {
      entry.kind = drawing.segments > 0 ? Kind::block : Kind::motion;
      entry.motion = turtle.motion_of(drawing.command);
    } else if (drawing.segments == 0) {
      entry.kind = Kind::motion;
      for (const SymbolDrawings::Index part : drawings_.parts_of(d))
        turtle.move(entry.motion, entries_[part].motion);
    }
    if (entry.kind != Kind::block) continue;
    typename Turtle::Segment segment{};
    if constexpr (std::is_same_v<Turtle, PlaneTurtle>)
      segment.to_x = entry.motion.x;
    else
      segment.to = entry.motion.position;
    entry.first = blocks_.add(std::span(&segment, 1));
    entry.count = 1;
  }
}

/// Small drawings that a large one asks for.
template <class Turtle>
std::vector<bool> DrawingBlocks<Turtle>::kept_up_to(std::uint64_t limit) const {
  std::vector<bool> asked(entries_.size(), false), kept(asked);
  const auto ask_for = [&](std::span<const SymbolDrawings::Index> parts) {
    for (const SymbolDrawings::Index part : parts)
      if (part < SymbolDrawings::restore) asked[part] = true;
  };
  ask_for(drawings_.parts_of_axiom());
  for (std::size_t d = entries_.size(); d-- > 0;) {
    if (!asked[d] || entries_[d].kind != Kind::parts) continue;
    if (drawings_.all()[d].segments <= limit)
      kept[d] = true;
    else
      ask_for(drawings_.parts_of(static_cast<SymbolDrawings::Index>(d)));
  }
  return kept;
}

template <class Turtle>
std::vector<bool> DrawingBlocks<Turtle>::chosen() const {
  for (std::uint64_t limit = most_segments;; limit /= 2) {
    std::vector<bool> kept = kept_up_to(limit);
    std::uint64_t bytes = 0;
    for (std::size_t d = 0; d < kept.size(); ++d)
      if (kept[d]) bytes += drawings_.all()[d].segments * sizeof(typename Turtle::Segment);
    if (bytes <= most_kept_bytes) return kept;
    if (limit <= 1) return std::vector<bool>(kept.size(), false);
  }
}

template <class Turtle>
void DrawingBlocks<Turtle>::keep(SymbolDrawings::Index drawing, const Turtle& turtle) {
  std::vector<typename Turtle::Segment> segments(
      static_cast<std::size_t>(drawings_.all()[drawing].segments));
  auto* out = segments.data();
  DrawingWalk<Turtle> walk(drawings_, entries_, turtle, drawings_.parts_of(drawing), {});
  walk.run(~std::uint64_t{0}, [&](const Entry& entry, const typename Turtle::State& state) {
    turtle.write(blocks_, entry.first, entry.count, state, out, Stores::cached);
    out += entry.count;
  });
  Entry& entry = entries_[drawing];
  entry.kind = Kind::block;
  entry.first = blocks_.add(segments);
  entry.count = static_cast<std::uint32_t>(segments.size());
  entry.motion = walk.state();
}

template class DrawingBlocks<PlaneTurtle>;
template class DrawingBlocks<SpaceTurtle>;

}  // namespace phytobench
