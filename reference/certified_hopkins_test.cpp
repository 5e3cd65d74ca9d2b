// SPDX-License-Identifier: MIT
// The values of reference/certified/hopkins.toml derived again, and the library held to them.
#include <cmath>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <boost/math/constants/constants.hpp>
#include <boost/math/quadrature/tanh_sinh.hpp>

#include "core/point_pattern/hopkins.hpp"
#include "core/point_pattern/lattices.hpp"
#include "core/point_pattern/nearest_neighbour_index.hpp"
#include "core/statistics/log_relative_error.hpp"
#include "reference/certified_values.hpp"

namespace phytobench::certified {
namespace {

const Exact& pi() {
  static const Exact value = boost::math::constants::pi<Exact>();
  return value;
}

/// By the double-exponential rule, to more digits than any file has.
template <class Function>
Exact integral(const Function& function, const Exact& from, const Exact& to) {
  static boost::math::quadrature::tanh_sinh<Exact> rule;  // keeps its nodes
  return rule.integrate(function, from, to, Exact("1e-36"));
}

/// Integral of the distance to the power m over a right triangle with a corner at 0, a leg there
/// and the angle between that leg and the longest side: in polar coordinates, the angle left.
Exact triangle(const Exact& leg, const Exact& angle, int m) {
  const auto along = [&](const Exact& theta) -> Exact {
    return pow(Exact(leg / cos(theta)), m + 2) / (m + 2);
  };
  return integral(along, 0, angle);
}

/// Mean of the distance to the power m from the center of a rectangle of these half sides.
Exact rectangle_mean(const Exact& p, const Exact& q, int m) {
  const Exact sum = triangle(p, atan(Exact(q / p)), m) + triangle(q, atan(Exact(p / q)), m);
  return sum / (p * q);
}

/// The same in the hexagon around each point of the triangular lattice of step 1.
Exact hexagon_mean(int m) {
  return 12 * triangle(Exact(1) / 2, pi() / 6, m) / (sqrt(Exact(3)) / 2);
}

/// The shorter side of a lattice's cell is the step of the lattice.
Exact lattice_ratio(const Value& value, int m) {
  const Exact a = value.exact("width") / value.exact("columns");
  const Exact b = value.exact("height") / value.exact("rows");
  const Exact step = a < b ? a : b;
  return rectangle_mean(a / 2, b / 2, m) / pow(step, m);
}

/// Integral of (1 - pi r^2)^n up to r = 1 / 2, term by term.
Exact before_discs_meet(int n) {
  Exact sum = 0, term = Exact(1) / 2;  // of binomial(n, k) (-pi)^k r^(2 k + 1)
  for (int k = 0; k <= n; ++k) {
    sum += term / (2 * k + 1);
    term *= -pi() * (n - k) / (4 * (k + 1));
  }
  return sum;
}

/// Mean distance from a random place of the unit torus to the nearest of n random points.
Exact torus_distance(int n) {
  const Exact half = Exact(1) / 2;
  const auto beyond = [&](const Exact& r) -> Exact {
    if (r <= half) return pow(Exact(1 - pi() / 4), n);
    const Exact over = r * r * acos(Exact(half / r)) - half * sqrt(Exact(r * r - half * half));
    return pow(Exact(1 - pi() * r * r + 4 * over), n);
  };
  return before_discs_meet(n) + integral(beyond, half, sqrt(half));
}

Exact derived(const Value& value) {
  const std::string quantity = value.quantity();
  if (quantity == "lattice_mean_ratio") return lattice_ratio(value, 1);
  if (quantity == "lattice_squared_ratio") return lattice_ratio(value, 2);
  if (quantity == "triangular_mean_ratio") return hexagon_mean(1);
  if (quantity == "triangular_squared_ratio") return hexagon_mean(2);
  const int points = static_cast<int>(value.count("points"));
  if (quantity == "torus_distance") return torus_distance(points);
  if (quantity == "torus_ratio") return torus_distance(points) / torus_distance(points - 1);
  ADD_FAILURE() << "nothing derives " << quantity;
  return 0;
}

HopkinsIndex of_lattice(const Value& value) {
  const Rectangle box{{0.0, 0.0}, {value.number("width"), value.number("height")}};
  return hopkins_exact(square_lattice(box, value.count("columns"), value.count("rows")),
                       Window::torus(box));
}

HopkinsIndex of_triangles(const Value& value) {
  const double height = value.number("rows") * std::sqrt(3.0) / 2.0;
  const Rectangle box{{0.0, 0.0}, {value.number("columns"), height}};
  return hopkins_exact(triangular_lattice(box, value.count("columns"), value.count("rows")),
                       Window::torus(box));
}

double computed(const Value& value) {
  const std::string quantity = value.quantity();
  if (quantity == "lattice_mean_ratio") return of_lattice(value).mean_ratio;
  if (quantity == "lattice_squared_ratio") return of_lattice(value).squared_ratio;
  if (quantity == "triangular_mean_ratio") return of_triangles(value).mean_ratio;
  if (quantity == "triangular_squared_ratio") return of_triangles(value).squared_ratio;
  const Window torus = Window::torus({{0.0, 0.0}, {1.0, 1.0}});
  const std::size_t points = value.count("points");
  const double distance = expected_nearest_distance(torus, points);
  return quantity == "torus_distance" ? distance
                                      : distance / expected_nearest_distance(torus, points - 1);
}

TEST(CertifiedHopkinsOracle, HasTheDigitsOfAnotherDerivation) {
  const std::vector<Value> values = values_of("hopkins");
  ASSERT_GE(values.size(), 13u);
  for (const Value& value : values) {
    const Exact exact = derived(value);
    EXPECT_TRUE(is_rounded_to(value.digits(), exact)) << value.name() << ": " << exact.str(35);
  }
}

TEST(CertifiedHopkinsOracle, IsKeptByTheLibrary) {
  for (const Value& value : values_of("hopkins"))
    EXPECT_GE(log_relative_error(computed(value), value.certified()), value.promised_digits())
        << value.name();
}

}  // namespace
}  // namespace phytobench::certified
