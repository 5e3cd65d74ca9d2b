// SPDX-License-Identifier: MIT
#include "core/overlap/circle_walk.hpp"

#include <algorithm>

namespace phytobench {

void CircleWalk::begin(std::size_t i) {
  i_ = i;
  events_.clear();
  at_start_.clear();
  int met = 0;
  for (const DiscIndex j : n_.neighbours(i)) meet(static_cast<std::size_t>(j), met++);
}

void CircleWalk::meet(std::size_t j, int met) {
  const double r = n_.radius[i_], s = n_.radius[j];
  // The smaller disc's view of the two, the same from both sides.
  const bool is_small = r < s || (r == s && i_ < j);
  const std::size_t a = is_small ? i_ : j, b = is_small ? j : i_;
  const Point2 between = n_.center[b] - n_.center[a];
  const double distance = norm(between);
  const double small = n_.radius[a], large = n_.radius[b];
  if (distance <= large - small) {
    if (is_small) add_everywhere(met);
    return;
  }
  if (distance - large >= small) return;  // touching, once the origin has moved
  const Crossing c = crossing_of(small, large, between, distance);
  const Point2 at_enter = n_.center[a] + c.enter, at_exit = n_.center[a] + c.exit;
  if (is_small)
    add_arc(c.enter, at_enter, c.exit, at_exit, met);
  else
    add_arc(c.exit - between, at_exit, c.enter - between, at_enter, met);
}

void CircleWalk::add_arc(const Point2& enter, const Point2& at_enter, const Point2& exit,
                         const Point2& at_exit, int met) {
  const double from = turn_key(enter), to = turn_key(exit);
  if (from == to) {
    // Hardly anything or nearly all.
    if (met >= 0 && hides_behind(enter, met)) add_everywhere(met);
    return;
  }
  if (from > to) add_everywhere(met);  // goes through the direction where the walk begins
  events_.push_back({from, enter, at_enter, met, +1});
  events_.push_back({to, exit, at_exit, met, -1});
}

/// Whether the neighbour lies the other way than that place of the circle.
bool CircleWalk::hides_behind(const Point2& place, int met) const {
  const DiscIndex j = n_.neighbours(i_)[static_cast<std::size_t>(met)];
  return dot(place, n_.center[static_cast<std::size_t>(j)] - n_.center[i_]) < 0.0;
}

void CircleWalk::sort() {
  std::sort(events_.begin(), events_.end(), [](const CircleEvent& a, const CircleEvent& b) {
    return a.key != b.key ? a.key < b.key : a.step != b.step ? a.step > b.step : a.met < b.met;
  });
}

}  // namespace phytobench
