// SPDX-License-Identifier: MIT
#include "core/population/stand_picture.hpp"

#include <algorithm>
#include <cmath>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/picture/curve_svg.hpp"
#include "core/population/stand_look.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

/// Plants put by hand on a ground of 100 m by 50 m, with zones of their own.
struct Scene {
  PopulationParameters parameters;
  Stand stand;
  std::vector<double> loss, roots, crowns;

  Scene() {
    parameters.ground = {{0.0, 0.0}, {100.0, 50.0}};
    parameters.species.resize(1);
    parameters.species[0].name = "shrub";
  }

  void add(const Point2& place, double root_radius, double its_loss = 0.0) {
    stand.id.push_back(stand.size());
    stand.x.push_back(place.x);
    stand.y.push_back(place.y);
    stand.stem_radius.push_back(0.5);
    stand.age.push_back(0);
    stand.ill_since.push_back(healthy);
    stand.species.push_back(0);
    loss.push_back(its_loss);
    roots.push_back(root_radius);
  }

  StandView view() const { return {parameters, stand, loss, roots, crowns}; }
  Image image(int side = 200) const { return parse_png(stand_png(view(), side), "stand.png"); }
  std::string svg() const { return stand_svg(view(), "a title"); }
};

constexpr Pixel white{255, 255, 255, 255};

std::ptrdiff_t circles_in(const std::string& svg) {
  std::ptrdiff_t count = 0;
  for (std::size_t at = svg.find("<circle"); at != std::string::npos;
       at = svg.find("<circle", at + 1))
    ++count;
  return count;
}

bool is_reddish(const Pixel& p) {
  return p[0] > p[1] + 20 && p[1] > p[2];
}

TEST(StandImage, HasTheGroundsProportionsAndIsWhiteWithoutPlants) {
  const Image image = Scene().image();
  EXPECT_EQ(image.width(), 200);
  EXPECT_EQ(image.height(), 100);
  EXPECT_TRUE(std::all_of(image.pixels().begin(), image.pixels().end(),
                          [](const Pixel& pixel) { return pixel == white; }));
}

TEST(StandImage, DrawsAPlantWhereItStandsWithHighYAtTheTop) {
  Scene scene;
  scene.add({25.0, 40.0}, 5.0);
  const Image image = scene.image();
  EXPECT_NE(image.at(50, 20), white);
  EXPECT_NE(image.at(59, 20), white);  // the zone's rim, 10 pixels out
  EXPECT_EQ(image.at(62, 20), white);
  EXPECT_EQ(image.at(50, 80), white);
  EXPECT_EQ(image.at(49, 20), image.at(50, 20));  // between two pixels: both alike
  EXPECT_EQ(image.at(50, 19), image.at(50, 20));
}

TEST(StandImage, RimsAreSoft) {
  Scene scene;
  scene.add({25.0, 25.0}, 7.7);
  const Image image = scene.image();
  std::set<Pixel> shades;
  for (int column = 30; column < 50; ++column) shades.insert(image.at(column, 50));
  EXPECT_GE(shades.size(), 4u);
}

TEST(StandImage, ZonesOfOppressedPlantsAreRed) {
  Scene scene;
  scene.add({25.0, 25.0}, 10.0, 0.5);
  scene.add({75.0, 25.0}, 10.0, 0.51);
  const Image image = scene.image();
  EXPECT_FALSE(is_reddish(image.at(69, 50)));
  EXPECT_TRUE(is_reddish(image.at(169, 50)));
}

TEST(StandImage, CirclesAreHollowWhereZonesLieInManyLayers) {
  Scene scene;
  for (int i = 0; i < 150; ++i) scene.add({50.0, 25.0}, 24.0);
  const Image few = scene.image();
  EXPECT_NE(few.at(70, 50), white);
  for (int i = 0; i < 900; ++i) scene.add({50.0, 25.0}, 24.0);
  const Image many = scene.image();
  EXPECT_EQ(many.at(70, 50), white);
  for (const int column : {52, 147}) EXPECT_NE(many.at(column, 50), white);  // 48 pixels out
  EXPECT_NE(many.at(100, 2), white);
  EXPECT_NE(many.at(100, 97), white);
}

TEST(StandImage, ZonesGoRoundATorusAndEndAtTheEdgesOfAPlot) {
  Scene scene;
  scene.add({1.0, 25.0}, 10.0);
  EXPECT_NE(scene.image().at(190, 50), white);
  scene.parameters.is_torus = false;
  EXPECT_EQ(scene.image().at(190, 50), white);
}

TEST(StandImage, IsTheSameForAnyOrderInMemory) {
  Scene scene, reversed;
  for (int i = 0; i < 40; ++i)
    scene.add({37 * i % 101 + 0.5, 13 * i % 50 + 0.5}, 4.0 + i % 7, 0.02 * i);
  for (std::size_t i = scene.stand.size(); i-- > 0;) {
    reversed.add(scene.stand.place(i), scene.roots[i], scene.loss[i]);
    reversed.stand.id.back() = i;
  }
  const std::string drawn = stand_png(scene.view(), 300);
  EXPECT_TRUE(stand_png(reversed.view(), 300) == drawn);
  std::reverse(reversed.stand.id.begin(), reversed.stand.id.end());
  EXPECT_FALSE(stand_png(reversed.view(), 300) == drawn);  // others lie on top
}

TEST(StandImage, ShowsTheMapOfNutrientsBelow) {
  Scene scene;
  scene.parameters.nutrients = ResourceMap(2, 1, {0.0, 1.0}, scene.parameters.ground);
  const Image image = scene.image();
  EXPECT_LT(image.at(50, 50)[0], 200);
  EXPECT_EQ(image.at(150, 50), white);
}

TEST(StandImage, MarksIllPlantsOutsideTheirStems) {
  Scene scene;
  scene.add({25.0, 25.0}, 20.0);
  scene.add({75.0, 25.0}, 20.0);
  const Image before = scene.image();
  scene.stand.ill_since[1] = 7;
  const Image after = scene.image();
  const auto changed = [&](int column, int row) {
    return before.at(column, row) != after.at(column, row);
  };
  int marked = 0;
  for (int row = 0; row < 100; ++row)
    for (int column = 0; column < 200; ++column)
      if (changed(column, row)) {
        ++marked;
        const double distance = std::hypot(column + 0.5 - 150.0, row + 0.5 - 50.0);
        EXPECT_GT(distance, 2.0);  // the stem has a radius of 1
        EXPECT_LT(distance, 8.0);
      }
  EXPECT_GT(marked, 15);
}

TEST(StandSvg, MarksAndCountsIllPlantsIfThereAreAny) {
  Scene scene;
  scene.add({25.0, 25.0}, 10.0);
  scene.add({75.0, 25.0}, 10.0);
  const std::string healthy_stand = scene.svg();
  EXPECT_THAT(healthy_stand, testing::Not(HasSubstr("ill: ")));
  EXPECT_THAT(healthy_stand, testing::Not(HasSubstr("dasharray")));
  scene.stand.ill_since[1] = 7;
  EXPECT_THAT(scene.svg(), HasSubstr(">ill: 1<"));
  EXPECT_EQ(circles_in(scene.svg()), circles_in(healthy_stand) + 2);  // with that of the legend
}

TEST(StandSvg, HasACircleForEveryPartOfAPlantAndTheLegend) {
  Scene scene;
  const std::ptrdiff_t legend = circles_in(scene.svg());
  EXPECT_EQ(legend, 2);  // one species, and what red means
  scene.add({50.0, 25.0}, 10.0);
  EXPECT_EQ(circles_in(scene.svg()), legend + 2);
  scene.crowns = {4.0};
  EXPECT_EQ(circles_in(scene.svg()), legend + 3);
  scene.stand.x[0] = 1.0;  // its two zones reach across the border of the torus
  EXPECT_EQ(circles_in(scene.svg()), legend + 5);
}

TEST(StandSvg, CountsItsPlantsAndEscapesTheirNames) {
  Scene scene;
  scene.parameters.species[0].name = "<b>&";
  scene.add({50.0, 25.0}, 10.0, 0.7);
  scene.add({20.0, 25.0}, 10.0);
  const std::string svg = scene.svg();
  EXPECT_THAT(svg, HasSubstr("&lt;b&gt;&amp;: 2<"));
  EXPECT_THAT(svg, HasSubstr("loses more than half: 1<"));
  EXPECT_THAT(svg, HasSubstr("<title>a title</title>"));
  EXPECT_THAT(svg, HasSubstr(">20 m<"));
  EXPECT_THAT(svg, HasSubstr("currentColor"));
  EXPECT_THAT(svg, HasSubstr("stroke=\"" + to_text(oppressed_colour())));
}

TEST(StandSvg, ShowsAMapOnlyWhereTheGroundIsPoor) {
  Scene scene;
  EXPECT_THAT(scene.svg(), testing::Not(HasSubstr("crispEdges")));
  EXPECT_THAT(scene.svg(), testing::Not(HasSubstr("poorer")));
  scene.parameters.light = ResourceMap(2, 1, {0.0, 1.0}, scene.parameters.ground);
  const std::string svg = scene.svg();
  EXPECT_THAT(svg, HasSubstr("width=\"320.00\" height=\"6.67\" fill-opacity=\"0.400\""));
  EXPECT_THAT(svg, HasSubstr(">darker ground: poorer<"));
}

TEST(StandSvg, TakesTwentyThousandPlantsAndRefusesMore) {
  Scene scene;
  for (std::size_t i = 0; i < most_plants_in_svg; ++i)
    scene.add({0.005 * static_cast<double>(i), 25.0}, 0.1);
  EXPECT_LT(scene.svg().size(), 4'000'000u);
  scene.add({1.0, 1.0}, 0.1);
  EXPECT_THROW(scene.svg(), ContractViolation);
}

TEST(StandLook, AgeLightensUntilAPlantIsGrownUp) {
  Species species;  // grows up in 100 steps
  EXPECT_EQ(age_class(species, 0), 0u);
  EXPECT_EQ(age_class(species, 49), 1u);
  EXPECT_EQ(age_class(species, 1000), age_classes - 1);
  species.largest_age = 10;
  EXPECT_EQ(age_class(species, 9), age_classes - 1);
  species.growth_rate = 0.0;
  species.largest_age = std::numeric_limits<std::int32_t>::max();
  EXPECT_EQ(age_class(species, 1000), 0u);
  for (std::size_t age = 1; age < age_classes; ++age)
    EXPECT_GT(plant_colour(0, age).red, plant_colour(0, age - 1).red);
}

TEST(StandLook, CurvesHaveTheHuesOfTheirSpecies) {
  std::set<std::size_t> colours;
  for (std::size_t species = 0; species < species_hues; ++species) {
    EXPECT_LT(curve_colour(species), curve_colours);
    EXPECT_TRUE(colours.insert(curve_colour(species)).second) << species;
    EXPECT_EQ(curve_colour(species + species_hues), curve_colour(species));
  }
}

TEST(StandLook, RingsOfIllPlantsLieOutsideStemsAndShrinkWhereTheyAreDense) {
  for (const double stem : {0.1, 3.0, 40.0}) {
    EXPECT_GT(illness_ring(stem, 50.0), stem + 2.0);
    EXPECT_GE(illness_ring(stem, 50.0), 5.0);
    EXPECT_GT(illness_ring(stem, 1.0), stem);
    EXPECT_LT(illness_ring(stem, 1.0), stem + 1.0);
  }
}

TEST(StandLook, SpeciesHaveColoursOfTheirOwn) {
  std::set<std::string> colours{to_text(oppressed_colour())};
  for (std::size_t species = 0; species < 14; ++species)
    for (std::size_t age = 0; age < age_classes; ++age)
      EXPECT_TRUE(colours.insert(to_text(plant_colour(species, age))).second) << species;
}

}  // namespace
}  // namespace phytobench
