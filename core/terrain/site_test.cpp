// SPDX-License-Identifier: MIT
#include "core/terrain/site.hpp"

#include <cmath>
#include <fstream>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/contract/errors.hpp"
#include "core/terrain/site_file.hpp"

namespace phytobench {
namespace {

using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

/// A folder with s.toml and what it names.
class SiteLoading : public testing::Test {
 protected:
  SiteLoading() { std::filesystem::create_directories(folder_); }
  ~SiteLoading() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  void write(const std::string& name, const std::string& text) const {
    std::ofstream(folder_ / name) << text;
  }

  Site load(const std::string& text, const std::vector<std::string>& grow = {}) const {
    constexpr const char* entries =
        "entries = []\n[climate]\nbiome = \"Zone\"\n[[biome]]\nname = \"Zone\"\nabsorption = 20\n"
        "diffusion = 5\nclouds = 25\nrain = 3\ngroundwater = 2\n[[soil]]\nname = \"Earth\"\nid = "
        "7\nalbedo = 0.2\nwater_absorption = 0.5\n[[soil]]\nname = \"Rock\"\nid = 9\nalbedo = 0.3\n"
        "water_absorption = 0.1\n[[species]]\nname = \"Oak\"\nenergy_demand = 2000\n"
        "water_demand = 0.7\nsoil = \"Earth\"\nsoil_depth = 80\n[[species]]\nname = \"Weed\"\n"
        "energy_demand = 0\nwater_demand = 0\nsoil = \"\"\nsoil_depth = 0\n";
    return load_site(parse_site(entries + text, folder_ / "s.toml", {}), grow);
  }

  std::string refusal(const std::string& text, const std::vector<std::string>& grow = {}) const {
    try {
      load(text, grow);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("site_" + std::to_string(::getpid()));
};

const std::string heights_of_csv = "[heights]\nfile = \"h.csv\"\ncell_width = 10\n";

TEST_F(SiteLoading, PosterisesHeights) {
  write("h.csv", "0,10\n20,nan\n");
  const Site site = load(heights_of_csv + "[ground]\nposterise = [\"Rock\", \"Earth\"]\n");
  EXPECT_EQ(site.input.heights.columns(), 2);
  EXPECT_EQ(site.input.heights.cell_depth(), 10.0);
  EXPECT_EQ(site.input.soil_of, (std::vector<std::int16_t>{1, 0, 0, -1}));
  EXPECT_EQ(site.species.size(), 2u);
  EXPECT_EQ(site.soilless_share, 0.0);
}

TEST_F(SiteLoading, ReadsAMapOfSoils) {
  write("h.csv", "0,10\n20,30\n");
  write("soil.csv", "7,9\n9,nan\n");
  const Site site = load(heights_of_csv + "[ground]\nfile = \"soil.csv\"\n");
  EXPECT_EQ(site.input.soil_of, (std::vector<std::int16_t>{0, 1, 1, -1}));
  EXPECT_EQ(site.soilless_share, 0.25);
}

TEST_F(SiteLoading, MapsThatDoNotFitAreRefused) {
  write("h.csv", "0,10\n20,30\n");
  write("soil.csv", "7,9\n9,8\n");
  const std::string ground = "[ground]\nfile = \"soil.csv\"\n";
  EXPECT_THAT(refusal(heights_of_csv + ground),
              AllOf(HasSubstr("s.toml:37: ground.file: "),
                    HasSubstr("has soil 8 at 1 places, the first in row 2, column 2"),
                    HasSubstr("7 Earth, 9 Rock")));
  write("soil.csv", "7,9,9\n");
  EXPECT_THAT(refusal(heights_of_csv + ground),
              HasSubstr("has 3 columns and 1 rows, and the heights 2 and 2"));
  write("soil.csv", "nan,nan\nnan,nan\n");
  EXPECT_THAT(refusal(heights_of_csv + ground), HasSubstr("s.toml:37: "));
  EXPECT_THAT(refusal(heights_of_csv + ground +
                      "[[soil]]\nname = \"Third\"\nid = 7\nalbedo = 0\nwater_absorption = 0\n"),
              HasSubstr("soils 'Third' and 'Earth'"));
}

TEST_F(SiteLoading, SoilsOfOtherGroundAreRefused) {
  const auto grid = [](const std::string& west, const std::string& rows) {
    return "ncols 2\nnrows 2\nxllcorner " + west + "\nyllcorner 50\ncellsize 10\n" + rows;
  };
  const std::string maps = "[heights]\nfile = \"h.asc\"\n[ground]\nfile = \"soil.asc\"\n";
  write("h.asc", grid("100", "0 10\n20 30\n"));
  write("soil.asc", grid("100", "7 9\n9 7\n"));
  EXPECT_EQ(refusal(maps), "accepted");
  write("soil.asc", grid("120", "7 9\n9 7\n"));
  EXPECT_THAT(refusal(maps),
              AllOf(HasSubstr("s.toml:36: ground.file: "), HasSubstr("soil.asc: reaches from 120"),
                    HasSubstr("h.asc from 100, 50 to 120, 70")));
  // A picture does not say where it lies, nor what terrain is made.
  write("soil.csv", "7,9\n9,7\n");
  EXPECT_EQ(refusal("[heights]\nfile = \"h.asc\"\n[ground]\nfile = \"soil.csv\"\n"), "accepted");
  EXPECT_EQ(refusal("[heights]\nmade = \"flat\"\ncolumns = 2\nrows = 2\n[ground]\nfile = "
                    "\"soil.asc\"\n"),
            "accepted");
}

TEST_F(SiteLoading, HeightsThatCannotBeReadAreNamedWithTheirKey) {
  const std::string ground = "[ground]\nsoil = \"Earth\"\n";
  EXPECT_THAT(refusal(heights_of_csv + ground),
              AllOf(HasSubstr("s.toml:34: heights.file: "), HasSubstr("h.csv")));
  write("h.csv", "nan,nan\n");
  EXPECT_THAT(refusal(heights_of_csv + ground), HasSubstr("s.toml:34: heights.file: "));
  write("h.csv", "1,2\n3\n");
  EXPECT_THAT(refusal(heights_of_csv + ground), HasSubstr("h.csv:2"));
}

TEST_F(SiteLoading, MapsOfOneRowOrColumnAreRefused) {
  const std::string ground = "[ground]\nsoil = \"Earth\"\n";
  for (const auto& [text, size] :
       {std::pair{"7\n", "1 columns and 1 rows"}, std::pair{"1,2,3\n", "3 columns and 1 rows"},
        std::pair{"1\n2\n", "1 columns and 2 rows"}}) {
    write("h.csv", text);
    EXPECT_THAT(refusal(heights_of_csv + ground),
                AllOf(HasSubstr("s.toml:34: "), HasSubstr("h.csv: has "), HasSubstr(size),
                      HasSubstr("give at least 2 of each")));
  }
  write("h.csv", "1,2\n3,4\n");
  EXPECT_EQ(refusal(heights_of_csv + ground), "accepted");
  EXPECT_THAT(refusal("[heights]\nmade = \"flat\"\ncolumns = 3\nrows = 1\n" + ground),
              AllOf(HasSubstr("s.toml:36: heights.rows"), HasSubstr(">= 2")));
}

TEST_F(SiteLoading, MixedUnitsAreRefused) {
  write("h.csv", "0,10\n20,800\n");
  const std::string ground = "[ground]\nsoil = \"Earth\"\n";
  EXPECT_THAT(refusal("[heights]\nfile = \"h.csv\"\ncell_width = 0.01\n" + ground),
              HasSubstr("units seem to be mixed"));
  EXPECT_THAT(refusal(heights_of_csv + "conversion = 100\n" + ground),
              HasSubstr("more than Earth has; give heights.conversion"));
  EXPECT_EQ(refusal("[heights]\nfile = \"h.csv\"\ncell_width = 100\n" + ground), "accepted");
}

TEST_F(SiteLoading, ChoosesSpecies) {
  const std::string flat =
      "[heights]\nmade = \"flat\"\ncolumns = 3\nrows = 2\n[ground]\nsoil = "
      "\"Rock\"\n";
  EXPECT_EQ(load(flat, {"Weed", "Weed"}).species.size(), 1u);
  EXPECT_EQ(load(flat, {"Weed"}).species[0].entry.name, "Weed");
  EXPECT_THAT(refusal(flat, {"Wed"}), HasSubstr("--species: there is no species 'Wed'; did you "
                                                "mean 'Weed'?"));
  EXPECT_THAT(refusal(flat + "[[species]]\nname = \"Lost\"\nenergy_demand = 0\nwater_demand = 0\n"
                             "soil = \"Sea\"\nsoil_depth = 0\n"),
              HasSubstr("species 'Lost' grows on soil 'Sea', which has no entry"));
}

TEST_F(SiteLoading, EveryFormCanBeMade) {
  for (const char* form : {"fractal", "diamond-square", "flat", "plane", "ridge", "valley", "cone",
                           "hemisphere", "ring-wall", "needle"}) {
    const bool is_wall = std::string(form) == "ring-wall";  // usually wider than this map
    const Site site = load("[heights]\nmade = \"" + std::string(form) + "\"\n" +
                           (is_wall ? "radius = 100\n" : "") +
                           "columns = 33\nrows = 33\n[ground]\nsoil = \"Earth\"\n");
    EXPECT_EQ(site.input.heights.cell_width(), 16.0) << form;
    const HeightRange range = height_range(site.input.heights);
    EXPECT_EQ(range.highest > range.lowest, std::string(form) != "flat") << form;
  }
}

constexpr const char* one_of_each =
    "[[biome]]\nname = \"Z\"\nabsorption = 20\ndiffusion = 5\nclouds = 25\nrain = 3\n"
    "groundwater = 2\n[[soil]]\nname = \"E\"\nid = 7\nalbedo = 0.2\nwater_absorption = 0.5\n"
    "[[species]]\nname = \"W\"\nenergy_demand = 0\nwater_demand = 0\nsoil = \"\"\n"
    "soil_depth = 0\n";

SiteDescription flat_site_with(const std::string& sun) {
  return parse_site(
      "entries = []\nheights.made = \"flat\"\nground.soil = \"E\"\nclimate.biome = \"Z\"\n" + sun +
          "\n" + one_of_each,
      "s.toml", {});
}

TEST_F(SiteLoading, TheSunHasADirectionForEveryHour) {
  const SiteDescription site = flat_site_with("sun.hours = 7");
  SiteOptions options{.hours_each = 0.5};
  set_sun(options, site, *corrected_site_model());
  EXPECT_EQ(options.suns.size(), 7u);
  EXPECT_EQ(options.hours_each, 1.0);
}

// What a day brings does not depend on how many parts it is cut into.
TEST_F(SiteLoading, PartsOfATrueDayCountAsLongAsTheyAre) {
  if (!can_place_the_sun()) GTEST_SKIP() << "built without libnova";
  const auto model = corrected_site_model();
  std::vector<double> brought;
  for (const char* parts : {"12", "24", "240"}) {
    const SiteDescription site =
        flat_site_with(std::string("sun.kind = \"solar\"\nsun.latitude = 51\nsun.longitude = "
                                   "7\nsun.date = 2019-06-21\nsun.hours = ") +
                       parts);
    SiteOptions options;
    set_sun(options, site, *model);
    EXPECT_NEAR(options.hours_each * static_cast<double>(options.suns.size()),
                daylight_hours(site.sun.day), 1e-9);
    double sum = 0.0;
    for (const SunDirection& sun : options.suns) sum += sun.up;
    brought.push_back(sum * options.hours_each);
  }
  EXPECT_NEAR(brought[0], brought[2], 0.01 * brought[2]);
  EXPECT_NEAR(brought[1], brought[2], 0.003 * brought[2]);
}

}  // namespace
}  // namespace phytobench
