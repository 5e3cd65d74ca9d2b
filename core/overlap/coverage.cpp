// SPDX-License-Identifier: MIT
// The region covered at least k times is bounded by arcs that k - 1 other discs cover: inside there
// is one more. So one walk around each circle, with the number of covering discs at hand, gives all
// areas at once (Green). What only disc i covers is bounded by its own arcs that nobody covers and,
// turned round, by arcs of others that i alone covers.
#include "core/overlap/coverage.hpp"

#include <algorithm>
#include <array>
#include <numeric>

#include "core/overlap/circle_walk.hpp"
#include "core/overlap/neighbourhood.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

constexpr int beyond_window = -1;

/// Others at some place of a circle. Where there is one, the sum is its place among the neighbours.
struct Cover {
  int count = 0;
  std::int64_t sum = 0;
  int outside = 0;  ///< sides of the window that the place lies beyond

  void add(int met, int step) {
    if (met == beyond_window) {
      outside += step;
      return;
    }
    count += step;
    sum += std::int64_t{step} * met;
  }
};

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

class CoverageWalk {
 public:
  CoverageWalk(const Neighbourhood& n, const std::optional<Rectangle>& window, Findings& findings)
      : n_(n), window_(window), findings_(findings), circle_(n) {}

  void around(std::size_t i) {
    i_ = i;
    circle_.begin(i);
    if (window_) meet_window();
    cover_ = Cover();
    if (circle_.is_uncut()) {
      whole_circle();
      return;
    }
    circle_.walk([this](int met, int step) { cover_.add(met, step); },
                 [this](const CircleArc& piece) { arc(piece); });
  }

 private:
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
      circle_.add_everywhere(beyond_window);
      return;
    }
    const double half = std::sqrt((r - inside) * (r + inside));
    const Point2 foot = inside * outwards, along{-half * outwards.y, half * outwards.x};
    circle_.add_arc(foot - along, at(-half), foot + along, at(half), beyond_window);
    findings_.sides.push_back({side, at(-half), at(half)});
  }

  void arc(const CircleArc& piece) {
    if (cover_.outside == 0) add_times(piece.around_origin());
    if (cover_.count <= 1) add_alone(piece.around_center(), piece.to.local - piece.from.local);
  }

  void whole_circle() {
    for (const int met : circle_.at_start()) cover_.add(met, +1);
    const double area = std::numbers::pi * n_.radius[i_] * n_.radius[i_];
    if (cover_.outside == 0) add_times(area);
    if (cover_.count <= 1) add_alone(area, {});
  }

  void add_times(double area) {
    findings_.add_times(cover_.count + 1, area);
    if (cover_.count > 0) findings_.add_times(cover_.count, -area);
  }

  /// `area` as seen from this circle's center, `chord` the way from the arc's begin to its end.
  void add_alone(double area, const Point2& chord) {
    if (cover_.count == 0) {
      findings_.alone.emplace_back(static_cast<DiscIndex>(i_), area);
      return;
    }
    const DiscIndex other = n_.neighbours(i_)[static_cast<std::size_t>(cover_.sum)];
    const auto c = static_cast<std::size_t>(other);
    if (n_.is_image(c)) return;  // its original has this arc's image
    const Point2 shift = n_.center[i_] - n_.center[c];
    findings_.alone.emplace_back(other, -(area + 0.5 * cross(shift, chord)));
  }

  const Neighbourhood& n_;
  const std::optional<Rectangle>& window_;
  Findings& findings_;
  CircleWalk circle_;
  std::size_t i_ = 0;
  Cover cover_;
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

/// Seen from the middle of the window, or else of all centers, coordinates are short.
Point2 middle_of(const Discs& discs, const std::optional<Rectangle>& window) {
  if (window) return 0.5 * (window->low + window->high);
  if (discs.size() == 0) return {};
  const auto [x_low, x_high] = std::minmax_element(discs.x.begin(), discs.x.end());
  const auto [y_low, y_high] = std::minmax_element(discs.y.begin(), discs.y.end());
  return 0.5 * (Point2{*x_low, *y_low} + Point2{*x_high, *y_high});
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
    if (n.is_image(e) || n.neighbours(e).empty()) continue;
    const double area = std::numbers::pi * n.radius[e] * n.radius[e];
    result.covered[static_cast<std::size_t>(n.disc[e])] = std::clamp(area - alone[e], 0.0, area);
  }
  return result;
}

}  // namespace

Coverage coverage(const Discs& discs, const Ground& ground, const std::optional<Rectangle>& window,
                  int threads, std::size_t most_pairs) {
  std::optional<Rectangle> counted = ground.torus ? ground.torus : window;
  const Point2 origin = middle_of(discs, counted);
  const Neighbourhood n = neighbourhood_of(
      discs, ground, origin, own_pair_finder({.threads = threads, .most_pairs = most_pairs}));
  if (counted) counted = Rectangle{counted->low - origin, counted->high - origin};
  constexpr std::size_t job_size = 2048;
  std::vector<Findings> found((n.size() + job_size - 1) / job_size);
  for_tasks(found.size(), threads, [&](std::size_t job) {
    CoverageWalk walk(n, counted, found[job]);
    for (std::size_t i = job * job_size; i < std::min(n.size(), (job + 1) * job_size); ++i)
      walk.around(i);
  });
  return put_together(discs, n, found, counted);
}

}  // namespace phytobench
