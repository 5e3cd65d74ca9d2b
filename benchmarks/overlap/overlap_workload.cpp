// SPDX-License-Identifier: MIT
#include "benchmarks/overlap/overlap_workload.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr std::string_view names[] = {"equal", "uniform", "mixed"};

double relative_radius(DiscSizes sizes, double unit) {
  switch (sizes) {
    case DiscSizes::equal:
      return 1.0;
    case DiscSizes::uniform:
      return 1.0 + 2.0 * unit;
    case DiscSizes::mixed:
      return std::pow(1000.0, unit);
  }
  return 1.0;
}

}  // namespace

std::string_view name_of(DiscSizes sizes) {
  return names[static_cast<std::size_t>(sizes)];
}

DiscSizes disc_sizes_named(std::string_view name) {
  for (const DiscSizes sizes : {DiscSizes::equal, DiscSizes::uniform, DiscSizes::mixed})
    if (name == name_of(sizes)) return sizes;
  throw InputError(fmt::format("unknown sizes '{}'; use equal, uniform or mixed", name));
}

OverlapWorkload random_discs(const RandomDiscs& request) {
  const auto n = static_cast<double>(request.count);
  const double side = std::sqrt(n);
  OverlapWorkload workload;
  workload.name = fmt::format("{} discs of {} size{}", request.count, name_of(request.sizes),
                              request.is_torus ? " on a torus" : "");
  workload.seed = request.seed;
  double sum = 0.0, squares = 0.0;
  for (std::size_t i = 0; i < request.count; ++i) {
    const auto unit = [&](std::uint64_t stream) { return random_unit(request.seed, stream, i); };
    workload.x.push_back(side * unit(0));
    workload.y.push_back(side * unit(1));
    workload.radius.push_back(relative_radius(request.sizes, unit(2)));
    sum += workload.radius.back();
    squares += workload.radius.back() * workload.radius.back();
  }
  // Expected partners: n pi E (r + s)^2 / area.
  const double mean_square = 2.0 * squares / n + 2.0 * (sum / n) * (sum / n);
  const double scale = std::sqrt(request.partners / (std::numbers::pi * mean_square));
  for (double& r : workload.radius) r = std::min(r * scale, 0.49 * side);
  if (request.is_torus) workload.ground.torus = Rectangle{{0, 0}, {side, side}};
  return workload;
}

OverlapWorkload smaller(const OverlapWorkload& workload, std::size_t count) {
  const Discs discs = workload.discs();
  const auto [x_low, x_high] = std::minmax_element(discs.x.begin(), discs.x.end());
  const auto [y_low, y_high] = std::minmax_element(discs.y.begin(), discs.y.end());
  const double share =
      std::sqrt(std::min(1.0, static_cast<double>(count) / static_cast<double>(discs.size())));
  const double width = share * (*x_high - *x_low), height = share * (*y_high - *y_low);
  OverlapWorkload part;
  part.name = workload.name;
  part.seed = workload.seed;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    if (discs.x[i] - *x_low > width || discs.y[i] - *y_low > height) continue;
    part.x.push_back(discs.x[i]);
    part.y.push_back(discs.y[i]);
    part.radius.push_back(discs.radius[i]);
  }
  return part;
}

}  // namespace phytobench
