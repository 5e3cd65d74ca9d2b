// SPDX-License-Identifier: MIT
// Exact shares of the suite against the plane cut into strips.
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/overlap/ground_shares.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/disc_shares.hpp"

namespace phytobench::oracles {
namespace {

constexpr double exponents[] = {0.0, 0.7, 1.0, 2.0, 25.0, std::numeric_limits<double>::infinity()};

struct Scene {
  std::vector<double> x, y, radius;
  Ground ground;

  void add(double px, double py, double r) {
    x.push_back(px);
    y.push_back(py);
    radius.push_back(r);
  }
};

void expect_as_by_strips(const Scene& scene) {
  std::vector<OracleDisc> discs;
  for (std::size_t i = 0; i < scene.x.size(); ++i)
    discs.push_back({scene.x[i], scene.y[i], scene.radius[i]});
  const OracleGround ground{scene.ground.period_x(), scene.ground.period_y()};
  for (const double exponent : exponents) {
    SCOPED_TRACE(exponent);
    const auto won =
        ground_shares({scene.x, scene.y, scene.radius}, scene.ground, {.exponent = exponent});
    const auto expected = disc_shares_by_strips(discs, ground, exponent);
    ASSERT_EQ(won.size(), expected.size());
    for (std::size_t i = 0; i < won.size(); ++i)
      EXPECT_NEAR(won[i], expected[i], 1e-11) << "disc " << i;
  }
}

Scene random_scene(std::uint64_t seed, std::size_t count, double largest) {
  Scene scene;
  CounterStream stream(seed, 0);
  for (std::size_t i = 0; i < count; ++i) {
    const double x = 10 * stream.next_unit(), y = 8 * stream.next_unit();
    // Every third has one of four radii: equal discs meet.
    const double size = 0.05 + stream.next_unit();
    scene.add(x, y, largest * (i % 3 == 0 ? 0.25 * std::ceil(3.8 * size) : size));
  }
  return scene;
}

TEST(GroundSharesOracle, AreThoseOfStrips) {
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    SCOPED_TRACE(seed);
    expect_as_by_strips(random_scene(seed, 1 + seed % 17, seed % 3 == 0 ? 0.8 : 2.5));
  }
}

TEST(GroundSharesOracle, AreThoseOfStripsOnATorus) {
  for (std::uint64_t seed = 100; seed < 124; ++seed) {
    SCOPED_TRACE(seed);
    Scene scene = random_scene(seed, 1 + seed % 9, seed % 2 == 0 ? 0.9 : 3.3);
    scene.ground.torus = Rectangle{{0, 0}, {10, 8}};
    expect_as_by_strips(scene);
  }
}

TEST(GroundSharesOracle, AreThoseOfStripsWhereCirclesTouchOrMeetInOnePoint) {
  Scene lattice;
  for (int i = 0; i < 5; ++i)
    for (int j = 0; j < 4; ++j) lattice.add(0.5 * i, 0.5 * j, i == j ? 0.75 : 0.5);
  expect_as_by_strips(lattice);
  Scene ring;
  for (int i = 0; i < 6; ++i)
    ring.add(std::cos(i * std::numbers::pi / 3), std::sin(i * std::numbers::pi / 3), 1.0);
  ring.add(0, 0, 1.0);
  ring.add(0, 0, 2.0);
  ring.add(0, 0, 2.0);
  expect_as_by_strips(ring);
  Scene nested;
  for (const double r : {3.0, 2.0, 1.0, 1.0, 0.5}) nested.add(r, 0, r);
  expect_as_by_strips(nested);
}

}  // namespace
}  // namespace phytobench::oracles
