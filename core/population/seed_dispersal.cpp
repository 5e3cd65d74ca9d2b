// SPDX-License-Identifier: MIT
#include "core/population/seed_dispersal.hpp"

#include <cmath>
#include <limits>
#include <numbers>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <boost/math/special_functions/gamma.hpp>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/random/distributions.hpp"

namespace phytobench {

namespace {

constexpr double pi = std::numbers::pi;

/// Distances of the planar exponential law are the sum of two exponential ones: r exp(-r) dr.
constexpr double two = 2.0;

}  // namespace

std::string_view name_of(DispersalLaw law) {
  switch (law) {
    case DispersalLaw::radial_exponential:
      return "radial-exponential";
    case DispersalLaw::planar_exponential:
      return "planar-exponential";
    case DispersalLaw::gaussian:
      return "gaussian";
  }
  return "";
}

DispersalLaw dispersal_law_named(const std::string& name) {
  std::vector<std::string> names;
  for (const DispersalLaw law : all_dispersal_laws) {
    if (name == name_of(law)) return law;
    names.emplace_back(name_of(law));
  }
  throw InputError(fmt::format("there is no dispersal law '{}'; use one of: {}{}", name,
                               fmt::join(names, ", "), did_you_mean(name, names)));
}

double SeedDispersal::distance_distribution(double distance) const {
  const double r = distance / scale;
  if (!(r > 0.0)) return 0.0;
  switch (law) {
    case DispersalLaw::radial_exponential:
      return -std::expm1(-r);
    case DispersalLaw::planar_exponential:
      return boost::math::gamma_p(two, r);
    case DispersalLaw::gaussian:
      return -std::expm1(-0.5 * r * r);
  }
  return 0.0;
}

double SeedDispersal::distance_density(double distance) const {
  const double r = distance / scale;
  if (r < 0.0) return 0.0;
  switch (law) {
    case DispersalLaw::radial_exponential:
      return std::exp(-r) / scale;
    case DispersalLaw::planar_exponential:
      return r * std::exp(-r) / scale;
    case DispersalLaw::gaussian:
      return r * std::exp(-0.5 * r * r) / scale;
  }
  return 0.0;
}

double SeedDispersal::plane_density(double distance) const {
  PHYTOBENCH_EXPECT(distance >= 0.0);
  const double r = distance / scale, unit = 1.0 / (2.0 * pi * scale * scale);
  switch (law) {
    case DispersalLaw::radial_exponential:
      return r > 0.0 ? unit * std::exp(-r) / r : std::numeric_limits<double>::infinity();
    case DispersalLaw::planar_exponential:
      return unit * std::exp(-r);
    case DispersalLaw::gaussian:
      return unit * std::exp(-0.5 * r * r);
  }
  return 0.0;
}

double SeedDispersal::distance_quantile(double share) const {
  PHYTOBENCH_EXPECT(share >= 0.0 && share < 1.0);
  switch (law) {
    case DispersalLaw::radial_exponential:
      return -scale * std::log1p(-share);
    case DispersalLaw::planar_exponential:
      return scale * boost::math::gamma_p_inv(two, share);
    case DispersalLaw::gaussian:
      return scale * std::sqrt(-2.0 * std::log1p(-share));
  }
  return 0.0;
}

double SeedDispersal::mean_distance() const {
  switch (law) {
    case DispersalLaw::radial_exponential:
      return scale;
    case DispersalLaw::planar_exponential:
      return 2.0 * scale;
    case DispersalLaw::gaussian:
      return scale * std::sqrt(0.5 * pi);
  }
  return 0.0;
}

Point2 SeedDispersal::draw(UnitStream& stream) const {
  if (law == DispersalLaw::gaussian) {
    const auto [x, y] = random_normal_pair(stream);
    return {scale * x, scale * y};
  }
  double distance = scale * random_exponential(stream);
  if (law == DispersalLaw::planar_exponential) distance += scale * random_exponential(stream);
  const double angle = 2.0 * pi * stream.next_unit();
  return {distance * std::cos(angle), distance * std::sin(angle)};
}

}  // namespace phytobench
