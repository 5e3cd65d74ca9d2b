// SPDX-License-Identifier: MIT
#include "core/competition/competition_parameters.hpp"

#include <cmath>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/overlap/test_discs.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;
using testing_discs::infinite;

std::string complaint(const CompetitionParameters& parameters) {
  try {
    check_parameters(parameters);
  } catch (const InputError& error) {
    return error.what();
  }
  return "none";
}

/// What is said of one number that is changed.
std::string complaint(double CompetitionParameters::*place, double value) {
  CompetitionParameters parameters;
  parameters.*place = value;
  return complaint(parameters);
}

std::string complaint(double CompetitionTraits::*place, double value) {
  CompetitionParameters parameters;
  parameters.species.resize(3);
  parameters.species[1].*place = value;
  return complaint(parameters);
}

TEST(CompetitionParameters, DefaultsAreAllowed) {
  EXPECT_EQ(complaint(CompetitionParameters()), "none");
}

TEST(CompetitionParameters, BordersOfTheRangesAreAllowed) {
  for (const double share : {0.0, 1.0})
    EXPECT_EQ(complaint(&CompetitionParameters::above_share, share), "none");
  for (const double exponent : {0.0, 1.0, infinite})
    EXPECT_EQ(complaint(&CompetitionParameters::asymmetry_exponent, exponent), "none");
  EXPECT_EQ(complaint(&CompetitionParameters::light_constant, 1e-9), "none");
  for (const double value : {1e-9, 0.999})
    EXPECT_EQ(complaint(&CompetitionParameters::field_at_rim, value), "none");
  for (const double value : {0.0, 1.0}) {
    EXPECT_EQ(complaint(&CompetitionTraits::crown_opacity, value), "none");
    EXPECT_EQ(complaint(&CompetitionTraits::root_rank, value), "none");
    EXPECT_EQ(complaint(&CompetitionTraits::open_ground_stress, value), "none");
  }
}

TEST(CompetitionParameters, ValuesBeyondAreInputErrorsThatNameTheKey) {
  using Parameters = CompetitionParameters;
  EXPECT_EQ(complaint(&Parameters::above_share, 1.5),
            "competition.above_share = 1.5 is not allowed; give a number >= 0 and <= 1");
  EXPECT_THAT(complaint(&Parameters::asymmetry_exponent, -1.0),
              StartsWith("competition.asymmetry_exponent = -1 is not allowed"));
  EXPECT_THAT(complaint(&Parameters::light_constant, 0.0),
              StartsWith("competition.light_constant = 0 is not allowed"));
  for (const double value : {0.0, 1.0})
    EXPECT_THAT(complaint(&Parameters::field_at_rim, value),
                HasSubstr("give a number > 0 and < 1"));
  EXPECT_THAT(complaint(&CompetitionTraits::crown_opacity, 1.1),
              StartsWith("species.crown_opacity of species number 2 = 1.1 is not allowed"));
  EXPECT_THAT(complaint(&CompetitionTraits::root_rank, -0.1), StartsWith("species.roots of"));
  EXPECT_THAT(complaint(&CompetitionTraits::open_ground_stress, -0.1),
              StartsWith("species.open_ground_stress of species number 2 = -0.1"));
}

TEST(CompetitionParameters, WhatIsNoNumberIsAnInputError) {
  using Parameters = CompetitionParameters;
  for (const auto place : {&Parameters::above_share, &Parameters::asymmetry_exponent,
                           &Parameters::light_constant, &Parameters::field_at_rim}) {
    EXPECT_THAT(complaint(place, std::nan("")), HasSubstr("is not allowed"));
    EXPECT_THAT(complaint(place, -infinite), HasSubstr("is not allowed"));
    if (place != &Parameters::asymmetry_exponent)
      EXPECT_THAT(complaint(place, infinite), HasSubstr("is not allowed"));
  }
  for (const auto place : {&CompetitionTraits::crown_opacity, &CompetitionTraits::root_rank,
                           &CompetitionTraits::open_ground_stress})
    for (const double value : {std::nan(""), infinite, -infinite})
      EXPECT_THAT(complaint(place, value), HasSubstr("is not allowed"));
}

TEST(CompetitionParameters, InfluenceIsATableOfAllPairsOrEmpty) {
  CompetitionParameters parameters;
  parameters.species.resize(2);
  parameters.influence_above.assign(4, Influence::helps);
  EXPECT_EQ(complaint(parameters), "none");
  parameters.influence_below.assign(2, Influence::none);
  EXPECT_EQ(complaint(parameters),
            "influence.below has 2 entries; give one for each of 2 x 2 species, or none");
  parameters.influence_below.assign(4, Influence::none);
  EXPECT_EQ(complaint(parameters), "none");
  parameters.influence_above[3] = static_cast<Influence>(2);
  EXPECT_THAT(complaint(parameters), StartsWith("influence.above has an entry that"));
}

}  // namespace
}  // namespace phytobench
