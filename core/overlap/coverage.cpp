// SPDX-License-Identifier: MIT
// The region covered at least k times is bounded by arcs that k - 1 other discs cover: inside there
// is one more. So one walk around each circle, with the number of covering discs at hand, gives all
// areas at once (Green). What only disc i covers is bounded by its own arcs that nobody covers and,
// turned round, by arcs of others that i alone covers.
#include "core/overlap/coverage.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/contract/check.hpp"
#include "core/overlap/candidate_pairs.hpp"
#include "core/overlap/crossing.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// Discs with their images, as plain discs of the plane around 0, and who overlaps whom.
struct Neighbourhood {
  std::vector<Point2> center;
  std::vector<double> radius;
  std::vector<DiscIndex> disc;  ///< -1 for an image
  std::vector<std::size_t> begin;
  std::vector<DiscIndex> neighbour;

  std::size_t size() const { return center.size(); }
  std::span<const DiscIndex> neighbours(std::size_t i) const {
    return std::span(neighbour).subspan(begin[i], begin[i + 1] - begin[i]);
  }
};

void list_neighbours(const OverlapPairs& pairs, Neighbourhood& n) {
  n.begin.assign(n.size() + 1, 0);
  for (const auto& side : {pairs.first(), pairs.second()})
    for (const DiscIndex i : side) ++n.begin[static_cast<std::size_t>(i) + 1];
  std::partial_sum(n.begin.begin(), n.begin.end(), n.begin.begin());
  n.neighbour.resize(n.begin.back());
  std::vector<std::size_t> next(n.begin.begin(), n.begin.end() - 1);
  for (std::size_t p = 0; p < pairs.size(); ++p) {
    const DiscIndex i = pairs.first()[p], j = pairs.second()[p];
    n.neighbour[next[static_cast<std::size_t>(i)]++] = j;
    n.neighbour[next[static_cast<std::size_t>(j)]++] = i;
  }
}

Neighbourhood neighbourhood_of(const Discs& discs, const Ground& ground, const Point2& origin,
                               const OverlapSetup& setup) {
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  Neighbourhood n;
  std::vector<double> x, y;
  for (const DiscEntry& e : entries) {
    x.push_back(e.x - origin.x);
    y.push_back(e.y - origin.y);
    n.center.push_back({x.back(), y.back()});
    n.radius.push_back(e.radius);
    n.disc.push_back(e.is_image() ? DiscIndex{-1} : e.disc);
  }
  OverlapPairs pairs;
  overlap_engine_named("layered_grid").create()->find({x, y, n.radius}, {}, setup, pairs);
  list_neighbours(pairs, n);
  return n;
}

/// A place on a circle where it enters or leaves another disc, or the ground beyond a side of the
/// window.
struct Event {
  double key;
  Point2 local;   ///< from the circle's center
  Point2 global;  ///< the same bits as on whatever is met there
  DiscIndex other;
  int step;  ///< +1 enters, -1 leaves
};

/// Other discs at some place of a circle. Where there is one, the sum of their numbers is its own.
struct Cover {
  int count = 0;
  std::int64_t sum = 0;
  int outside = 0;  ///< sides of the window that the place lies beyond

  void add(DiscIndex other, int step) {
    if (other < 0) {
      outside += step;
      return;
    }
    count += step;
    sum += std::int64_t{step} * other;
  }
};

constexpr DiscIndex beyond_window = -1;

/// Part of a side of the window that a disc covers.
struct SideInterval {
  int side;
  Point2 from, to;  ///< counter-clockwise around the window
};

/// What one job finds; put together in the order of the jobs.
struct Findings {
  std::vector<double> by_times;
  std::vector<std::pair<DiscIndex, double>> alone;  ///< part of what only that disc covers
  std::vector<SideInterval> sides;

  void add_times(int times, double area) {
    const auto k = static_cast<std::size_t>(times);
    if (by_times.size() <= k) by_times.resize(k + 1, 0.0);
    by_times[k] += area;
  }
};

class CircleWalk {
 public:
  CircleWalk(const Neighbourhood& n, const std::optional<Rectangle>& window, Findings& findings)
      : n_(n), window_(window), findings_(findings) {}

  void around(std::size_t i) {
    i_ = i;
    events_.clear();
    start_ = Cover();
    for (const DiscIndex j : n_.neighbours(i)) meet(static_cast<std::size_t>(j));
    if (window_) meet_window();
    if (events_.empty()) {
      whole_circle();
      return;
    }
    std::sort(events_.begin(), events_.end(), [](const Event& a, const Event& b) {
      return a.key != b.key     ? a.key < b.key
             : a.step != b.step ? a.step > b.step
                                : a.other < b.other;
    });
    Cover cover = start_;
    for (std::size_t e = 0; e < events_.size(); ++e) {
      cover.add(events_[e].other, events_[e].step);
      arc(events_[e], events_[e + 1 < events_.size() ? e + 1 : 0], cover);
    }
  }

 private:
  void meet(std::size_t j) {
    const double r = n_.radius[i_], s = n_.radius[j];
    // The smaller disc's view of the two, the same from both sides.
    const bool is_small = r < s || (r == s && i_ < j);
    const std::size_t a = is_small ? i_ : j, b = is_small ? j : i_;
    const Point2 between = n_.center[b] - n_.center[a];
    const double distance = norm(between);
    const double small = n_.radius[a], large = n_.radius[b];
    if (distance <= large - small) {
      // Of two that are one and the same, the later counts as the larger.
      if (is_small) start_.add(static_cast<DiscIndex>(j), +1);
      return;
    }
    if (distance - large >= small) return;  // touching, once the origin has moved
    const Crossing c = crossing_of(small, large, between, distance);
    const Point2 at_enter = n_.center[a] + c.enter, at_exit = n_.center[a] + c.exit;
    if (is_small)
      add_arc(c.enter, at_enter, c.exit, at_exit, static_cast<DiscIndex>(j));
    else
      add_arc(c.exit - between, at_exit, c.enter - between, at_enter, static_cast<DiscIndex>(j));
  }

  /// Covered by `other` from `enter` to `exit`.
  void add_arc(const Point2& enter, const Point2& at_enter, const Point2& exit,
               const Point2& at_exit, DiscIndex other) {
    const double from = turn_key(enter), to = turn_key(exit);
    if (from == to) {
      // Hardly anything or nearly all: the other disc lies that way, or all around.
      const bool nearly_all = other >= 0 && dot(enter, n_.center[static_cast<std::size_t>(other)] -
                                                           n_.center[i_]) < 0.0;
      if (nearly_all) start_.add(other, +1);
      return;
    }
    if (from > to) start_.add(other, +1);  // goes through the direction where the walk begins
    events_.push_back({from, enter, at_enter, other, +1});
    events_.push_back({to, exit, at_exit, other, -1});
  }

  /// Sides in the order bottom, right, top, left; outside is to the right of each.
  void meet_window() {
    const Rectangle& w = *window_;
    const Point2 c = n_.center[i_];
    meet_side(0, {0, -1}, c.y - w.low.y, [&](double h) { return Point2{c.x + h, w.low.y}; });
    meet_side(1, {1, 0}, w.high.x - c.x, [&](double h) { return Point2{w.high.x, c.y + h}; });
    meet_side(2, {0, 1}, w.high.y - c.y, [&](double h) { return Point2{c.x - h, w.high.y}; });
    meet_side(3, {-1, 0}, c.x - w.low.x, [&](double h) { return Point2{w.low.x, c.y - h}; });
  }

  /// `inside` is how far the center lies inside, `outwards` the side's normal, `at(h)` its point
  /// h beyond the foot of the center, counter-clockwise.
  template <class At>
  void meet_side(int side, const Point2& outwards, double inside, const At& at) {
    const double r = n_.radius[i_];
    if (inside >= r) return;
    if (inside <= -r) {
      start_.add(beyond_window, +1);
      return;
    }
    const double half = std::sqrt((r - inside) * (r + inside));
    const Point2 foot = inside * outwards, along{-half * outwards.y, half * outwards.x};
    add_arc(foot - along, at(-half), foot + along, at(half), beyond_window);
    findings_.sides.push_back({side, at(-half), at(half)});
  }

  void arc(const Event& from, const Event& to, const Cover& cover) {
    double turned = to.key - from.key;
    if (turned < 0.0 || &from == &to) turned += 4.0;
    if (turned == 0.0) return;
    const double radius = n_.radius[i_];
    const double segment = segment_area(radius, angle_between(from.local, to.local, turned));
    if (cover.outside == 0)
      add_times(cover, segment + 0.5 * cross(from.global, to.global - from.global));
    if (cover.count > 1) return;
    const Point2 chord = to.local - from.local;
    const double around_own = segment + 0.5 * cross(from.local, chord);
    add_alone(cover, around_own, chord);
  }

  void whole_circle() {
    const double area = std::numbers::pi * n_.radius[i_] * n_.radius[i_];
    if (start_.outside == 0) add_times(start_, area);
    if (start_.count <= 1) add_alone(start_, area, {});
  }

  void add_times(const Cover& cover, double area) {
    findings_.add_times(cover.count + 1, area);
    if (cover.count > 0) findings_.add_times(cover.count, -area);
  }

  /// `area` as seen from this circle's center, `chord` the way from the arc's begin to its end.
  void add_alone(const Cover& cover, double area, const Point2& chord) {
    if (cover.count == 0) {
      findings_.alone.emplace_back(static_cast<DiscIndex>(i_), area);
      return;
    }
    if (cover.count != 1) return;
    const auto c = static_cast<std::size_t>(cover.sum);
    if (n_.disc[c] < 0) return;  // its original has this arc's image
    const Point2 shift = n_.center[i_] - n_.center[c];
    findings_.alone.emplace_back(static_cast<DiscIndex>(c), -(area + 0.5 * cross(shift, chord)));
  }

  const Neighbourhood& n_;
  const std::optional<Rectangle>& window_;
  Findings& findings_;
  std::size_t i_ = 0;
  std::vector<Event> events_;
  Cover start_;
};

/// The window's border belongs to the border of what is covered inside.
void add_sides(const Rectangle& window, const std::vector<SideInterval>& intervals,
               Findings& total) {
  const std::array<Point2, 5> corners = {window.low, Point2{window.high.x, window.low.y},
                                         window.high, Point2{window.low.x, window.high.y},
                                         window.low};
  struct Step {
    double along;
    Point2 at;
    int step;
  };
  for (std::size_t side = 0; side < 4; ++side) {
    const Point2 begin = corners[side], end = corners[side + 1];
    const double length = norm(end - begin);
    const Point2 direction = (1.0 / length) * (end - begin);
    std::vector<Step> steps;
    const auto add = [&](const Point2& at, int step) {
      const double along = dot(at - begin, direction);
      if (along <= 0.0)
        steps.push_back({0.0, begin, step});
      else if (along >= length)
        steps.push_back({length, end, step});
      else
        steps.push_back({along, at, step});
    };
    for (const SideInterval& interval : intervals) {
      if (interval.side != static_cast<int>(side)) continue;
      add(interval.from, +1);
      add(interval.to, -1);
    }
    std::stable_sort(steps.begin(), steps.end(),
                     [](const Step& a, const Step& b) { return a.along < b.along; });
    int times = 0;
    for (std::size_t s = 0; s + 1 < steps.size(); ++s) {
      times += steps[s].step;
      if (times > 0)
        total.add_times(times, 0.5 * cross(steps[s].at, steps[s + 1].at - steps[s].at));
    }
  }
}

Rectangle box_of(const Discs& discs) {
  const auto [x_low, x_high] = std::minmax_element(discs.x.begin(), discs.x.end());
  const auto [y_low, y_high] = std::minmax_element(discs.y.begin(), discs.y.end());
  return {{*x_low, *y_low}, {*x_high, *y_high}};
}

/// Adds up what the jobs have found, in their order.
Coverage put_together(const Discs& discs, const Neighbourhood& n,
                      const std::vector<Findings>& found, const std::optional<Rectangle>& window) {
  Findings total;
  std::vector<SideInterval> sides;
  std::vector<double> alone(n.size(), 0.0);
  for (const Findings& part : found) {
    for (std::size_t k = 0; k < part.by_times.size(); ++k)
      total.add_times(static_cast<int>(k), part.by_times[k]);
    for (const auto& [i, area] : part.alone) alone[static_cast<std::size_t>(i)] += area;
    sides.insert(sides.end(), part.sides.begin(), part.sides.end());
  }
  if (window) add_sides(*window, sides, total);
  Coverage result;
  result.by_times = std::move(total.by_times);
  if (result.by_times.empty()) result.by_times.push_back(0.0);
  result.by_times[0] = 0.0;
  if (window)
    result.by_times[0] =
        window->area() - std::accumulate(result.by_times.begin(), result.by_times.end(), 0.0);
  for (double& area : result.by_times) area = std::max(0.0, area);  // rounding may leave -1e-16
  result.covered.assign(discs.size(), 0.0);
  for (std::size_t e = 0; e < n.size(); ++e) {
    if (n.disc[e] < 0 || n.neighbours(e).empty()) continue;
    const double area = std::numbers::pi * n.radius[e] * n.radius[e];
    result.covered[static_cast<std::size_t>(n.disc[e])] = std::clamp(area - alone[e], 0.0, area);
  }
  return result;
}

}  // namespace

Coverage coverage(const Discs& discs, const Ground& ground, const std::optional<Rectangle>& window,
                  int threads, std::size_t most_pairs) {
  std::optional<Rectangle> counted = ground.torus ? ground.torus : window;
  Point2 origin;
  if (counted || discs.size() > 0) {
    const Rectangle box = counted ? *counted : box_of(discs);
    origin = 0.5 * (box.low + box.high);
  }
  const Neighbourhood n =
      neighbourhood_of(discs, ground, origin, {.threads = threads, .most_pairs = most_pairs});
  if (counted) counted = Rectangle{counted->low - origin, counted->high - origin};
  constexpr std::size_t job_size = 2048;
  std::vector<Findings> found((n.size() + job_size - 1) / job_size);
  for_tasks(found.size(), threads, [&](std::size_t job) {
    CircleWalk walk(n, counted, found[job]);
    for (std::size_t i = job * job_size; i < std::min(n.size(), (job + 1) * job_size); ++i)
      walk.around(i);
  });
  return put_together(discs, n, found, counted);
}

}  // namespace phytobench
