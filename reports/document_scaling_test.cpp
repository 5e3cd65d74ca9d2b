// SPDX-License-Identifier: MIT
#include "reports/document_scaling.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

namespace phytobench {
namespace {

using nlohmann::ordered_json;
using testing::HasSubstr;
using testing::Not;

/// Two engines of which "good" overtakes "simple", and an aim that is missed.
JudgedScaling made_up() {
  JudgedScaling scaling;
  scaling.study = {.id = "s", .experiment = "p/s", .title = "Engines", .intro = {}, .aims = {}};
  ScaledEntry good{.name = "good.dn", .at = {}}, simple{.name = "simple.dn", .at = {}};
  for (const double size : {1000.0, 10000.0, 1000000.0}) {
    scaling.sizes[size] = {.points = size,
                           .nodes = size / 4,
                           .iterations = 10,
                           .association_pairs = size,
                           .removal_pairs = size / 4};
    const MedianOfRounds seconds{{1e-6 * size, 0.9e-6 * size, 1.1e-6 * size}, 9};
    good.at[size] = {.exact = true,
                     .seconds = seconds,
                     .evaluations = 2.5 * size,
                     .cells_visited = size,
                     .over_floor = 2.0,
                     .bytes_per_point = 50.0,
                     .phase_seconds = {{"build", 1e-7 * size}, {"growth", 2e-7 * size}}};
  }
  simple.at[1000] = {.exact = false,
                     .seconds = {},
                     .evaluations = {},
                     .cells_visited = {},
                     .over_floor = {},
                     .bytes_per_point = {},
                     .phase_seconds = {}};
  good.work_law = PowerLaw{.exponent = {1.0, 0.9, 1.1}, .factor = 2.5};
  good.time_law = PowerLaw{.exponent = {1.25, 1.2, 1.3}, .factor = 1e-6};
  scaling.entries = {good, simple};
  scaling.crossovers = {{"simple.dn", "good.dn", 1000, 10000, 4567.8, 9}};
  const Aim missed{.kind = Aim::Kind::ratio,
                   .text = "Twice as fast",
                   .entries = {},
                   .sizes = {},
                   .must = 2,
                   .aim = 3,
                   .limits = "Memory is slow."};
  scaling.aims = {
      {.aim = missed, .state = JudgedAim::State::missed, .measured = {{1.5, 1.4, 1.6}, 9}},
      {.aim = missed, .state = JudgedAim::State::reached, .measured = {{4, 3.5, 5}, 9}},
      {.aim = missed, .state = JudgedAim::State::open, .measured = {{2, 2, 2}}, .varies = false}};
  return scaling;
}

const ordered_json* grid_of(const ordered_json& document, const std::string& title) {
  for (const ordered_json& grid : document["grids"])
    if (grid["title"] == title) return &grid;
  return nullptr;
}

TEST(ScalingDocument, SaysWhatLimitsOnlyWhereAnAimIsMissed) {
  const ordered_json aims = scaling_document(made_up(), {}, false)["aims"];
  ASSERT_EQ(aims.size(), 3u);
  EXPECT_EQ(aims[0]["state"], "missed");
  EXPECT_EQ(aims[0]["limits"], "Memory is slow.");
  EXPECT_EQ(aims[0]["interval"], "1.4 to 1.6");
  EXPECT_EQ(aims[1]["state"], "aim reached");
  EXPECT_EQ(aims[1]["limits"], "");
}

TEST(ScalingDocument, SaysNotWhatLimitsAnAimThatMayBeReached) {
  JudgedScaling scaling = made_up();
  scaling.aims[0].state = JudgedAim::State::must_reached_aim_open;
  scaling.aims[0].measured = {{2.9, 2.5, 3.5}, 9};
  scaling.aims[1].state = JudgedAim::State::open;
  scaling.aims[1].measured = {{2.2, 1.8, 3.5}, 9};
  scaling.aims[2].measured = {{2.2, 1.8, 2.5}, 9};
  const ordered_json aims = scaling_document(scaling, {}, false)["aims"];
  EXPECT_EQ(aims[0]["state"], "least reached, aim open");
  EXPECT_EQ(aims[0]["has_limits"], false);
  EXPECT_EQ(aims[1]["state"], "open: the interval holds the bound");
  EXPECT_EQ(aims[1]["has_limits"], false);
  EXPECT_EQ(aims[2]["state"], "open: the interval holds the bound");
  EXPECT_EQ(aims[2]["limits"], "Memory is slow.") << "it misses its aim, if not its least";
}

TEST(ScalingDocument, LeavesAimsAndCrossoversOfFewRoundsOpenAndShowsTheirRange) {
  JudgedScaling scaling = made_up();
  scaling.aims[0].state = JudgedAim::State::open;
  scaling.aims[0].measured.rounds = 3;
  scaling.crossovers[0].rounds = 5;
  scaling.entries[0].at.at(1000).seconds->rounds = 4;
  const ordered_json document = scaling_document(scaling, {}, false);
  EXPECT_EQ(document["aims"][0]["state"], "open: 3 rounds, 6 needed");
  EXPECT_EQ(document["aims"][0]["interval"], "1.4 to 1.6 in 3 rounds");
  EXPECT_EQ(document["aims"][0]["has_limits"], false) << "nobody knows that it is missed";
  EXPECT_EQ(document["crossovers"][0],
            "good.dn overtakes simple.dn between 1,000 and 10,000 points (about 4,600); open: 5 "
            "rounds, 6 needed");
  const ordered_json* grid = grid_of(document, "Time of one growth");
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ((*grid)["rows"][0]["cells"][0]["interval"], "900 us to 1.1 ms in 4 rounds");
  EXPECT_EQ((*grid)["rows"][0]["cells"][1]["interval"], "9 ms to 11 ms");
}

TEST(ScalingDocument, ShowsAnAimThatIsJustMissedAsSuch) {
  JudgedScaling scaling = made_up();
  scaling.aims[2].measured = {{1.9999999, 1.9999999, 1.9999999}};
  const ordered_json aim = scaling_document(scaling, {}, false)["aims"][2];
  EXPECT_EQ(aim["measured"], "1.9999999");
  EXPECT_EQ(aim["has_interval"], false) << "it was counted";
}

TEST(ScalingDocument, ShowsBoundsWithTheDigitsOfWhatWasMeasured) {
  JudgedScaling scaling = made_up();
  scaling.aims[2].aim.must = 1.234444;
  scaling.aims[2].measured = {{1.2344448, 1.2344448, 1.2344448}};
  const ordered_json aim = scaling_document(scaling, {}, false)["aims"][2];
  EXPECT_EQ(aim["measured"], "1.234445") << "1.234 would look like less than the bound";
  EXPECT_EQ(aim["must"], "at least 1.234444");
  EXPECT_EQ(aim["aim"], "3");
}

TEST(ScalingDocument, NamesCrossoversInRoundNumbers) {
  const ordered_json document = scaling_document(made_up(), {}, false);
  ASSERT_EQ(document["crossovers"].size(), 1u);
  EXPECT_EQ(document["crossovers"][0],
            "good.dn overtakes simple.dn between 1,000 and 10,000 points (about 4,600)");
}

TEST(ScalingDocument, HoldsNoTimeWhenWhatVariesIsLeftOut) {
  const ordered_json document = scaling_document(made_up(), {{"s-work", "<svg/>"}}, true);
  EXPECT_TRUE(document["crossovers"].empty());
  EXPECT_EQ(document["aims"].size(), 1u) << "counts stay";
  for (const ordered_json& grid : document["grids"]) EXPECT_EQ(grid["varies"], false);
  const std::string text = document.dump();
  for (const char* varying : {" ms", " us", "1.25", "50.0", "seconds"})
    EXPECT_THAT(text, Not(HasSubstr(varying)));
  EXPECT_NE(grid_of(document, "Evaluations over the floor"), nullptr);
}

TEST(ScalingDocument, ShowsAnInexactEngineAsSuch) {
  const ordered_json document = scaling_document(made_up(), {}, false);
  const ordered_json* grid = grid_of(document, "Evaluations over the floor");
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ((*grid)["columns"], (ordered_json{"1,000", "10,000", "1,000,000"}));
  EXPECT_EQ((*grid)["rows"][0]["cells"][0]["text"], "2");
  EXPECT_EQ((*grid)["rows"][1]["cells"][0]["text"], "inexact");
  EXPECT_EQ((*grid)["rows"][1]["cells"][1]["text"], "-") << "not grown at that size";
}

TEST(ScalingDocument, ShowsWhereTheFarthestEngineSpendsItsTime) {
  const ordered_json document = scaling_document(made_up(), {}, false);
  const ordered_json* grid = grid_of(document, "Where good.dn spends its time");
  ASSERT_NE(grid, nullptr);
  EXPECT_EQ((*grid)["rows"][0]["cells"][0]["text"], "100.0") << "nanoseconds per point";
  EXPECT_EQ((*grid)["rows"][0]["cells"][1]["text"], "-");
  EXPECT_EQ((*grid)["rows"][0]["cells"][4]["text"], "2.50") << "points per cell";
}

}  // namespace
}  // namespace phytobench
