// SPDX-License-Identifier: MIT
// Points drawn from the centre outwards: their distances, numbers and directions beside the laws of
// a Poisson process of the same density.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <numbers>
#include <numeric>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/point_pattern/random_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"
#include "experiments/alsweis/beside_laws.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_poisson.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis;

constexpr double pi = std::numbers::pi;

/// Each question draws patterns of its own, so that one unlucky draw does not answer several.
enum Stream : std::uint64_t {
  arrivals,
  numbers,
  dense_numbers,
  squares,
  gaps,
  turns,
  agreement = 100,  // and those after it, one per pattern
};

int patterns_of(Tier tier) {
  return tier == Tier::full ? 400'000 : tier == Tier::quick ? 60'000 : 20'000;
}

/// What (2.6) is asked for: `intensity` plants per unit area within a circle.
struct Circle {
  double intensity = 1.0;
  double radius = 5.0;

  double mean_count() const { return intensity * pi * radius * radius; }
};

/// Calls use(points) for `count` patterns, one after the other from one stream.
template <typename Use>
void for_patterns(ExperimentContext& context, Stream number, const Circle& circle, int count,
                  const Use& use) {
  CounterStream stream(context.seed(), number);
  for (int i = 0; i < count; ++i) {
    if (i % 1000 == 0) context.progress(fmt::format("pattern {} of {}", i, count));
    use(poisson_points_outwards(circle.intensity, circle.radius, stream));
  }
}

/// The first points of the equations as printed, from the numbers that the generator draws, too.
std::vector<oracles::PlaneVector> literal_points(const Circle& circle, std::size_t count,
                                                 UnitStream& stream) {
  std::vector<double> v, turn;
  while (v.size() < count) {
    v.push_back(1.0 - stream.next_unit());  // the stream gives 0, but never 1
    turn.push_back(stream.next_unit());
  }
  const std::vector<double> q = oracles::equation_2_7(v);
  std::vector<oracles::PlaneVector> points;
  for (std::size_t i = 0; i < count; ++i)
    points.push_back(oracles::equation_2_6(q[i], circle.intensity, oracles::unit_vector(turn[i])));
  return points;
}

/// The suite's generator beside the literal equations.
void record_agreement(ExperimentContext& context) {
  constexpr std::uint64_t patterns = 20;
  double largest = 0.0;
  std::int64_t compared = 0, other_ends = 0;
  for (const Circle& circle : {Circle{0.01, 30}, Circle{1, 5}, Circle{30, 2}, Circle{1, 100}})
    for (std::uint64_t i = 0; i < patterns; ++i) {
      CounterStream stream(context.seed(), agreement + i), again(context.seed(), agreement + i);
      const auto ours = poisson_points_outwards(circle.intensity, circle.radius, stream);
      const auto literal = literal_points(circle, ours.size() + 1, again);
      for (std::size_t k = 0; k < ours.size(); ++k, ++compared) {
        const double off = std::hypot(ours[k].x - literal[k].x, ours[k].y - literal[k].y);
        largest = std::max(largest, off / circle.radius);
      }
      other_ends += std::hypot(literal.back().x, literal.back().y) <= circle.radius;
    }
  record_of_sample(context, "agreement/largest_difference", largest, compared, "radii");
  context.record("agreement/points", compared, "points");
  context.record("agreement/other_ends", other_ends, "patterns");
}

/// pi |P_i|^2, which is q_i at intensity 1, and |P_i| itself. Five times as many patterns as
/// elsewhere; they need only ten points, of which 50.3 on average leave no doubt.
void record_arrivals(ExperimentContext& context) {
  constexpr std::array<std::size_t, 4> order = {1, 2, 5, 10};
  std::array<std::vector<double>, order.size()> q;
  for_patterns(context, arrivals, {1, 4}, 5 * patterns_of(context.tier()), [&](const auto& points) {
    for (std::size_t j = 0; j < order.size(); ++j)
      q[j].push_back(pi * squared_norm(points.at(order[j] - 1)));
  });
  for (std::size_t j = 0; j < order.size(); ++j) {
    const std::string name = fmt::format("radius/arrival-{}", order[j]);
    const auto i = static_cast<double>(order[j]);
    record_moments(context, {name, q[j]}, gamma_law(i));
    record_arrival_fit(context, name, static_cast<std::int64_t>(order[j]), q[j]);
    for (double& value : q[j]) value = std::sqrt(value / pi);
    record_moments(context, {fmt::format("radius/distance-{}", order[j]), q[j], "length"},
                   distance_law(i));
  }
}

/// How many points lie within circles around the centre.
void record_counts(ExperimentContext& context) {
  Sample near{"count/radius-1", {}, "points"}, middle{"count/radius-2", {}, "points"},
      all{"count/radius-5", {}, "points"}, dense{"count/dense", {}, "points"};
  const auto within = [](const std::vector<Point2>& points, double radius) {
    return static_cast<double>(
        std::count_if(points.begin(), points.end(),
                      [radius](const Point2& p) { return squared_norm(p) <= radius * radius; }));
  };
  const int patterns = patterns_of(context.tier());
  for_patterns(context, numbers, {}, patterns, [&](const auto& points) {
    near.values.push_back(within(points, 1.0));
    middle.values.push_back(within(points, 2.0));
    all.values.push_back(static_cast<double>(points.size()));
  });
  record_numbers(context, near, Circle{1, 1}.mean_count());
  record_numbers(context, middle, Circle{1, 2}.mean_count());
  record_numbers(context, all, Circle{1, 5}.mean_count());
  constexpr Circle crowd{3, 2};
  for_patterns(context, dense_numbers, crowd, patterns, [&](const auto& points) {
    dense.values.push_back(static_cast<double>(points.size()));
  });
  record_numbers(context, dense, crowd.mean_count());
}

/// How many points lie in squares anywhere in the circle, and whether two that lie apart know of
/// each other.
void record_homogeneity(ExperimentContext& context) {
  constexpr Rectangle beside{{1, -1}, {3, 1}}, opposite{{-3, -1}, {-1, 1}},
      corner{{2.5, 2.5}, {3.5, 3.5}}, around{{-1, -1}, {1, 1}};
  Sample in_beside{"square/beside-centre", {}, "points"}, in_corner{"square/far-off", {}, "points"},
      in_around{"square/around-centre", {}, "points"};
  Correlation apart;
  const auto inside = [](const std::vector<Point2>& points, const Rectangle& square) {
    return static_cast<double>(std::count_if(
        points.begin(), points.end(), [&square](const Point2& p) { return square.contains(p); }));
  };
  for_patterns(context, squares, {}, patterns_of(context.tier()), [&](const auto& points) {
    in_beside.values.push_back(inside(points, beside));
    in_corner.values.push_back(inside(points, corner));
    in_around.values.push_back(inside(points, around));
    apart.add(in_beside.values.back(), inside(points, opposite));
  });
  record_numbers(context, in_beside, beside.area());
  record_numbers(context, in_corner, corner.area());
  record_numbers(context, in_around, around.area());
  apart.record(context, "square/opposite");
}

/// The distance from the centre to the nearest point, and the same from elsewhere, where a pattern
/// that was homogeneous around its centre only would show it. From there the circle's edge is 2.5
/// away: once in 300 million patterns the nearest point may lie beyond.
void record_nearest(ExperimentContext& context) {
  constexpr Point2 elsewhere{1.5, -2.0};
  Sample from_centre{"nearest/centre", {}, "length"},
      from_elsewhere{"nearest/elsewhere", {}, "length"};
  const auto nearest = [](const std::vector<Point2>& points, const Point2& place) {
    double least = std::numeric_limits<double>::max();
    for (const Point2& p : points) least = std::min(least, squared_norm(p - place));
    return std::sqrt(least);
  };
  for_patterns(context, gaps, {}, patterns_of(context.tier()), [&](const auto& points) {
    from_centre.values.push_back(nearest(points, {}));
    from_elsewhere.values.push_back(nearest(points, elsewhere));
  });
  for (Sample* sample : {&from_centre, &from_elsewhere}) {
    record_moments(context, *sample, distance_law(1));
    for (double& distance : sample->values) distance = pi * distance * distance;
    record_arrival_fit(context, sample->name, 1, sample->values);
  }
}

/// Directions of all points, of each as seen from the one before, and with their distances.
void record_directions(ExperimentContext& context) {
  constexpr std::size_t sectors = 36;
  std::vector<std::int64_t> in_sector(sectors, 0);
  Directions all, turned;
  Correlation angle_radius, cosine_radius, sine_radius;
  for_patterns(context, turns, {}, patterns_of(context.tier()), [&](const auto& points) {
    Point2 before{};
    for (const Point2& p : points) {
      const double radius = norm(p), share = std::atan2(p.y, p.x) / (2.0 * pi) + 0.5;
      const Point2 e = (1.0 / radius) * p;
      ++in_sector[std::min(static_cast<std::size_t>(share * sectors), sectors - 1)];
      all.add(e.x, e.y);
      if (before != Point2{}) turned.add(dot(before, e), cross(before, e));
      angle_radius.add(share, radius);
      cosine_radius.add(e.x, radius);
      sine_radius.add(e.y, radius);
      before = e;
    }
  });
  all.record(context, "angle/all");
  turned.record(context, "angle/from_one_to_next");
  record_of_sample(context, "angle/sectors/chi_square_p_value", uniformity_p_value(in_sector),
                   std::accumulate(in_sector.begin(), in_sector.end(), std::int64_t{0}));
  angle_radius.record(context, "angle/with_radius");
  cosine_radius.record(context, "angle/cosine_with_radius");
  sine_radius.record(context, "angle/sine_with_radius");
}

void run(ExperimentContext& context) {
  record_agreement(context);
  record_arrivals(context);
  record_counts(context);
  record_homogeneity(context);
  record_nearest(context);
  record_directions(context);
}

}  // namespace

extern const ExperimentDescriptor poisson_pattern;
constinit const ExperimentDescriptor poisson_pattern{
    .id = "alsweis/poisson-pattern",
    .question = "Do equations 2.6 and 2.7 give a Poisson pattern?",
    .source = "[Alsweis] sec. 2.4.1, eq. 2.6-2.7",
    .seconds = {1, 3, 17},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
