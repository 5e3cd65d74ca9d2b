// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/overlap/crossing.hpp"
#include "core/overlap/neighbourhood.hpp"

namespace phytobench {

/// A place on a circle where it enters or leaves another disc, or the ground beyond a side of a
/// window.
struct CircleEvent {
  double key;     ///< turn_key() seen from the circle's center
  Point2 local;   ///< from the circle's center
  Point2 global;  ///< the same bits as on whatever is met there
  int met;        ///< whom: place among the circle's neighbours, or what add_arc() was given
  int step;       ///< +1 enters, -1 leaves
};

/// Piece of a circle between two neighbouring events, counter-clockwise.
struct CircleArc {
  const CircleEvent& from;
  const CircleEvent& to;
  double segment;  ///< area between arc and chord

  /// Integral of (x dy - y dx) / 2 along the arc, seen from the circle's center.
  double around_center() const { return segment + 0.5 * cross(from.local, to.local - from.local); }
  /// The same seen from the origin of the neighbourhood.
  double around_origin() const {
    return segment + 0.5 * cross(from.global, to.global - from.global);
  }
};

/// Walks around the circles of a neighbourhood, one after the other, and tells by which discs each
/// of their places is covered. Decides like from both sides of a pair: of two discs that are one
/// and the same, the later counts as the larger.
class CircleWalk {
 public:
  explicit CircleWalk(const Neighbourhood& n) : n_(n) {}

  /// Takes up circle i, to be walked around amid its neighbours.
  void begin(std::size_t i);

  /// Something else covers the arc between two places, or the whole circle; `met` < 0.
  void add_arc(const Point2& enter, const Point2& at_enter, const Point2& exit,
               const Point2& at_exit, int met);
  void add_everywhere(int met) { at_start_.push_back(met); }

  /// Whether nothing begins or ends on the circle: all of it is covered by at_start().
  bool is_uncut() const { return events_.empty(); }
  std::span<const int> at_start() const { return at_start_; }

  /// Calls change(met, +1 or -1) for whatever begins or ends to cover the walk's place and
  /// piece(CircleArc) for every piece in between. Call it once, and not for an uncut circle.
  template <class Change, class Piece>
  void walk(const Change& change, const Piece& piece) {
    sort();
    for (const int met : at_start_) change(met, +1);
    for (std::size_t e = 0; e < events_.size(); ++e) {
      const CircleEvent &from = events_[e], &to = events_[e + 1 < events_.size() ? e + 1 : 0];
      change(from.met, from.step);
      double turned = to.key - from.key;
      if (turned < 0.0 || &from == &to) turned += 4.0;
      if (turned == 0.0) continue;
      const double angle = angle_between(from.local, to.local, turned);
      piece(CircleArc{from, to, segment_area(n_.radius[i_], angle)});
    }
  }

 private:
  void meet(std::size_t j, int met);
  bool hides_behind(const Point2& place, int met) const;
  void sort();

  const Neighbourhood& n_;
  std::size_t i_ = 0;
  std::vector<CircleEvent> events_;
  std::vector<int> at_start_;  ///< where the walk begins, in the direction of x
};

}  // namespace phytobench
