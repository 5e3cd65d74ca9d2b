// SPDX-License-Identifier: MIT
#include "core/point_pattern/pair_correlation.hpp"

#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/kernel_sums.hpp"
#include "core/point_pattern/pair_types.hpp"
#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

std::vector<double> smoothed(const PairTypes& types, const Window& window,
                             std::span<const double> distances, const SmoothingOptions& options) {
  const PairWeights weights(types.points(), window, options.correction);
  PHYTOBENCH_EXPECT(std::isfinite(options.half_width) && options.half_width >= 0.0);
  const DistanceBins checked(distances);
  if (types.ordered_pairs() <= 0.0) return std::vector<double>(distances.size(), unknown_value);

  const double half_width = options.half_width > 0.0
                                ? options.half_width
                                : stoyan_half_width(types.points().size(), window);
  const KernelGrid kernel(distances, half_width);
  const ClosePairs pairs(types.points(), window, kernel.reach());
  const bool at_pair = options.circle_at == CircleAt::pair;
  std::vector<double> values = close_pair_sums<double>(
      pairs, distances.size(), options.threads,
      [&](double* sums, std::size_t i, std::size_t j, const Point2& d, double square) {
        const double distance = std::sqrt(square);
        if (at_pair && distance == 0.0) return;
        double weight = 0.0;
        types.for_orders(i, j, [&](std::size_t start) { weight += weights(start, d, distance); });
        if (weight == 0.0) return;
        if (at_pair) weight /= distance;
        kernel.spread(distance, [&](std::size_t k, double share) { sums[k] += share * weight; });
      });

  const double scale = window.area() / (2.0 * std::numbers::pi * types.ordered_pairs());
  for (std::size_t k = 0; k < values.size(); ++k) {
    values[k] *= scale;
    if (!at_pair) values[k] = distances[k] > 0.0 ? values[k] / distances[k] : unknown_value;
  }
  return values;
}

}  // namespace

double stoyan_half_width(std::size_t points, const Window& window) {
  return 0.15 * std::sqrt(window.area() / static_cast<double>(points));
}

std::vector<double> pair_correlation(std::span<const Point2> points, const Window& window,
                                     std::span<const double> distances,
                                     const SmoothingOptions& options) {
  return smoothed(PairTypes(points), window, distances, options);
}

std::vector<double> cross_pair_correlation(std::span<const Point2> first,
                                           std::span<const Point2> second, const Window& window,
                                           std::span<const double> distances,
                                           const SmoothingOptions& options) {
  return smoothed(PairTypes(first, second), window, distances, options);
}

}  // namespace phytobench
