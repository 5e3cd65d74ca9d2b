// SPDX-License-Identifier: MIT
#include "core/population/plants_file.hpp"

#include <unistd.h>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;
using testing::Not;
using testing::StartsWith;

/// A fresh file per test, removed with its folder.
class PlantsFile : public testing::Test {
 protected:
  void SetUp() override {
    const testing::TestInfo* test = testing::UnitTest::GetInstance()->current_test_info();
    folder_ = fs::path(testing::TempDir()) /
              (std::string("phytobench-plants-") + test->name() + "-" + std::to_string(::getpid()));
    fs::remove_all(folder_);
    file_ = folder_ / "plants.csv";
    parameters_.ground = {{-10.0, 5.0}, {30.0, 25.0}};
    add_species("red oak", 0.5);
  }
  void TearDown() override { fs::remove_all(folder_); }

  void add_species(const char* name, double largest_radius) {
    Species& species = parameters_.species.emplace_back();
    species.name = name;
    species.largest_radius = largest_radius;
  }
  void add_fern() { add_species("fern", 0.01); }

  std::vector<StartPlant> read(const std::string& text) const {
    write_file_atomically(file_, text);
    return read_plants_file(file_, parameters_);
  }

  /// What is said against a file, behind its name.
  std::string complaint(const std::string& text) const {
    try {
      read(text);
    } catch (const InputError& error) {
      EXPECT_THAT(error.what(), StartsWith(file_.string() + ":"));
      EXPECT_THAT(error.what(), Not(HasSubstr("\n")));
      return std::string(error.what()).substr(file_.string().size());
    }
    return "none";
  }

  fs::path folder_, file_;
  PopulationParameters parameters_;
};

TEST_F(PlantsFile, GivesPlacesSizesAndSpeciesInItsOrder) {
  add_fern();
  const auto plants = read("species,radius,y,x\nfern,0.01,5,-10\nred oak,0.5,25,30\nfern,1e-6,7,0");
  ASSERT_EQ(plants.size(), 3u);
  EXPECT_EQ(plants[0].place, (Point2{-10.0, 5.0}));
  EXPECT_EQ(plants[0].stem_radius, 0.01);
  EXPECT_EQ(plants[0].species, 1);
  EXPECT_EQ(plants[1].place, (Point2{30.0, 25.0}));
  EXPECT_EQ(plants[1].stem_radius, 0.5);
  EXPECT_EQ(plants[1].species, 0);
  EXPECT_EQ(plants[2].stem_radius, 1e-6);
}

TEST_F(PlantsFile, NeedsNoSpeciesIfThereIsOneOnly) {
  const auto plants = read("x,y,radius\n1,10,0.1\n");
  ASSERT_EQ(plants.size(), 1u);
  EXPECT_EQ(plants[0].species, 0);
  EXPECT_EQ(read("x,y,radius,species\n1,10,0.1,red oak\n").size(), 1u);
}

TEST_F(PlantsFile, NeedsSpeciesIfThereAreSeveral) {
  add_fern();
  EXPECT_THAT(complaint("x,y,radius\n1,10,0.1\n"), StartsWith(":1: no column 'species'"));
}

TEST_F(PlantsFile, SpeciesMustBeKnownEvenIfThereIsOneOnly) {
  EXPECT_EQ(complaint("x,y,radius,species\n1,10,0.1,red oka\n"),
            ":2: species = 'red oka' is not in the parameter file; did you mean 'red oak'?");
  EXPECT_EQ(complaint("# a\nx,y,radius,species\n\n1,10,0.1,red oak\n1,10,0.1,*\n"),
            ":5: species = '*' is not in the parameter file");
  EXPECT_THAT(complaint("x,y,radius,species\n1,10,0.1,\n"), StartsWith(":2: species is empty"));
}

TEST_F(PlantsFile, PlantsMustStandOnTheGround) {
  for (const char* place : {"-10.001,10", "30.001,10", "0,4.999", "0,25.001", "1e300,-1e300"})
    EXPECT_THAT(complaint("x,y,radius\n0,10,0.1\n" + std::string(place) + ",0.1\n"),
                HasSubstr("is not on the ground from -10, 5 to 30, 25;"));
  EXPECT_THAT(complaint("x,y,radius\n0,10,0.1\n0,4,0.1\n"), StartsWith(":3: x = 0, y = 4 is not"));
}

TEST_F(PlantsFile, RadiiArePositiveAndAtMostThoseOfTheSpecies) {
  add_fern();
  EXPECT_EQ(
      complaint("x,y,radius,species\n1,10,0.02,red oak\n1,10,0.02,fern\n"),
      ":3: radius = 0.02 is not allowed; give a number >= 1e-09 and <= 0.01, the largest_radius "
      "of species 'fern'");
  for (const char* radius : {"0", "-0.1", "0.50001", "1e300"})
    EXPECT_THAT(complaint("x,y,radius,species\n1,10," + std::string(radius) + ",red oak\n"),
                StartsWith(":2: radius = "));
}

TEST_F(PlantsFile, WhatIsNoTableIsAnInputError) {
  EXPECT_THAT(complaint(""), StartsWith(": is empty"));
  EXPECT_THAT(complaint("x,y,radius\n"), StartsWith(": has a header but no line"));
  EXPECT_THAT(complaint("x,y,r\n1,10,1\n"), StartsWith(":1: no column 'radius'"));
  EXPECT_THAT(complaint("x,y,radius\n1,10,nan\n"), StartsWith(":2: radius = 'nan'"));
  EXPECT_THAT(complaint("x,y,radius\n1,10\n"), StartsWith(":2: 2 fields where"));
  EXPECT_THROW(read_plants_file(folder_ / "none.csv", parameters_), InputError);
}

TEST_F(PlantsFile, MorePlantsThanAllowedAreAnInputError) {
  parameters_.most_plants = 1;
  EXPECT_EQ(complaint("x,y,radius\n1,10,0.1\n"), "none");
  EXPECT_EQ(complaint("x,y,radius\n1,10,0.1\n2,10,0.1\n"), ": has 2 plants; give at most 1");
}

TEST_F(PlantsFile, PlantsCanBeSown) {
  const auto plants = read("x,y,radius\n1,10,0.1\n30,25,0.5\n");
  parameters_.species[0].start_radius_high = parameters_.species[0].start_radius_low;
  const PopulationState state = sow(parameters_, plants);
  EXPECT_EQ(state.stand.size(), 2u);
  EXPECT_EQ(state.stand.stem_radius[1], 0.5);
}

}  // namespace
}  // namespace phytobench
