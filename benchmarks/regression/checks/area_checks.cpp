// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/area_checks.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_overlap.hpp"
#include "reference/oracles/disc_shares.hpp"

namespace phytobench {

namespace {

/// Of sums over thousands of arcs, relative to the whole.
constexpr double rounding_of_sums = 1e-11;

double disc_area_of(double radius) {
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
  return disc_area_of(workload.radius[i]) - (union_area(discs) - without);
}

std::string objection_to_sum(const char* what, double found, double expected) {
  if (std::abs(found - expected) <= rounding_of_sums * expected) return {};
  return fmt::format("{} {:.17g} instead of {:.17g}", what, found, expected);
}

}  // namespace

std::string objection_to_lens_areas(std::span<const double> r, std::span<const double> s,
                                    std::span<const double> distance,
                                    std::span<const double> area) {
  PHYTOBENCH_EXPECT(r.size() == s.size() && r.size() == distance.size());
  if (area.size() != r.size()) return fmt::format("{} areas of {} pairs", area.size(), r.size());
  constexpr double digits_of_textbook = 1e-12;
  for (std::size_t p = 0; p < area.size(); ++p) {
    const double expected = oracles::alsweis::equation_a4_corrected(r[p], s[p], distance[p]);
    if (!(std::abs(area[p] - expected) <= digits_of_textbook * expected))
      return fmt::format("pair {}: area {:.17g}, the textbook has {:.17g}", p, area[p], expected);
  }
  return {};
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
  for (const double radius : workload.radius) all_discs += disc_area_of(radius);
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
          rounding_of_strips * disc_area_of(workload.radius[i])))
      wrong = fmt::format("disc {}: {:.17g} is covered, by strips {:.17g}", i, found.covered[i],
                          expected);
  }
  return wrong;
}

}  // namespace phytobench
