// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/spine.hpp"

#include <algorithm>

#include "core/contract/check.hpp"

namespace phytobench {

Frame Spine::at(double share) const {
  PHYTOBENCH_EXPECT(share >= 0.0 && share <= 1.0);
  const double along = share * static_cast<double>(pieces.size());
  const std::size_t piece = std::min(static_cast<std::size_t>(along), pieces.size() - 1);
  Frame frame = pieces[piece];
  frame.origin = frame.origin + ((along - static_cast<double>(piece)) * piece_length) * frame.y;
  return frame;
}

Frame halfway(const Frame& before, const Frame& behind) {
  Frame middle = behind;
  middle.x = before.x + behind.x;
  middle.y = before.y + behind.y;
  constexpr double flat = 1e-6;
  const double length = norm(middle.y);
  if (!(length > flat) || !(norm(cross(middle.x, middle.y)) > flat * length)) return behind;
  return orthonormal(middle);
}

Spine make_spine(double length, int pieces, const SpineTurn& turn) {
  PHYTOBENCH_EXPECT(pieces >= 1);
  Spine spine;
  spine.piece_length = length / pieces;
  Frame frame;
  spine.rings.push_back(frame);
  for (int i = 0; i < pieces; ++i) {
    const Frame behind = orthonormal(turn(frame, i));
    if (i > 0) spine.rings.push_back(halfway(frame, behind));
    spine.pieces.push_back(behind);
    frame = behind;
    frame.origin = frame.origin + spine.piece_length * frame.y;
  }
  spine.rings.push_back(orthonormal(turn(frame, pieces)));
  return spine;
}

}  // namespace phytobench
