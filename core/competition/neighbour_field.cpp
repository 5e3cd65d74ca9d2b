// SPDX-License-Identifier: MIT
#include "core/competition/neighbour_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

namespace phytobench {

NeighbourField::NeighbourField(double stem_radius, double zone_radius, double at_rim)
    : stem_(std::min(stem_radius, zone_radius)),
      zone_(zone_radius),
      slope_(zone_ > stem_ ? -std::log(at_rim) / (zone_ - stem_) : 0.0) {}

double NeighbourField::at(double distance) const {
  if (distance > zone_) return 0.0;
  return distance <= stem_ ? 1.0 : std::exp(-slope_ * (distance - stem_));
}

double NeighbourField::over_own_disc(double radius) const {
  const double r = std::min(radius, zone_);
  if (r <= stem_) return std::numbers::pi * r * r;
  // Antiderivative of s exp(-c (s - stem)) between the stem and r.
  const double u = 1.0 / slope_;
  const double ring = u * (stem_ + u) - std::exp(-slope_ * (r - stem_)) * u * (r + u);
  return std::numbers::pi * (stem_ * stem_ + 2.0 * ring);
}

double NeighbourField::over_disc(double radius, double distance) const {
  if (distance >= radius + zone_) return 0.0;
  if (distance == 0.0) return over_own_disc(radius);
  if (radius >= distance + zone_) return over_own_disc(zone_);
  // Green's theorem: with M(r) the integral over the own disc of radius r, the field in plane polar
  // coordinates integrates to the boundary integral of M(r) / (2 pi) dtheta seen from the stem. M
  // changes its form at the stem and at the rim; rings of doubling radius keep it smooth between.
  const double nearest = std::abs(radius - distance), farthest = radius + distance;
  double sum = 0.0, near = nearest;
  for (double next = stem_; near < farthest; next *= 2.0) {
    if (next <= near && next < zone_) continue;
    const double far = std::min(farthest, next < zone_ ? next : near < zone_ ? zone_ : farthest);
    sum += over_boundary(radius, distance, near, far);
    near = far;
  }
  return std::max(sum, 0.0);
}

double NeighbourField::over_boundary(double radius, double distance, double near,
                                     double far) const {
  // Angle at the disc's center, from the far point, at which the boundary is `r` from the stem.
  const auto angle = [&](double r) {
    const double cosine =
        (r * r - radius * radius - distance * distance) / (2.0 * radius * distance);
    return std::acos(std::clamp(cosine, -1.0, 1.0));
  };
  // Both ends of the circle are known; the cosine there is a quotient of rounding errors.
  const double from = far == radius + distance ? 0.0 : angle(far);
  const double to = near == std::abs(radius - distance) ? std::numbers::pi : angle(near);
  const auto integrand = [&](double phi) {
    const double along = radius * radius + radius * distance * std::cos(phi);
    const double squared =
        radius * radius + distance * distance + 2.0 * radius * distance * std::cos(phi);
    const double r = std::sqrt(std::max(squared, 0.0));
    // Over the stem M is pi r^2: no quotient of two small numbers at the stem itself.
    if (r <= stem_) return 0.5 * along;
    return over_own_disc(r) / (2.0 * std::numbers::pi) * along / squared;
  };
  // Both halves of the circle are alike.
  return 2.0 * boost::math::quadrature::gauss<double, 15>::integrate(integrand, from, to);
}

}  // namespace phytobench
