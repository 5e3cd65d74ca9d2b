// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/area_checks.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_exact_lens.hpp"
#include "reference/oracles/alsweis_overlap.hpp"
#include "reference/oracles/disc_shares.hpp"

namespace phytobench {

namespace {

/// Of sums over thousands of arcs, relative to the whole.
constexpr double rounding_of_sums = 1e-11;

double area_of_radius(double radius) {
  return std::numbers::pi * radius * radius;
}

/// On a torus the difference to the nearest image.
double shortest(double difference, double period) {
  return difference - period * std::round(difference / period);
}

/// Those that a disc overlaps, seen from its center.
std::vector<oracles::OracleDisc> neighbours_of(std::size_t i, const OverlapWorkload& workload) {
  std::vector<oracles::OracleDisc> neighbours;
  for (std::size_t j = 0; j < workload.x.size(); ++j) {
    const double x = shortest(workload.x[j] - workload.x[i], workload.ground.period_x());
    const double y = shortest(workload.y[j] - workload.y[i], workload.ground.period_y());
    if (j != i && std::hypot(x, y) < workload.radius[i] + workload.radius[j])
      neighbours.push_back({x, y, workload.radius[j]});
  }
  return neighbours;
}

/// Equal shares of all together are the ground that they cover.
double union_area(const std::vector<oracles::OracleDisc>& discs) {
  const std::vector<double> shares = oracles::disc_shares_by_strips(discs, {}, 0.0);
  return std::accumulate(shares.begin(), shares.end(), 0.0);
}

/// What the others cover of disc i: all but what the union loses without it.
double covered_by_strips(std::size_t i, const OverlapWorkload& workload) {
  std::vector<oracles::OracleDisc> discs = neighbours_of(i, workload);
  const double without = union_area(discs);
  discs.push_back({0.0, 0.0, workload.radius[i]});
  return area_of_radius(workload.radius[i]) - (union_area(discs) - without);
}

std::string objection_to_sum(const char* what, double found, double expected) {
  if (std::abs(found - expected) <= rounding_of_sums * expected) return {};
  return fmt::format("{} {:.17g} instead of {:.17g}", what, found, expected);
}

/// What rounding may change in the textbook's area. It takes the angles from cosines, each off by
/// some eps (r^2 + s^2 + d^2) / (r d); a segment changes by that times its radius and half the
/// common chord, which is at most the smaller radius; and angles and sines are rounded themselves.
double rounding_of_textbook(double r, double s, double distance) {
  constexpr double eps = std::numeric_limits<double>::epsilon();
  const double of_cosines = 8.0 * (r * r + s * s + distance * distance) / distance;
  const double of_angles = 4.0 * std::numbers::pi * (r + s);
  return eps * std::min(r, s) * (of_cosines + of_angles);
}

/// False where it is not, and where the textbook's form has lost too many digits to say so.
bool is_as_textbook_has_it(double r, double s, double distance, double area) {
  constexpr double fewest_digits = 1e-9;
  const double expected = oracles::alsweis::equation_a4_corrected(r, s, distance);
  const double rounding = rounding_of_textbook(r, s, distance);
  return rounding <= fewest_digits * expected && std::abs(area - expected) <= rounding;
}

/// lens_area() promises so much of every area.
constexpr double digits_promised = 1e-14;

}  // namespace

std::string objection_to_lens_areas(std::span<const double> r, std::span<const double> s,
                                    std::span<const double> distance, std::span<const double> area,
                                    std::uint64_t seed) {
  PHYTOBENCH_EXPECT(r.size() == s.size() && r.size() == distance.size());
  if (area.size() != r.size()) return fmt::format("{} areas of {} pairs", area.size(), r.size());
  const auto objection = [&](std::size_t p) -> std::string {
    const double error = oracles::alsweis::lens_relative_error(r[p], s[p], distance[p], area[p]);
    if (error <= digits_promised) return {};
    return fmt::format("pair {}: area {:.17g}, off by {:.2g} of what a hundred digits give", p,
                       area[p], error);
  };
  for (std::size_t p = 0; p < area.size(); ++p) {
    if (is_as_textbook_has_it(r[p], s[p], distance[p], area[p])) continue;
    if (std::string wrong = objection(p); !wrong.empty()) return wrong;
  }
  constexpr std::size_t sample = 200;
  CounterStream stream(seed, 2);
  for (std::size_t k = 0; k < sample && !area.empty(); ++k) {
    const double place = stream.next_unit() * static_cast<double>(area.size());
    if (std::string wrong = objection(static_cast<std::size_t>(place)); !wrong.empty())
      return wrong;
  }
  return {};
}

std::string objection_to_pair_areas(const OverlapPairs& pairs, std::span<const double> distance,
                                    const OverlapWorkload& workload, std::uint64_t seed) {
  PHYTOBENCH_EXPECT(pairs.size() == distance.size());
  std::vector<double> r, s, by_area;
  const auto first = pairs.first(), second = pairs.second();
  for (std::size_t from = 0, to = 0; from < pairs.size(); from = to) {
    while (to < pairs.size() && first[to] == first[from] && second[to] == second[from]) ++to;
    for (std::size_t p = from; p < to; ++p) {
      r.push_back(workload.radius[static_cast<std::size_t>(first[p])]);
      s.push_back(workload.radius[static_cast<std::size_t>(second[p])]);
      by_area.push_back(distance[from + to - 1 - p]);  // the nearest image overlaps most
    }
  }
  return objection_to_lens_areas(r, s, by_area, pairs.area(), seed);
}

std::string objection_to_coverage(const Coverage& found, const OverlapWorkload& workload,
                                  std::uint64_t seed) {
  PHYTOBENCH_EXPECT(workload.ground.torus.has_value());
  const std::size_t discs = workload.x.size();
  if (found.covered.size() != discs)
    return fmt::format("{} covered parts of {} discs", found.covered.size(), discs);
  double ground = 0.0, weighted = 0.0, all_discs = 0.0;
  for (std::size_t k = 0; k < found.by_times.size(); ++k) {
    ground += found.by_times[k];
    weighted += static_cast<double>(k) * found.by_times[k];
  }
  for (const double radius : workload.radius) all_discs += area_of_radius(radius);
  std::string wrong =
      objection_to_sum("the ground adds up to", ground, workload.ground.torus->area());
  if (wrong.empty()) wrong = objection_to_sum("times add up to discs of", weighted, all_discs);
  constexpr std::size_t sample = 40;
  CounterStream stream(seed, 1);
  for (std::size_t k = 0; k < sample && discs > 0 && wrong.empty(); ++k) {
    const auto i = static_cast<std::size_t>(stream.next_unit() * static_cast<double>(discs));
    const double expected = covered_by_strips(i, workload);
    constexpr double rounding_of_strips = 1e-10;  // of the disc's area
    if (!(std::abs(found.covered[i] - expected) <=
          rounding_of_strips * area_of_radius(workload.radius[i])))
      wrong = fmt::format("disc {}: {:.17g} is covered, by strips {:.17g}", i, found.covered[i],
                          expected);
  }
  return wrong;
}

}  // namespace phytobench
