// SPDX-License-Identifier: MIT
#include "core/point_pattern/ripley.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/edge_distance.hpp"
#include "core/point_pattern/pair_types.hpp"
#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

template <class Number>
void accumulate(std::vector<Number>& sums) {
  for (std::size_t k = 1; k < sums.size(); ++k) sums[k] += sums[k - 1];
}

/// Ordered pairs up to each distance; whole numbers, so that their order cannot matter.
std::vector<double> counted(const PairTypes& types, const ClosePairs& pairs,
                            const DistanceBins& bins, int threads) {
  const std::int64_t both = types.is_cross() ? 1 : 2;
  auto counts = close_pair_sums<std::int64_t>(
      pairs, bins.size(), threads,
      [&](std::int64_t* sums, std::size_t i, std::size_t j, const Point2&, double square) {
        if (types.is_cross() && (i < types.starts()) == (j < types.starts())) return;
        sums[bins.bin_of(square)] += both;
      });
  accumulate(counts);
  return {counts.begin(), counts.end()};
}

std::vector<double> weighted(const PairTypes& types, const ClosePairs& pairs,
                             const DistanceBins& bins, const PairWeights& weights, int threads) {
  auto sums = close_pair_sums<double>(
      pairs, bins.size(), threads,
      [&](double* part, std::size_t i, std::size_t j, const Point2& d, double square) {
        double& sum = part[bins.bin_of(square)];
        const double distance = std::sqrt(square);
        types.for_orders(i, j, [&](std::size_t start) { sum += weights(start, d, distance); });
      });
  accumulate(sums);
  return sums;
}

/// The border correction's K over area: pairs from points at least r from the border, per such
/// point and partner.
std::vector<double> reduced(const PairTypes& types, const ClosePairs& pairs,
                            const DistanceBins& bins, std::span<const double> distances,
                            const Window& window, int threads) {
  // Each start counts up to the last distance that is not beyond the border.
  std::vector<std::size_t> ends;
  std::vector<std::int64_t> starts(bins.size() + 1, 0);
  for (const double edge : distances_to_edge(window, types.points())) {
    const auto end = std::upper_bound(distances.begin(), distances.end(), edge);
    ends.push_back(static_cast<std::size_t>(end - distances.begin()));
    if (ends.size() <= types.starts()) ++starts[0], --starts[ends.back()];
  }
  auto counts = close_pair_sums<std::int64_t>(
      pairs, bins.size() + 1, threads,
      [&](std::int64_t* sums, std::size_t i, std::size_t j, const Point2&, double square) {
        const std::size_t bin = bins.bin_of(square);
        types.for_orders(i, j, [&](std::size_t start) {
          if (bin < ends[start]) ++sums[bin], --sums[ends[start]];
        });
      });
  accumulate(starts);
  accumulate(counts);
  std::vector<double> values;
  for (std::size_t k = 0; k < bins.size(); ++k) {
    const double possible = static_cast<double>(starts[k]) * types.partners();
    values.push_back(possible > 0.0 ? static_cast<double>(counts[k]) / possible : unknown_value);
  }
  return values;
}

std::vector<double> k_of(const PairTypes& types, const Window& window,
                         std::span<const double> distances, EdgeCorrection correction,
                         int threads) {
  PHYTOBENCH_EXPECT(is_defined(correction, window.kind()));
  const DistanceBins bins(distances);
  const ClosePairs pairs(types.points(), window, distances.back());
  std::vector<double> values;
  if (correction == EdgeCorrection::border) {
    values = reduced(types, pairs, bins, distances, window, threads);
    for (double& value : values) value *= window.area();
    return values;
  }
  const PairWeights weights(types.points(), window, correction);
  values = weights.all_one() ? counted(types, pairs, bins, threads)
                             : weighted(types, pairs, bins, weights, threads);
  const bool has_pairs = types.ordered_pairs() > 0.0;
  for (double& value : values)
    value = has_pairs ? window.area() * value / types.ordered_pairs() : unknown_value;
  return values;
}

}  // namespace

std::vector<double> ripley_k(std::span<const Point2> points, const Window& window,
                             std::span<const double> distances, EdgeCorrection correction,
                             int threads) {
  return k_of(PairTypes(points), window, distances, correction, threads);
}

std::vector<double> cross_ripley_k(std::span<const Point2> first, std::span<const Point2> second,
                                   const Window& window, std::span<const double> distances,
                                   EdgeCorrection correction, int threads) {
  return k_of(PairTypes(first, second), window, distances, correction, threads);
}

std::vector<double> l_from_k(std::span<const double> k_values) {
  std::vector<double> values;
  for (const double k : k_values) values.push_back(std::sqrt(k / std::numbers::pi));
  return values;
}

std::vector<double> default_distances(std::size_t points, const Window& window, std::size_t steps) {
  PHYTOBENCH_EXPECT(steps > 0);
  const Rectangle& box = window.bounding_box();
  double last = 0.25 * std::min(box.width(), box.height());
  if (points > 0) {
    const auto count = static_cast<double>(points);
    const double partners = std::clamp(5e7 / count, 50.0, 1000.0);
    last = std::min(last, std::sqrt(partners * window.area() / (std::numbers::pi * count)));
  }
  std::vector<double> distances;
  for (std::size_t k = 1; k <= steps; ++k)
    distances.push_back(last * static_cast<double>(k) / static_cast<double>(steps));
  return distances;
}

}  // namespace phytobench
