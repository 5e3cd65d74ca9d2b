// SPDX-License-Identifier: MIT
#include "core/point_pattern/null_models.hpp"

#include <algorithm>

#include "core/contract/check.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

std::vector<Point2> random_pattern(const Window& window, std::size_t count, std::uint64_t seed,
                                   std::uint64_t index) {
  CounterStream stream(seed, index);
  return uniform_points(window, count, stream);
}

std::vector<Point2> box_filling_pattern(const Window& window, std::size_t count, std::uint64_t seed,
                                        std::uint64_t index) {
  PHYTOBENCH_EXPECT(count >= 2 && window.kind() != WindowKind::polygon);
  std::vector<Point2> points = random_pattern(window, count, seed, index);
  const Rectangle& box = window.bounding_box();
  const auto stretch = [&points](double Point2::*axis, double low, double high) {
    const auto [least, largest] =
        std::minmax_element(points.begin(), points.end(),
                            [axis](const Point2& a, const Point2& b) { return a.*axis < b.*axis; });
    const double from = (*least).*axis, length = (*largest).*axis - from;
    for (Point2& p : points)
      p.*axis = std::clamp(low + (p.*axis - from) / length * (high - low), low, high);
  };
  stretch(&Point2::x, box.low.x, box.high.x);
  stretch(&Point2::y, box.low.y, box.high.y);
  return points;
}

std::vector<double> relabelled(std::span<const double> marks, std::uint64_t seed,
                               std::uint64_t index) {
  CounterStream stream(seed, index);
  std::vector<double> labels;
  labels.reserve(marks.size());
  for (const std::size_t i : random_order(marks.size(), stream)) labels.push_back(marks[i]);
  return labels;
}

TwoSpecies relabelled(std::span<const Point2> first, std::span<const Point2> second,
                      std::uint64_t seed, std::uint64_t index) {
  CounterStream stream(seed, index);
  TwoSpecies result;
  for (const std::size_t i : random_order(first.size() + second.size(), stream)) {
    const Point2& point = i < first.size() ? first[i] : second[i - first.size()];
    (result.first.size() < first.size() ? result.first : result.second).push_back(point);
  }
  return result;
}

std::vector<Point2> torus_shifted(std::span<const Point2> points, const Window& window,
                                  std::uint64_t seed, std::uint64_t index) {
  PHYTOBENCH_EXPECT(window.kind() != WindowKind::polygon);
  const Rectangle& box = window.bounding_box();
  const Window torus = Window::torus(box);
  CounterStream stream(seed, index);
  const double dx = stream.next_between(0.0, box.width());
  const double dy = stream.next_between(0.0, box.height());
  std::vector<Point2> shifted;
  shifted.reserve(points.size());
  for (const Point2& p : points) {
    PHYTOBENCH_EXPECT(box.contains(p));
    shifted.push_back(torus.wrapped({p.x + dx, p.y + dy}));
  }
  return shifted;
}

}  // namespace phytobench
