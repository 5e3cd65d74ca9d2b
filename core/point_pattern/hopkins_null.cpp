// SPDX-License-Identifier: MIT
#include "core/point_pattern/hopkins_null.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

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

/// A window with a share of the area and as much edge to each point inside as may be: cut at the
/// longer side; a polygon shrinks.
Window smaller_window(const Window& window, double share) {
  const Rectangle& box = window.bounding_box();
  if (window.kind() == WindowKind::polygon) {
    std::vector<Point2> corners = window.corners();
    for (Point2& corner : corners) corner = box.low + std::sqrt(share) * (corner - box.low);
    return Window::polygon(std::move(corners));
  }
  const double area = share * window.area();
  const double short_side = std::min({box.width(), box.height(), std::sqrt(area)});
  const double long_side = area / short_side;
  const bool is_wide = box.width() >= box.height();
  const Point2 size = is_wide ? Point2{long_side, short_side} : Point2{short_side, long_side};
  const Rectangle part{box.low, box.low + size};
  return window.kind() == WindowKind::torus ? Window::torus(part) : Window::rectangle(part);
}

}  // namespace

HopkinsNull hopkins_null(const Window& window, std::size_t points,
                         const HopkinsNullOptions& options) {
  HopkinsNull null;
  null.points_per_pattern = std::min(points, options.most_points);
  const bool is_scaled = null.points_per_pattern < points;
  const double share = static_cast<double>(null.points_per_pattern) / static_cast<double>(points);
  const Window simulated = is_scaled ? smaller_window(window, share) : window;
  null.mean_ratio.resize(options.simulations);
  null.squared_ratio.resize(options.simulations);
  for_tasks(options.simulations, options.threads, [&](std::size_t k) {
    if (options.checkpoint) options.checkpoint();
    const auto draw = options.fills_box ? box_filling_pattern : random_pattern;
    const auto pattern = draw(simulated, null.points_per_pattern, options.seed, k);
    const HopkinsIndex index = hopkins_exact(pattern, simulated);
    null.mean_ratio[k] = index.mean_ratio;
    null.squared_ratio[k] = index.squared_ratio;
  });
  if (is_scaled && options.simulations > 0) {
    scale_spread(null.mean_ratio, share);
    scale_spread(null.squared_ratio, share);
  }
  return null;
}

std::array<double, 2> central_95(const std::vector<double>& values) {
  return {quantile(values, 0.025), quantile(values, 0.975)};
}

}  // namespace phytobench
