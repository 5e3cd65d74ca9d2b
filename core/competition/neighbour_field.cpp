// SPDX-License-Identifier: MIT
#include "core/competition/neighbour_field.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <boost/math/quadrature/gauss.hpp>

namespace phytobench {

namespace {

/// (1 - exp(-x)) / x.
double mean_of_decay(double x) {
  return x == 0.0 ? 1.0 : -std::expm1(-x) / x;
}

/// (1 - (1 + x) exp(-x)) / x^2, the integral of t exp(-x t) over 0 to 1.
double first_moment_of_decay(double x) {
  if (x > 1.0) return (1.0 - (1.0 + x) * std::exp(-x)) / (x * x);
  double sum = 0.0, term = 1.0;  // (-x)^k / k!
  for (int k = 0; k < 20; ++k) {
    sum += term / (k + 2);
    term *= -x / (k + 1);
  }
  return sum;
}

}  // namespace

/// The boundary of a disc that the stem looks at, by the angle at the disc's center from where it
/// is nearest to the stem, 0, to where it is farthest, pi.
class NeighbourField::Boundary {
 public:
  Boundary(double radius, double distance)
      : radius_(radius), distance_(distance), offset_(radius - distance) {}

  double nearest() const { return std::abs(offset_); }
  double farthest() const { return radius_ + distance_; }

  /// Where the boundary is r from the stem, nearest() <= r <= farthest(): half-angle form, right at
  /// both ends.
  double angle_at(double r) const {
    const double inner = (r - nearest()) * (r + nearest());
    const double outer = (farthest() - r) * (farthest() + r);
    return 2.0 * std::atan2(std::sqrt(std::max(inner, 0.0)), std::sqrt(std::max(outer, 0.0)));
  }
  double squared_distance(double angle) const {
    return offset_ * offset_ + 4.0 * radius_ * distance_ * half_sine_squared(angle);
  }
  /// r^2 dtheta / dangle, with theta the direction seen from the stem.
  double along(double angle) const {
    return radius_ * (offset_ + 2.0 * distance_ * half_sine_squared(angle));
  }
  /// Direction seen from the stem, 0 to pi, growing with the angle where the stem lies inside.
  double direction_at(double angle) const {
    // radius cos(angle) - distance without its cancellation near the stem.
    const double x = offset_ - 2.0 * radius_ * half_sine_squared(angle);
    return std::atan2(radius_ * std::sin(angle), x);
  }

 private:
  static double half_sine_squared(double angle) {
    const double sine = std::sin(0.5 * angle);
    return sine * sine;
  }

  double radius_, distance_, offset_;
};

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
  // Beyond the stem s exp(-c (s - stem)) ds, with s = stem + u: one part for each summand.
  const double width = r - stem_, x = slope_ * width;
  const double ring = stem_ * width * mean_of_decay(x) + width * width * first_moment_of_decay(x);
  return std::numbers::pi * (stem_ * stem_ + 2.0 * ring);
}

double NeighbourField::over_disc(double radius, double distance) const {
  if (distance >= radius + zone_) return 0.0;
  if (distance == 0.0) return over_own_disc(radius);
  if (radius >= distance + zone_) return over_own_disc(zone_);
  // Green's theorem: with M(r) the integral over the own disc of radius r, the field integrates to
  // the boundary integral of M(r) / (2 pi) dtheta seen from the stem. M changes its form at the
  // stem; rings of doubling radius keep it smooth up to the rim, beyond which it is constant.
  const Boundary boundary(radius, distance);
  const double rim = std::min(zone_, boundary.farthest());
  double sum = 0.0, near = boundary.nearest();
  for (double next = stem_; near < rim; next *= 2.0) {
    if (next <= near) continue;
    const double far = std::min(next, rim);
    sum += over_boundary(boundary, near, far);
    near = far;
  }
  if (boundary.farthest() > zone_) {
    const double turned = boundary.direction_at(boundary.angle_at(boundary.farthest())) -
                          boundary.direction_at(boundary.angle_at(near));
    sum += over_own_disc(zone_) * turned / std::numbers::pi;  // both halves of the circle
  }
  return std::max(sum, 0.0);
}

double NeighbourField::over_boundary(const Boundary& boundary, double near, double far) const {
  const auto integrand = [&](double angle) {
    const double along = boundary.along(angle), squared = boundary.squared_distance(angle);
    const double r = std::sqrt(squared);
    // Over the stem M is pi r^2: no quotient of two small numbers at the stem itself.
    if (r <= stem_) return 0.5 * along;
    return over_own_disc(r) / (2.0 * std::numbers::pi) * along / squared;
  };
  // Both halves of the circle are alike.
  return 2.0 * boost::math::quadrature::gauss<double, 15>::integrate(
                   integrand, boundary.angle_at(near), boundary.angle_at(far));
}

}  // namespace phytobench
