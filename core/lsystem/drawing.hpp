// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/vector3.hpp"
#include "core/lsystem/word.hpp"
#include "core/memory/large_array.hpp"
#include "core/tree/skeleton.hpp"

namespace phytobench {

/// The turtle's frame: heading, left and up, of length 1, with heading x left = up.
struct TurtleFrame {
  Vector3 heading{0, 1, 0};
  Vector3 left{-1, 0, 0};
  Vector3 up{0, 0, 1};
};

struct TurtleSegment {
  Vector3 from, to;
  float width = 1.0f;
  std::uint16_t colour = 0;  ///< index that ' counts
};

/// A filled outline: corners [first, first + count) of Drawing::corners.
struct TurtlePolygon {
  std::size_t first = 0;
  std::uint32_t count = 0;
  std::uint16_t colour = 0;
};

/// Where the widths of a drawing are from.
enum class WidthSource : std::uint8_t {
  nowhere,     ///< no width was said: all are the default
  proportion,  ///< ! without a parameter alone: what they are to each other was said
  given,       ///< `width:`, !(w) or F(l, w): in length units
};

/// What the turtle left behind, in the order in which it did.
struct Drawing {
  LargeVector<TurtleSegment> segments;
  std::vector<TurtlePolygon> polygons;
  std::vector<Vector3> corners;
  Vector3 end;  ///< where the turtle stands at last
  TurtleFrame end_frame;
  bool planar = false;  ///< the system has no symbol that leaves the plane
  WidthSource width_source = WidthSource::nowhere;
};

/// Symbols: F and other letters of settings.draws move and draw, f only moves, + - turn, & ^ pitch,
/// \ / roll, | turns by 180 degrees, $ rolls until left is horizontal, [ ] store and restore, { }
/// enclose a polygon, . sets a corner without moving, ! and !(w) set the width, ' and '(c) the
/// colour, % cuts off the rest of the branch. F(l) f(l) +(d) and so on take their parameter, F(l,
/// w) a width, too; further parameters mean nothing. All other symbols mean nothing. Polygons: as
/// in The Algorithmic Beauty of Plants, app. C, F inside { } draws its line and sets a corner where
/// it ends, f sets the corner alone; the first corner is where { stands. Lines of an outline are
/// segments like all others, in the tree, too. Letters that draw without a corner (the book's G)
/// there are none: one of `draw:` is like F. Cuts: % hides what follows from the turtle and leaves
/// the word as it is. Derivation goes on with what is cut off, counts have it, contexts see it.
/// Removed in every step, as the book says, it would leave the same drawing, but where contexts
/// look at it or random numbers are drawn, which belong to places in the word. In the plane the
/// heading is an angle in degrees and turns are exact; in space the frame is made orthonormal again
/// every 32 turns. Throws InputError if the word nests polygons, or stores deeper than a million
/// states.
Drawing draw(const LSystem& system, const Word& word);

/// The tree of [Liebemann2017] sec. 2.4.1: a node for each drawn segment, below the node that the
/// turtle came from; the root is where it began. As many nodes as draw() has segments, and one.
/// Throws InputError if the turtle draws after a move without drawing (no connected tree).
struct TurtleTree {
  Skeleton skeleton{Vector3{}};
  std::vector<float>
      widths;  ///< per node, of the segment that leads to it; the root as its first child
  std::vector<std::uint16_t> colours;  ///< the same
  WidthSource width_source = WidthSource::nowhere;
};
TurtleTree turtle_tree(const LSystem& system, const Word& word);

/// Fills the parameters of query symbols with the turtle's state before them: ?P position, ?H ?L ?U
/// the frame; as many coordinates as they have parameters, at most three.
void answer_queries(const LSystem& system, Word& word);

/// Degrees to a direction in the plane; exact at multiples of 90.
struct PlaneDirection {
  double x, y;
};
PlaneDirection plane_direction(double degrees);

}  // namespace phytobench
