// SPDX-License-Identifier: MIT
#include "experiments/alsweis/stand_panels.hpp"

#include <algorithm>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/paired_runs.hpp"

namespace phytobench::experiments::alsweis {
namespace {

constexpr StandMap ten_metres{.ground = {{0.0, 0.0}, {10.0, 10.0}}, .panel_width = 100.0};

std::size_t count_of(const std::string& part, const std::string& text) {
  std::size_t count = 0;
  for (std::size_t at = text.find(part); at != std::string::npos; at = text.find(part, at + 1))
    ++count;
  return count;
}

StandLayer one(StandMark mark, Point2 place, double radius) {
  return {.name = "plant", .places = {place}, .radii = {radius}, .mark = mark};
}

std::string drawn(const StandMap& map, const StandLayer& layer) {
  return stand_panels_svg(map, {{.layers = {layer}, .caption = "stand"}}, "title");
}

TEST(StandPanels, RingsAndDiscsLieWhereTheirPlantsStand) {
  // 20 units of half a pixel per metre, from the upper left corner.
  EXPECT_NE(drawn(ten_metres, one(StandMark::ring, {2.0, 7.0}, 1.5))
                .find("<circle cx=\"40\" cy=\"60\" r=\"30\"/>"),
            std::string::npos);
  EXPECT_NE(drawn(ten_metres, one(StandMark::disc, {2.0, 7.0}, 1.5))
                .find("stroke-width=\"60\" stroke-linecap=\"round\" d=\"m40 60h0\""),
            std::string::npos);
}

TEST(StandPanels, DashedRingsAreDashedAndCrossesReachAsFarAsTheirRadius) {
  const std::string dashed = drawn(ten_metres, one(StandMark::dashed_ring, {2.0, 7.0}, 1.5));
  EXPECT_NE(dashed.find("<circle cx=\"40\" cy=\"60\" r=\"30\"/>"), std::string::npos);
  EXPECT_EQ(count_of("stroke-dasharray", dashed), 2u) << "on the map and in the legend";
  EXPECT_EQ(count_of("stroke-dasharray", drawn(ten_metres, one(StandMark::ring, {2, 7}, 1.5))), 0u);
  EXPECT_NE(drawn(ten_metres, one(StandMark::cross, {2.0, 7.0}, 0.5))
                .find("d=\"M30 50l20 20m0 -20l-20 20\""),
            std::string::npos);
}

TEST(StandPanels, ThinStemsAreStillSeen) {
  EXPECT_NE(drawn(ten_metres, one(StandMark::disc, {5.0, 5.0}, 1e-6)).find("stroke-width=\"4\""),
            std::string::npos);
}

TEST(StandPanels, OnATorusAZoneComesInAgainOnEverySideThatItLeaves) {
  const StandLayer corner = one(StandMark::ring, {0.5, 9.5}, 1.0);
  const StandLayer middle = one(StandMark::ring, {5.0, 5.0}, 1.0);
  StandMap torus = ten_metres;
  torus.is_torus = true;
  EXPECT_EQ(count_of("<circle", drawn(torus, corner)), 4u);
  EXPECT_EQ(count_of("<circle", drawn(torus, middle)), 1u);
  EXPECT_EQ(count_of("<circle", drawn(ten_metres, corner)), 1u);
}

TEST(StandPanels, WhatLiesOutsideIsLeftOut) {
  EXPECT_EQ(count_of("<circle", drawn(ten_metres, one(StandMark::ring, {12.0, 5.0}, 1.5))), 0u);
  EXPECT_EQ(count_of("<circle", drawn(ten_metres, one(StandMark::ring, {11.0, 5.0}, 1.5))), 1u);
}

StandLayer crowd(std::size_t plants) {
  CounterStream stream(1, 0);
  StandLayer layer{.name = "crowd", .places = {}, .radii = {}};
  for (std::size_t i = 0; i < plants; ++i) {
    const double x = 10.0 * stream.next_unit(), y = 10.0 * stream.next_unit();
    layer.places.push_back({x, y});
    layer.radii.push_back(0.05 + 0.2 * stream.next_unit());
  }
  return layer;
}

TEST(StandPanels, TheOrderOfPlantsDoesNotMatter) {
  for (const StandMark mark : {StandMark::disc, StandMark::ring}) {
    StandLayer layer = crowd(200);
    layer.mark = mark;
    StandLayer reversed = layer;
    std::reverse(reversed.places.begin(), reversed.places.end());
    std::reverse(reversed.radii.begin(), reversed.radii.end());
    EXPECT_EQ(drawn(ten_metres, layer), drawn(ten_metres, reversed));
  }
}

TEST(StandPanels, AThousandStemsTakeLessThanTenKilobytes) {
  StandLayer layer = crowd(1000);
  std::fill(layer.radii.begin(), layer.radii.end(), 0.02);
  EXPECT_LT(drawn(ten_metres, layer).size(), 10'000u);
}

TEST(StandPanels, NamesOfLayersAreListedOnceAndTextIsWrittenOut) {
  const StandPanel panel{.layers = {one(StandMark::disc, {1.0, 1.0}, 0.5)}, .caption = "a < b"};
  const std::string svg = stand_panels_svg(ten_metres, {panel, panel}, "t & u");
  EXPECT_EQ(count_of(">plant</text>", svg), 1u);
  EXPECT_EQ(count_of(">a &lt; b</text>", svg), 2u);
  EXPECT_EQ(count_of("<title>t &amp; u</title>", svg), 1u);
  EXPECT_EQ(count_of("id=", svg), 0u) << "pictures on one page must not share ids";
}

TEST(StandPanels, ABadLayerIsABug) {
  StandLayer layer = one(StandMark::disc, {1.0, 1.0}, 0.5);
  layer.radii.clear();
  EXPECT_THROW(drawn(ten_metres, layer), ContractViolation);
  EXPECT_THROW(stand_panels_svg(ten_metres, {}, "nothing"), ContractViolation);
}

TEST(StandPanels, LayersOfAPopulationHaveItsPlantsAndZones) {
  PopulationParameters parameters;
  parameters.species.resize(2);
  parameters.species[0].name = "fern";
  parameters.species[1].name = "moss";
  parameters.species[0].count = 3;
  parameters.species[1].count = 5;
  parameters.species[0].roots = {.poor_factor = 4.0, .rich_factor = 4.0, .exponent = 0.0};
  parameters.species[0].crown = {.poor_factor = 2.0, .rich_factor = 2.0, .exponent = 0.0};
  const Population population = population_of(parameters);
  EXPECT_EQ(stems_of(population, 0).places.size(), 3u);
  EXPECT_EQ(stems_of(population, 1).places.size(), 5u);
  EXPECT_EQ(root_zones_of(population, 0).radii, std::vector<double>(3, 4.0));
  EXPECT_EQ(crown_zones_of(population, 0).radii, std::vector<double>(3, 2.0));
  EXPECT_EQ(stems_of(population, 1).name, "moss");
  EXPECT_EQ(stems_of(population, 0, 2.0).radii[0], 2.0 * stems_of(population, 0).radii[0]);
}

}  // namespace
}  // namespace phytobench::experiments::alsweis
