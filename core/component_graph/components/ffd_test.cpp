// SPDX-License-Identifier: MIT
#include <gtest/gtest.h>

#include "core/component_graph/build_plant.hpp"
#include "core/component_graph/component_graph_file.hpp"
#include "core/component_graph/shapes/component_fixture.hpp"
#include "core/component_graph/shapes/lattice_deformation.hpp"
#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using namespace component_fixture;

/// Within the box and around it.
std::vector<Vector3> some_places() {
  CounterStream random(1, 2);
  std::vector<Vector3> places;
  for (int i = 0; i < 200; ++i) {
    const double x = random.next_between(-3.0, 3.0), y = random.next_between(-3.0, 3.0);
    places.push_back({x, y, random.next_between(-3.0, 3.0)});
  }
  return places;
}

/// A lattice of n^3 points over the box from (-1, 0, -1) to (1, 2, 1), moved by a function of their
/// places.
template <class Move>
Lattice lattice_of(std::size_t n, const Move& move) {
  Lattice lattice{.low = {-1.0, 0.0, -1.0}, .high = {1.0, 2.0, 1.0}, .points = {n, n, n}};
  const double step = 2.0 / static_cast<double>(n - 1);
  for (std::size_t k = 0; k < n; ++k)
    for (std::size_t j = 0; j < n; ++j)
      for (std::size_t i = 0; i < n; ++i)
        lattice.moves.push_back(
            move(Vector3{-1.0 + step * static_cast<double>(i), step * static_cast<double>(j),
                         -1.0 + step * static_cast<double>(k)}));
  return lattice;
}

Vector3 some_affine_move(const Vector3& p) {
  return {0.3 * p.x - 0.2 * p.y + 0.1, 0.5 * p.z + 0.05 * p.x - 2.0, 0.4 * p.y - 0.7 * p.z};
}

Vector3 some_bending(const Vector3& p) {
  return {0.4 * p.y * p.y, 0.1 * p.x * p.z, 0.3 * std::sin(p.x + p.y)};
}

TEST(LatticeDeformationLaw, WithoutMovesEveryPlaceKeepsItsBits) {
  const auto nowhere = [](const Vector3&) { return Vector3{}; };
  const Frame frame = outward_frame({5.0, -1.0, 0.3}, 20.0, 70.0);
  const LatticeDeformation unmoved(frame, lattice_of(4, nowhere), Bends::all);
  for (const Vector3& place : some_places()) EXPECT_EQ(unmoved.moved(place), place);
}

TEST(LatticeDeformationLaw, AnAffineLatticeIsThatAffineMapEverywhere) {
  for (const std::size_t n : {2u, 3u, 5u, 10u}) {
    const LatticeDeformation map(Frame{}, lattice_of(n, some_affine_move), Bends::all);
    for (const Vector3& place : some_places())
      EXPECT_LT(norm(map.moved(place) - (place + some_affine_move(place))), 1e-11) << n;
  }
}

/// Bernstein polynomials of degree 2 are 1/2 in the middle, those of degree 3 are 3/8.
TEST(LatticeDeformation, OneMovedPointActsByItsPolynomials) {
  Lattice lattice = lattice_of(3, [](const Vector3&) { return Vector3{}; });
  lattice.moves[1 + 3 + 9] = {0.8, 0.0, 0.0};
  const LatticeDeformation middle(Frame{}, lattice, Bends::all);
  EXPECT_NEAR(middle.moved({0.0, 1.0, 0.0}).x, 0.8 / 8.0, 1e-15);
  // At a corner of the box no other control point acts.
  EXPECT_EQ(middle.moved({1.0, 2.0, 1.0}), (Vector3{1.0, 2.0, 1.0}));
  Lattice cubic = lattice_of(4, [](const Vector3&) { return Vector3{}; });
  cubic.moves[1] = {0.0, 1.0, 0.0};  // on the lower edge along x
  EXPECT_NEAR(LatticeDeformation(Frame{}, cubic, Bends::all).moved({0.0, 0.0, -1.0}).y, 0.375,
              1e-15);
}

TEST(LatticeDeformationLaw, GoesOnSmoothlyOutsideItsBox) {
  const LatticeDeformation bent(Frame{}, lattice_of(5, some_bending), Bends::all);
  constexpr double step = 1e-6;
  for (const Vector3& face : {Vector3{1.0, 0.7, 0.2}, {-1.0, 1.9, 0.9}, {1.0, 2.5, -0.3}}) {
    const Vector3 across{step, 0.0, 0.0};
    const Vector3 before = bent.moved(face) - bent.moved(face - across);
    const Vector3 behind = bent.moved(face + across) - bent.moved(face);
    EXPECT_LT(norm(behind - before) / step, 1e-4);
  }
  // Beyond a face it goes straight on.
  const Vector3 a = bent.moved({2.0, 1.0, 0.0}), b = bent.moved({3.0, 1.0, 0.0}),
                c = bent.moved({4.0, 1.0, 0.0});
  EXPECT_LT(norm((c - b) - (b - a)), 1e-12);
}

TEST(LatticeDeformationLaw, TurnsAndGrowsWithItsFrame) {
  const LatticeDeformation here(Frame{}, lattice_of(4, some_bending), Bends::all);
  Frame frame = outward_frame({5.0, -1.0, 0.3}, 20.0, 70.0);
  frame.scale = 2.5;
  const LatticeDeformation there(frame, lattice_of(4, some_bending), Bends::all);
  for (const Vector3& place : some_places())
    EXPECT_LT(norm(there.moved(frame.place(place)) - frame.place(here.moved(place))), 1e-11);
}

TEST(LatticeDeformation, BendsSomeSurfacesOnly) {
  const auto bent = [](Bends bends, Surface surface) {
    return LatticeDeformation(Frame{}, lattice_of(2, some_affine_move), bends).bends(surface);
  };
  for (const Surface surface : {Surface::bark, Surface::leaf, Surface::plain}) {
    const bool is_leaf = surface == Surface::leaf;
    EXPECT_TRUE(bent(Bends::all, surface));
    EXPECT_EQ(bent(Bends::all_but_leaves, surface), !is_leaf);
    EXPECT_EQ(bent(Bends::leaves, surface), is_leaf);
  }
}

TEST(Ffd, AddsADeformationWhereSomethingIsMoved) {
  Tried ffd("ffd");
  EXPECT_TRUE(ffd.changed_context().deformations.empty());
  std::vector<double> moves(24, 0.0);
  moves[3 * 2 + 1] = 0.5;  // the second control point along y, at the lowest x and z
  ffd.set_list("moves", moves).set_word("bends", "all_but_leaves");
  const BuildContext changed = ffd.changed_context();
  ASSERT_EQ(changed.deformations.size(), 1u);
  EXPECT_FALSE(changed.deformations[0]->bends(Surface::leaf));
  const Vector3 corner = changed.deformations[0]->moved({-0.5, 1.0, -0.5});
  EXPECT_LT(norm(corner - Vector3{-0.5, 1.5, -0.5}), 1e-15);
  EXPECT_EQ(ffd.child(), Frame{});
}

TEST(Ffd, SaysHowManyMovesItNeeds) {
  Tried ffd("ffd");
  ffd.set("points_y", 3.0).set_list("moves", {1.0, 2.0});
  try {
    ffd.changed_context();
    FAIL() << "two numbers for twelve control points";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "it.moves holds 2 numbers, but 2 x 3 x 2 control points need 36; give three for "
                 "each point, or none");
  }
}

/// How many it needs may follow from functions, so that only an instance can tell; the message
/// still says where the list stands.
TEST(Ffd, SaysWhereTheMovesStand) {
  const ComponentGraph graph = parse_component_graph(
      "[graph]\nroot = \"box\"\n\n[component.box]\nkind = \"ffd\"\npoints_x = \"value + 1\"\n"
      "moves = [1.0, 2.0]\n",
      "bent.toml");
  try {
    build_plant(graph);
    FAIL() << "two numbers for twelve control points";
  } catch (const InputError& error) {
    EXPECT_STREQ(error.what(),
                 "bent.toml:7: box.moves holds 2 numbers, but 3 x 2 x 2 control points need 36; "
                 "give three for each point, or none");
  }
}

TEST(Ffd, RefusesABoxThatRoundingMakesFlat) {
  Tried ffd("ffd");
  ffd.set("low_x", 1e9).set("size_x", 1e-9);
  EXPECT_THROW(ffd.changed_context(), InputError);
}

}  // namespace
}  // namespace phytobench
