// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/sky_view.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// The mean over headings of part(vertex, tangent of the horizon, heading).
template <class Part>
std::vector<double> mean_of_headings(const HeightField& field, const SkyViewOptions& options,
                                     const Part& part) {
  PHYTOBENCH_EXPECT(options.azimuths >= 1 && options.threads >= 1);
  std::vector<double> sums(field.size(), 0.0);
  // A few at once, and added up one after the other: the same sums for any number of threads.
  std::vector<std::vector<double>> horizons(static_cast<std::size_t>(options.threads));
  for (int first = 0; first < options.azimuths; first += options.threads) {
    const int count = std::min(options.threads, options.azimuths - first);
    const auto heading = [&](int k) {
      const double azimuth = 2.0 * std::numbers::pi * (first + k + 0.5) / options.azimuths;
      return Heading{std::cos(azimuth), std::sin(azimuth)};
    };
    for_tasks(static_cast<std::size_t>(count), options.threads, [&](std::size_t k) {
      horizons[k] = horizon_tangents(field, heading(static_cast<int>(k)), options.horizon);
    });
    for (int k = 0; k < count; ++k)
      for (std::size_t i = 0; i < sums.size(); ++i)
        sums[i] += part(i, horizons[static_cast<std::size_t>(k)][i], heading(k));
  }
  for (double& sum : sums) sum /= options.azimuths;
  return sums;
}

/// No less than `least`; NaN stays.
double at_least(double least, double tangent) {
  return tangent < least ? least : tangent;
}

}  // namespace

std::vector<double> sky_view_factors(const HeightField& field, const SkyViewOptions& options) {
  return mean_of_headings(field, options, [](std::size_t, double horizon, const Heading&) {
    const double tangent = at_least(0.0, horizon);
    return 1.0 / (1.0 + tangent * tangent);  // the squared cosine
  });
}

std::vector<double> tilted_sky_view_factors(const HeightField& field,
                                            std::span<const SurfaceGradient> gradients,
                                            const SkyViewOptions& options) {
  PHYTOBENCH_EXPECT(gradients.size() == field.size());
  const auto part = [&](std::size_t i, double horizon, const Heading& heading) {
    const SurfaceGradient& gradient = gradients[i];
    const double rise = gradient.east * heading.east + gradient.south * heading.south;
    // S: slope; A: aspect; H: from the zenith down to the horizon; phi: azimuth of the heading.
    const double tangent = at_least(std::max(rise, 0.0), horizon);
    const double H = std::atan2(1.0, tangent), sine = std::sin(H);
    const double tan_S = std::hypot(gradient.east, gradient.south);
    const double cos_S = 1.0 / std::hypot(1.0, tan_S);
    // sin S cos(phi - A): the slope falls towards A.
    const double sin_S_cos = -rise * cos_S;
    return cos_S * sine * sine + sin_S_cos * (H - sine * std::cos(H));
  };
  return mean_of_headings(field, options, part);
}

}  // namespace phytobench
