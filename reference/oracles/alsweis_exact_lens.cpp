// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_exact_lens.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include <boost/math/constants/constants.hpp>
#include <boost/multiprecision/cpp_bin_float.hpp>

namespace phytobench::oracles::alsweis {

namespace {

using Exact = boost::multiprecision::cpp_bin_float_100;

Exact segment(const Exact& own, const Exact& other, const Exact& distance) {
  const Exact cosine = (own * own + distance * distance - other * other) / (2 * own * distance);
  const Exact angle = 2 * acos(cosine);
  return own * own * (angle - sin(angle)) / 2;
}

Exact lens(const Exact& r, const Exact& s, const Exact& distance) {
  if (distance >= r + s) return 0;
  const Exact small = std::min(r, s);
  if (distance <= abs(r - s)) return boost::math::constants::pi<Exact>() * small * small;
  return segment(r, s, distance) + segment(s, r, distance);
}

}  // namespace

double lens_relative_error(double r, double s, double distance, double area) {
  const Exact exact = lens(r, s, distance);
  if (exact == 0) return area == 0.0 ? 0.0 : std::numeric_limits<double>::infinity();
  return static_cast<double>(Exact(abs(Exact(area) - exact) / exact));
}

double hard_distance(double r, double s, int kind, double unit) {
  const double gap = std::pow(10.0, -17.0 * unit);
  const double sign = unit < 0.5 ? 1.0 : -1.0;
  switch (kind % 6) {
    case 0:
      return (r + s) * (1.0 - gap);
    case 1:
      return std::abs(r - s) + std::min(r, s) * gap;
    case 2:
      return std::max(r, s) * (1.0 + sign * gap);
    case 3:
      return std::min(r, s) * (1.0 + sign * gap);
    case 4:
      return std::sqrt(std::abs(r - s) * (r + s)) * (1.0 + unit);
    default:
      return std::abs(r - s) + unit * (r + s - std::abs(r - s));
  }
}

}  // namespace phytobench::oracles::alsweis
