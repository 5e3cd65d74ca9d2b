// SPDX-License-Identifier: MIT
#include "core/point_pattern/hopkins_null.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include "core/parallel/for_blocks.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench {

namespace {

void scale_spread(std::vector<double>& values, double share) {
  const double mean =
      std::accumulate(values.begin(), values.end(), 0.0) / static_cast<double>(values.size());
  for (double& value : values)
    value = 1.0 + (mean - 1.0) * share + (value - mean) * std::sqrt(share);
}

}  // namespace

HopkinsNull hopkins_null(const Window& window, std::size_t points,
                         const HopkinsNullOptions& options) {
  HopkinsNull null;
  null.points_per_pattern = std::min(points, options.most_points);
  null.mean_ratio.resize(options.simulations);
  null.squared_ratio.resize(options.simulations);
  for_tasks(options.simulations, options.threads, [&](std::size_t k) {
    const auto pattern = random_pattern(window, null.points_per_pattern, options.seed, k);
    const HopkinsIndex index = hopkins_exact(pattern, window);
    null.mean_ratio[k] = index.mean_ratio;
    null.squared_ratio[k] = index.squared_ratio;
  });
  if (null.points_per_pattern < points && options.simulations > 0) {
    const double share = static_cast<double>(null.points_per_pattern) / static_cast<double>(points);
    scale_spread(null.mean_ratio, share);
    scale_spread(null.squared_ratio, share);
  }
  return null;
}

std::array<double, 2> central_95(const std::vector<double>& values) {
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

}  // namespace phytobench
