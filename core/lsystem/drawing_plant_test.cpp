// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_plant.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/outline_triangles.hpp"
#include "core/lsystem/test_words.hpp"
#include "core/tree/gltf_export.hpp"
#include "core/tree/mesh_measures.hpp"
#include "core/tree/obj_export.hpp"

namespace phytobench {
namespace {

DrawingPlant plant_of(std::string_view text, double angle_deg = 90.0,
                      const DrawingPlantOptions& options = {}) {
  TestWords words(test_turtle(angle_deg));
  const Word word = words.word(text);
  return make_drawing_plant(words.system, word, options);
}

TEST(DrawingPlantLaw, HasATubeForEachSegmentAndTwoSidesForEachPolygon) {
  const DrawingPlant plant = plant_of(bush_word(4, 5, 7, 5), 22.5);
  EXPECT_EQ(plant.branches.triangle_count(), 2u * 6u * 135u);
  EXPECT_EQ(plant.branch_colours.size(), plant.branches.triangle_count());
  EXPECT_EQ(plant.leaves.triangle_count(), 42u * 2u * 4u);  // a hexagon is four triangles
  EXPECT_EQ(plant.leaf_colours.size(), plant.leaves.triangle_count());
  const double leaf = 2.0 * std::sin(std::acos(-1.0) / 8.0) + std::sin(std::acos(-1.0) / 4.0);
  EXPECT_NEAR(surface_area(plant.leaves), 2.0 * 42.0 * leaf, 1e-9);
}

TEST(DrawingPlantLaw, NormalsAreUnitVectorsOnTheTrianglesOwnSide) {
  const DrawingPlant plant = plant_of("F[&{-f+f+f-|-f+f+f}]F", 22.5);
  for (const TriangleMesh* mesh : {&plant.branches, &plant.leaves})
    for (const Triangle& t : mesh->triangles) {
      const Vector3 face = cross(mesh->positions[t[1]] - mesh->positions[t[0]],
                                 mesh->positions[t[2]] - mesh->positions[t[0]]);
      for (const std::uint32_t vertex : t) {
        EXPECT_NEAR(norm(mesh->normals[vertex]), 1.0, 1e-12);
        EXPECT_GT(dot(mesh->normals[vertex], face), 0.0);
      }
    }
}

TEST(DrawingPlant, TakesRadiiFromWidthsThatDiffer) {
  TestWords words(test_turtle(90.0));
  const TurtleTree tree = words.tree("!(0.1)F(10)[+!(0.05)F(5)]F(5)");
  EXPECT_THAT(drawing_radii(tree, {}),
              testing::Pointwise(testing::FloatEq(), {0.05f, 0.05f, 0.025f, 0.05f}));
  DrawingPlantOptions longer;
  longer.length_of_width = 10.0;
  EXPECT_FLOAT_EQ(static_cast<float>(drawing_radii(tree, longer)[0]), 0.5f);
  DrawingPlantOptions pipes;
  pipes.radii = BranchRadii::pipe_model;
  pipes.tip_radius = 1.0;
  EXPECT_EQ(drawing_radii(tree, pipes)[0], std::sqrt(2.0));
}

TEST(DrawingPlant, ScalesWidthsThatAreTooLargeAndNotGiven) {
  TestWords words(test_turtle(90.0));
  words.system.turtle.width_factor = 0.5;
  const std::vector<double> radii = drawing_radii(words.tree("F!F"), {});
  EXPECT_NEAR(radii[1], 0.02 * 2.0, 1e-12);
  EXPECT_NEAR(radii[2], 0.5 * radii[1], 1e-12);
}

TEST(DrawingPlant, TakesWidthsAsTheyAreGiven) {
  const auto root = [](const TurtleSettings& turtle, std::string_view word) {
    return drawing_radii(TestWords(turtle).tree(word), {}).front();
  };
  TurtleSettings wide = test_turtle(90.0);
  wide.width = 0.25;
  wide.width_is_given = true;
  // All widths are the same, and too thick for what is drawn.
  EXPECT_EQ(root(wide, "F[+F]F"), 0.125);
  EXPECT_EQ(root(test_turtle(90.0), "!(0.25)F[+F]F"), 0.125);
  EXPECT_EQ(root(test_turtle(90.0), "!(8)F[+F]F"), 4.0);
  EXPECT_EQ(root(test_turtle(90.0), "F(1,0.5)[+F]F"), 0.25);
  // Said by a factor: not by number of tips, but in proportion.
  EXPECT_EQ(root(test_turtle(90.0), "!F(50)[+F]F"), 0.35f);
  // A ! that is declared and does not occur says nothing.
  TestWords words(test_turtle(90.0));
  words.word("!(3)");
  EXPECT_NE(drawing_radii(words.tree("F[+F]F"), {}).front(), 1.5);
}

double root_radius_of(const TurtleSettings& turtle, std::string_view text) {
  TestWords words(turtle);
  const Word word = words.word(text);
  return make_drawing_plant(words.system, word, {}).root_radius;
}

TEST(DrawingPlant, TakesWidthsAsTheyAreGivenForLinesThatAreNoTree) {
  TurtleSettings wide = test_turtle(90.0);
  wide.width = 3.0;
  wide.width_is_given = true;
  EXPECT_EQ(root_radius_of(wide, "FFfF+F"), 1.5);
  EXPECT_EQ(root_radius_of(test_turtle(90.0), "!(3)FFfF+F"), 1.5);
  EXPECT_LT(root_radius_of(test_turtle(90.0), "FFfF+F"), 0.21);
}

TEST(DrawingPlant, ACurveIsALineOfOneWidth) {
  TestWords words(test_turtle(90.0));
  const std::vector<double> radii = drawing_radii(words.tree("FF+F+FF-F-FFF"), {});
  for (const double radius : radii) EXPECT_EQ(radius, radii.front());
  EXPECT_GT(radii.front(), 0.0);
  EXPECT_LE(radii.front(), 0.2);  // of a segment
}

TEST(DrawingPlant, TakesThePipeModelWhereNoWidthWasSaid) {
  DrawingPlantOptions options;
  options.tip_radius = 1.0;
  const auto root = [&](double exponent) {
    options.radius_exponent = exponent;
    TestWords words(test_turtle(90.0, 1.0, TurtleStart::local));
    return drawing_radii(words.tree(ternary_word(8, 36.0)), options).front();
  };
  EXPECT_EQ(root(2.0), 81.0);  // [Liebemann2017] eq. 3.4: 6561 tips
  EXPECT_NEAR(root(2.5), 33.634735, 5e-7);
  EXPECT_NEAR(root(3.0), 18.720754, 5e-7);
}

TEST(DrawingPlant, HasPositiveRadiiEvenWithoutWidth) {
  TestWords words(test_turtle(90.0));
  for (const double radius : drawing_radii(words.tree("F!(0)F[+F]"), {})) EXPECT_GT(radius, 0.0);
  DrawingPlantOptions by_widths;
  by_widths.radii = BranchRadii::widths;
  for (const double radius : drawing_radii(words.tree("!(0)FF"), by_widths)) EXPECT_GT(radius, 0.0);
  for (const double radius : drawing_radii(words.tree("F(0)"), {})) EXPECT_GT(radius, 0.0);
}

TEST(DrawingPlant, OfLinesThatAreNoTree) {
  const DrawingPlant plant = plant_of("FFfF+F");
  EXPECT_EQ(plant.branches.triangle_count(), 2u * 6u * 4u);
  EXPECT_EQ(plant.branch_colours.size(), plant.branches.triangle_count());
}

TEST(DrawingPlant, OfNothingIsNothing) {
  const DrawingPlant plant = plant_of("A");
  EXPECT_TRUE(plant.branches.triangles.empty());
  EXPECT_TRUE(scene_objects(plant_of("A"), {}).empty());
}

TEST(DrawingPlant, FillsConcaveLeaves) {
  // An L of three unit squares.
  const DrawingPlant l_shape = plant_of("{f(2)-f-f+f-f-f(2)}");
  EXPECT_NEAR(surface_area(l_shape.leaves), 2.0 * 3.0, 1e-12);
}

TEST(DrawingPlant, MakesObjectsForTheExports) {
  const auto objects = scene_objects(plant_of("F[{-f+f+f-|-f+f+f}]F", 22.5), {});
  ASSERT_EQ(objects.size(), 2u);
  EXPECT_EQ(objects[0].name, "bark");
  EXPECT_EQ(objects[1].name, "leaves");
  EXPECT_FALSE(to_glb(objects).empty());
  EXPECT_EQ(to_obj(objects, "x.obj").size(), 4u);  // two textures, materials, the model
  for (const SceneObject& object : objects) {
    EXPECT_EQ(object.mesh.normals.size(), object.mesh.vertex_count());
    EXPECT_EQ(object.mesh.texture_points.size(), object.mesh.vertex_count());
  }
}

TEST(DrawingPlant, MakesAnObjectOfEachColour) {
  DrawingPlantOptions options;
  options.colours = {"#102030", "#405060", "#708090"};
  const auto objects = scene_objects(plant_of("F'F[{f+f+f}]'''F", 60.0, options), options);
  ASSERT_EQ(objects.size(), 3u);
  EXPECT_EQ(objects[0].name, "bark-c0");
  EXPECT_EQ(objects[1].name, "bark-c1");  // colours 1 and 4
  EXPECT_EQ(objects[1].mesh.triangle_count(), 2u * 6u * 2u);
  EXPECT_EQ(objects[2].name, "leaves-c1");
  EXPECT_EQ(parse_png(objects[2].texture_png, "leaf").at(0, 0), to_pixel(parse_colour("#405060")));
  for (const SceneObject& object : objects)
    for (const Triangle& t : object.mesh.triangles)
      for (const std::uint32_t vertex : t) EXPECT_LT(vertex, object.mesh.vertex_count());
}

TEST(DrawingPlant, RefusesWhatIsTooLarge) {
  const std::string many(most_outline_corners + 1, 'f');
  EXPECT_THROW(plant_of("{" + many + "}"), InputError);
  EXPECT_NO_THROW(plant_of("{ff+f+f}"));
}

}  // namespace
}  // namespace phytobench
