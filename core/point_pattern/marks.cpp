// SPDX-License-Identifier: MIT
#include "core/point_pattern/marks.hpp"

#include <cmath>

#include "core/contract/check.hpp"
#include "core/point_pattern/close_pairs.hpp"
#include "core/point_pattern/kernel_sums.hpp"
#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

/// Kernel mean of product(m_i, m_j), the same for either order, over the pairs at each distance.
template <class Product>
std::vector<double> kernel_mean(std::span<const Point2> points, std::span<const double> marks,
                                const Window& window, std::span<const double> distances,
                                const SmoothingOptions& options, const Product& product) {
  PHYTOBENCH_EXPECT(marks.size() == points.size());
  for (const double mark : marks) PHYTOBENCH_EXPECT(std::isfinite(mark));
  PHYTOBENCH_EXPECT(std::isfinite(options.half_width) && options.half_width >= 0.0);
  const PairWeights weights(points, window, options.correction);
  const DistanceBins checked(distances);
  const std::size_t size = distances.size();
  if (points.size() < 2) return std::vector<double>(size, unknown_value);

  const KernelGrid kernel(distances, options.half_width > 0.0
                                         ? options.half_width
                                         : stoyan_half_width(points.size(), window));
  const ClosePairs pairs(points, window, kernel.reach());
  const bool at_pair = options.circle_at == CircleAt::pair;
  // Sums of the products first, then those of the weights alone.
  const std::vector<double> sums = close_pair_sums<double>(
      pairs, 2 * size, options.threads,
      [&](double* part, std::size_t i, std::size_t j, const Point2& d, double square) {
        const double distance = std::sqrt(square);
        if (at_pair && distance == 0.0) return;
        double weight = weights(i, d, distance) + weights(j, d, distance);
        if (at_pair) weight /= distance;
        const double value = product(marks[i], marks[j]);
        kernel.spread(distance, [&](std::size_t k, double share) {
          part[k] += share * weight * value;
          part[size + k] += share * weight;
        });
      });
  std::vector<double> means;
  for (std::size_t k = 0; k < size; ++k)
    means.push_back(sums[size + k] > 0.0 ? sums[k] / sums[size + k] : unknown_value);
  return means;
}

double mean_of(std::span<const double> marks) {
  double sum = 0.0;
  for (const double mark : marks) sum += mark;
  return sum / static_cast<double>(marks.size());
}

void divide(std::vector<double>& values, double divisor) {
  for (double& value : values) value = divisor > 0.0 ? value / divisor : unknown_value;
}

}  // namespace

std::vector<double> mark_correlation(std::span<const Point2> points, std::span<const double> marks,
                                     const Window& window, std::span<const double> distances,
                                     const SmoothingOptions& options) {
  auto values = kernel_mean(points, marks, window, distances, options,
                            [](double a, double b) { return a * b; });
  const double mean = mean_of(marks);
  divide(values, mean * mean);
  return values;
}

std::vector<double> mark_variogram(std::span<const Point2> points, std::span<const double> marks,
                                   const Window& window, std::span<const double> distances,
                                   const SmoothingOptions& options) {
  return kernel_mean(points, marks, window, distances, options,
                     [](double a, double b) { return 0.5 * (a - b) * (a - b); });
}

std::vector<double> mark_moran_index(std::span<const Point2> points, std::span<const double> marks,
                                     const Window& window, std::span<const double> distances,
                                     const SmoothingOptions& options) {
  std::vector<double> centred(marks.begin(), marks.end());
  // From the first mark, so that equal ones have no variance, rounding included.
  for (double& mark : centred) mark -= marks[0];
  const double mean = mean_of(centred);
  double squares = 0.0;
  for (double& mark : centred) {
    mark -= mean;
    squares += mark * mark;
  }
  auto values = kernel_mean(points, centred, window, distances, options,
                            [](double a, double b) { return a * b; });
  divide(values, squares / static_cast<double>(marks.size()));
  return values;
}

}  // namespace phytobench
