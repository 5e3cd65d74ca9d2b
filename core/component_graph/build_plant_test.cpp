// SPDX-License-Identifier: MIT
#include "core/component_graph/build_plant.hpp"

#include <cmath>
#include <numbers>
#include <string>

#include <gtest/gtest.h>

#include "core/component_graph/plant_scene.hpp"
#include "core/component_graph/test_components.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

using namespace test_components;

constexpr double degree = std::numbers::pi / 180.0;

/// A triangle with a corner at the origin, one at the height of `length`.
void make_flag(double length, const Colour& colour, std::vector<MeshPart>& parts) {
  MeshPart part;
  part.material = {Surface::plain, colour};
  part.mesh.positions = {{0.0, 0.0, 0.0}, {0.1, 0.0, 0.0}, {0.0, length, 0.0}};
  part.mesh.normals.assign(3, {0.0, 0.0, 1.0});
  part.mesh.texture_points.assign(3, {});
  part.mesh.triangles = {{0, 1, 2}};
  parts.push_back(std::move(part));
}

/// A red stick of length 1 with its one child at its tip, half as large.
constexpr ComponentKind stick{.name = "stick",
                              .place_children =
                                  [](const ComponentInput&, LinkKind, std::span<Frame> frames) {
                                    for (Frame& frame : frames) {
                                      frame.origin = {0.0, 1.0, 0.0};
                                      frame.scale = 0.5;
                                    }
                                  },
                              .make_geometry =
                                  [](const ComponentInput&, std::vector<MeshPart>& parts) {
                                    make_flag(1.0, {1.0, 0.0, 0.0}, parts);
                                  }};

/// Turns its i-th child by i times 90 degrees about z.
constexpr ComponentKind star{
    .name = "star",
    .keys = count_key,
    .is_multiplier = true,
    .child_count = first_count,
    .place_children = [](const ComponentInput&, LinkKind, std::span<Frame> frames) {
      double turn = 0.0;
      for (Frame& frame : frames) {
        turn += 90.0 * degree;
        frame = frame.turned(Rotation::about({0.0, 0.0, 1.0}, turn));
      }
    }};

/// Counts what its colour says.
constexpr ComponentKind green{
    .name = "green",
    .place_children = place_nowhere,
    .make_geometry = [](const ComponentInput& input, std::vector<MeshPart>& parts) {
      make_flag(input.context.photo->at({}, 0.0).y, {0.0, 1.0, 0.0}, parts);
    }};

/// Light comes from five times as high below it.
constexpr ComponentKind sun{.name = "sun",
                            .place_children = place_nowhere,
                            .change_context = [](const ComponentInput&, BuildContext& context) {
                              context.photo = std::make_shared<VectorField>(Vector3{0.0, 5.0, 0.0});
                            }};

class ShiftByTen final : public Deformation {
 public:
  Vector3 moved(const Vector3& place) const override { return place + Vector3{10.0, 0.0, 0.0}; }
  bool bends(Surface) const override { return true; }
};

constexpr ComponentKind shift{.name = "shift",
                              .place_children = place_nowhere,
                              .change_context = [](const ComponentInput&, BuildContext& context) {
                                context.deformations.push_back(std::make_shared<ShiftByTen>());
                              }};

constexpr ComponentKind runaway{
    .name = "runaway",
    .place_children = [](const ComponentInput&, LinkKind, std::span<Frame> frames) {
      for (Frame& frame : frames) frame.scale = 1e10;
    }};

TEST(BuildPlant, PlacesChildrenInTheFramesOfTheirParents) {
  GraphMaker maker;
  maker.add("a", stick).add_counted("s", star, 2.0).add("b", stick);
  maker.link("a", "s").link("s", "b");
  const BuiltPlant plant = build_plant(maker.graph());
  EXPECT_EQ(plant.instance_count, 4u);
  EXPECT_EQ(plant.instances, (std::vector<std::uint64_t>{1, 1, 2}));
  EXPECT_EQ(plant.triangle_count, 3u);
  ASSERT_EQ(plant.parts.size(), 1u);
  const auto& positions = plant.parts[0].mesh.positions;
  ASSERT_EQ(positions.size(), 9u);
  EXPECT_EQ(positions[2], (Vector3{0.0, 1.0, 0.0}));
  // From (0, 1, 0), half as long: to -x, then downwards.
  EXPECT_LT(norm(positions[5] - Vector3{-0.5, 1.0, 0.0}), 1e-15);
  EXPECT_LT(norm(positions[8] - Vector3{0.0, 0.5, 0.0}), 1e-15);
}

TEST(BuildPlant, ARecursionShrinksGeometrically) {
  GraphMaker maker;
  maker.add("a", stick, 20).link("a", "a");
  const BuiltPlant plant = build_plant(maker.graph());
  EXPECT_EQ(plant.instance_count, 20u);
  EXPECT_EQ(plant.parts[0].mesh.positions.back().y, 2.0 - std::exp2(-19.0));
}

TEST(BuildPlant, WhatAComponentChangesHoldsBelowItOnly) {
  GraphMaker maker;
  maker.add("root").add("sun", sun).add("in", green).add("out", green);
  maker.link("root", "sun").link("sun", "in").link("root", "out");
  const BuiltPlant plant = build_plant(maker.graph());
  const auto& positions = plant.parts.at(0).mesh.positions;
  EXPECT_EQ(positions.at(2).y, 5.0);
  EXPECT_EQ(positions.at(5).y, 1.0);
}

TEST(BuildPlant, DeformationsBendWhatHangsBelow) {
  GraphMaker maker;
  maker.add("a", stick).add("shift", shift).add("b", stick).link("a", "shift").link("shift", "b");
  const auto positions = build_plant(maker.graph()).parts[0].mesh.positions;
  EXPECT_EQ(positions[2].x, 0.0);
  EXPECT_EQ(positions[5], (Vector3{10.0, 1.5, 0.0}));
}

TEST(BuildPlant, SortsTrianglesByMaterial) {
  GraphMaker maker;
  maker.add("a", stick).add("g", green).add("b", stick).link("a", "g").link("a", "b");
  BuiltPlant plant = build_plant(maker.graph());
  ASSERT_EQ(plant.parts.size(), 2u);
  EXPECT_EQ(plant.parts[0].mesh.triangle_count(), 2u);
  EXPECT_EQ(plant.parts[1].mesh.triangle_count(), 1u);
  const std::vector<SceneObject> objects = scene_objects(std::move(plant));
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "plain");
  EXPECT_EQ(objects[1].name, "plain-2");
  EXPECT_EQ(parse_png(objects[1].texture_png, "texture").at(0, 0), (Pixel{0, 255, 0, 255}));
}

TEST(BuildPlant, IsTheSameEveryTime) {
  GraphMaker maker;
  maker.add("a", stick).add_counted("s", star, 7.0, 3).add("b", stick, 3);
  maker.link("a", "s").link("s", "b").link("b", "s");
  const auto first = build_plant(maker.graph()), second = build_plant(maker.graph());
  EXPECT_EQ(first.parts[0].mesh.positions, second.parts[0].mesh.positions);
}

TEST(BuildPlant, RefusesTooManyTrianglesAndPlacesOutOfReach) {
  GraphMaker maker;
  maker.add_counted("s", star, 5.0).add("b", stick).link("s", "b");
  EXPECT_NO_THROW(build_plant(maker.graph(), {.most_triangles = 5}));
  EXPECT_THROW(build_plant(maker.graph(), {.most_triangles = 4}), InputError);
  GraphMaker far;
  far.add("r", runaway, 5).add("b", stick).link("r", "r").link("r", "b", LinkKind::leaf);
  try {
    build_plant(far.graph());
    FAIL() << "coordinates of 1e50";
  } catch (const InputError& error) {
    EXPECT_NE(std::string(error.what()).find("component 'r' (runaway) reaches"), std::string::npos);
  }
}

TEST(BuildPlant, CanBeStopped) {
  GraphMaker maker;
  maker.add_counted("s", star, 9000.0).add("b", stick).link("s", "b");
  EXPECT_THROW(build_plant(maker.graph(), {.progress = [](double) { return false; }}), Interrupted);
  double last = 0.0;
  build_plant(maker.graph(), {.progress = [&](double share) {
                EXPECT_GT(share, last);
                last = share;
                return true;
              }});
  EXPECT_GT(last, 0.5);
  EXPECT_LE(last, 1.0);
}

}  // namespace
}  // namespace phytobench
