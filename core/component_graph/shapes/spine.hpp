// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/component_graph/frame.hpp"

namespace phytobench {

/// The axis of a stem: straight pieces of one length, each turned against the one before
/// ([Lintermann1997] fig. 3a: point sets that are given relative to each other).
struct Spine {
  double piece_length = 0.0;
  std::vector<Frame> pieces;  ///< where each begins, with y along it; at least one
  /// One more than pieces: the directions at both ends, and halfway between two pieces.
  std::vector<Frame> rings;

  /// Where what follows the stem begins.
  const Frame& end() const { return rings.back(); }
  /// The place at a share [0, 1] of the length, with the directions of the piece that it is on.
  Frame at(double share) const;
};

/// How the axis turns at joint 0 (before the first piece), 1 ... n - 1, and n (behind the last).
/// Takes the frame before the joint and gives the one behind it, at the same place.
using SpineTurn = std::function<Frame(const Frame&, int joint)>;

/// Begins in the directions of the identity, which the first ring keeps. `pieces` >= 1.
Spine make_spine(double length, int pieces, const SpineTurn& turn);

/// Directions halfway between two frames, at the place of the second; those of the second where
/// they are opposite.
Frame halfway(const Frame& before, const Frame& behind);

}  // namespace phytobench
