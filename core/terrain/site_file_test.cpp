// SPDX-License-Identifier: MIT
#include "core/terrain/site_file.hpp"

#include <fstream>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "core/contract/errors.hpp"
#include "core/terrain/site_keys.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

/// Entries for files that name "mine" as their only entries.
class SiteFile : public testing::Test {
 protected:
  SiteFile() {
    std::filesystem::create_directories(folder_);
    std::ofstream(folder_ / "mine.toml")
        << "[[biome]]\nname = \"Zone\"\nabsorption = 20.0\ndiffusion = 5.0\nclouds = 25.0\nrain = "
           "3.0\ngroundwater = 2.0\nsource = \"mine\"\n[[soil]]\nname = \"Earth\"\nid = 7\nalbedo "
           "= 0.2\nwater_absorption = 0.5\n[[soil]]\nname = \"Rock\"\nid = 9\nalbedo = 0.3\n"
           "water_absorption = 0.1\n[[species]]\nname = \"Oak\"\nenergy_demand = 2000\n"
           "water_demand = 0.7\nsoil = \"Earth\"\nsoil_depth = 80\n";
  }
  ~SiteFile() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }

  SiteDescription parse(const std::string& text) const {
    return parse_site(text, "s.toml", [this](const std::string& name) {
      if (name != "mine" && name != "lesser2019" && name != "assumed")
        throw InputError("no entries '" + name + "'");
      return folder_ / "mine.toml";
    });
  }

  std::string refusal(const std::string& text) const {
    try {
      parse(text);
    } catch (const InputError& error) {
      return error.what();
    }
    return "accepted";
  }

  std::filesystem::path folder_ =
      std::filesystem::path(testing::TempDir()) / ("site_file_" + std::to_string(::getpid()));
};

/// Line 1 to 6: a site that lacks nothing.
const std::string whole_site =
    "heights.made = \"flat\"\nground.soil = \"Earth\"\nclimate.biome = \"Zone\"\n"
    "entries = [\"mine\"]\n";

TEST_F(SiteFile, ReadsEverySection) {
  const SiteDescription read = parse(
      "entries = [\"mine\"]\ngrow = [\"Oak\"]\n[heights]\nmade = \"cone\"\ncolumns = 12\nrows = 9\n"
      "cell_width = 5\nslope = 40.0\nradius = 20\n[ground]\nposterise = [\"Earth\", \"Rock\"]\n"
      "max_depth = 90\n[climate]\nbiome = \"Zone\"\nneighbour_share = 0.2\n[sun]\nhours = 12\n"
      "max_elevation = 60.0\neven_hours = \"tent\"\n[model]\nengine = \"exact_traversal\"\ncosine "
      "= false\nsurface = \"six-faces\"\ndepth_tolerance = \"triangle\"\n");
  EXPECT_EQ(read.grow, std::vector<std::string>{"Oak"});
  EXPECT_EQ(read.heights.made, MadeTerrain::cone);
  EXPECT_EQ(read.heights.columns, 12);
  EXPECT_EQ(read.heights.cell_width, 5.0);
  EXPECT_FALSE(read.heights.cell_depth.has_value());
  EXPECT_EQ(read.heights.slope_degrees, 40.0);
  EXPECT_EQ(read.ground.posterise.size(), 2u);
  EXPECT_DOUBLE_EQ(read.ground.max_depth.value(), 0.9);
  EXPECT_EQ(read.neighbour_share, 0.2);
  EXPECT_EQ(read.sun.hourly.hours, 12);
  EXPECT_EQ(read.sun.hourly.max_elevation, 60.0);
  EXPECT_EQ(read.sun.hourly.even_hours, EvenHours::tent);
  EXPECT_EQ(read.choices.engine, "exact_traversal");
  EXPECT_FALSE(read.choices.options.cosine);
  EXPECT_EQ(read.choices.surface, SurfaceEstimator::six_faces);
  EXPECT_EQ(read.choices.depth_tolerance, Tolerance::triangle);
}

TEST_F(SiteFile, ReadsEntriesAndWhereTheyAreFrom) {
  const SiteDescription read = parse(whole_site);
  ASSERT_EQ(read.biomes.size(), 1u);
  EXPECT_EQ(read.biomes[0].source, "mine");
  EXPECT_THAT(read.biomes[0].place, testing::EndsWith("mine.toml:1"));
  EXPECT_EQ(read.biomes[0].entry.cloud_percent, 25.0);
  ASSERT_EQ(read.soils.size(), 2u);
  EXPECT_EQ(read.soils[1].entry.id, 9);
  ASSERT_EQ(read.species.size(), 1u);
  EXPECT_DOUBLE_EQ(read.species[0].entry.soil_depth.value(), 0.8);
  EXPECT_EQ(read.species[0].entry.energy_demand.value(), 2000.0);
  EXPECT_EQ(read.species[0].entry.spacing, 1.0);
}

TEST_F(SiteFile, ItsOwnEntriesComeFirst) {
  const SiteDescription read = parse(
      whole_site + "[[soil]]\nname = \"Earth\"\nid = 1\nalbedo = 0.5\nwater_absorption = 0.5\n");
  ASSERT_EQ(read.soils.size(), 3u);
  EXPECT_EQ(read.soils[0].entry.id, 1);
  EXPECT_EQ(read.soils[0].place, "s.toml:5");
}

TEST_F(SiteFile, ReadsTheTrueSunOfADay) {
  const SiteDescription read =
      parse(whole_site +
            "[sun]\nkind = \"solar\"\nlatitude = 36.5\nlongitude = -84\ndate = 2024-02-29\n");
  EXPECT_TRUE(read.sun.is_solar);
  EXPECT_EQ(read.sun.day.latitude, 36.5);
  EXPECT_EQ(read.sun.day.month, 2);
  EXPECT_EQ(read.sun.day.day, 29);
  EXPECT_FALSE(read.sun.hours.has_value());
}

TEST_F(SiteFile, TheExampleHasTheDefaultsAndEveryKey) {
  const std::string text = example_site_file();
  for (const SiteKey& key : site_keys())
    EXPECT_THAT(text, HasSubstr("\n" + std::string(key.shown_as_comment ? "# " : "") +
                                std::string(short_name_of(key.name)) + " = "));
  // Names of entries that come with the program, but of these here.
  std::string own = text;
  for (const auto& [from, to] : {std::pair<std::string, std::string>{"PolarZone", "Zone"},
                                 {"\"Dirt\", \"Stone\"", "\"Earth\", \"Rock\""},
                                 {"soil = \"Dirt\"", "soil = \"Earth\""}})
    for (std::size_t at = own.find(from); at != std::string::npos; at = own.find(from))
      own.replace(at, from.size(), to);
  const SiteDescription read = parse(own), usual = parse(whole_site);
  EXPECT_EQ(read.entry_files, SiteDescription().entry_files);
  EXPECT_EQ(read.heights.columns, usual.heights.columns);
  EXPECT_EQ(read.heights.relief, usual.heights.relief);
  EXPECT_EQ(read.heights.roughness, usual.heights.roughness);
  EXPECT_EQ(read.heights.seed, usual.heights.seed);
  EXPECT_EQ(read.ground.max_depth, usual.ground.max_depth);
  EXPECT_EQ(read.neighbour_share, usual.neighbour_share);
  EXPECT_EQ(read.sun.hourly.hours, usual.sun.hourly.hours);
  EXPECT_EQ(read.sun.hourly.max_elevation, usual.sun.hourly.max_elevation);
  EXPECT_EQ(read.sun.hourly.start_azimuth, usual.sun.hourly.start_azimuth);
  EXPECT_EQ(read.choices.engine, usual.choices.engine);
  EXPECT_EQ(read.choices.options.cosine, usual.choices.options.cosine);
  EXPECT_EQ(read.choices.options.reflected_is_absorbed,
            usual.choices.options.reflected_is_absorbed);
  EXPECT_EQ(read.choices.depth_tolerance, usual.choices.depth_tolerance);
  EXPECT_EQ(read.species[0].entry.spacing, SitePlant().spacing);
  EXPECT_EQ(read.species[0].entry.start_radius, SitePlant().start_radius);
}

TEST_F(SiteFile, KeysAreNamedOnceAndHaveWhatTheExampleShows) {
  std::set<std::string_view> names;
  for (const SiteKey& key : site_keys()) {
    EXPECT_TRUE(names.insert(key.name).second) << key.name;
    EXPECT_FALSE(key.meaning.empty() || key.source.empty() || key.unit.empty()) << key.name;
    EXPECT_FALSE(key.default_text.empty()) << key.name;
  }
}

struct WrongSite {
  std::string text;
  std::string message;  // a part of it
};

TEST_F(SiteFile, EveryWrongValueIsRefusedWithItsPlace) {
  const std::vector<WrongSite> wrong{
      {"ground.max_depth = -1", "ground.max_depth = -1 is not allowed"},
      {"ground.max_depth = nan", "is not allowed"},
      {"ground.maxdepth = 1",
       "did you mean 'ground.max_depth'? (phytobench terrain --example lists all keys)"},
      {"climate.neighbour_share = 1.5", "is not allowed; give a number >= 0 and <= 1"},
      {"heights.columns = 2.5", "whole"},
      {"heights.columns = 0", "is not allowed"},
      {"heights.cell_width = 0", "is not allowed"},
      {"heights.cell_width = \"a\"", "must be a number"},
      {"heights.conversion = 0.1", "heights.conversion is for heights.file; leave it out"},
      {"heights.seed = 1", "is for heights.made = \"fractal\" or \"diamond-square\""},
      {"heights.relief = 1", "is for heights.made"},
      {"ground.file = \"a.png\"", "ground.soil and ground.file set the same"},
      {"sun.hours = 0", "is not allowed"},
      {"sun.max_elevation = 91", "is not allowed"},
      {"sun.even_hours = \"flat\"", "must be one of \"plateau\", \"tent\""},
      {"sun.latitude = 10", "sun.latitude is for sun.kind = \"solar\""},
      {"sun.start_elevation = 91", "is not allowed"},
      {"sun = { start_elevation = 50, max_elevation = 40 }", "the sun is highest at noon"},
      {"sun.kind = \"solar\"", "sun.date is missing"},
      {"sun = { kind = \"solar\", date = 5 }", "must be a date"},
      {"sun = { kind = \"solar\", date = 2019-01-01 }", "sun.latitude is missing"},
      {"sun = { kind = \"solar\", start_azimuth = 1 }", "is for sun.kind = \"hourly\""},
      {"model.engine = \"bounded_swep\"", "did you mean 'bounded_sweep'?"},
      {"model.cosine = 1", "must be true or false"},
      {"grow = []", "grow is empty"},
      {"grow = [\"Oka\"]", "there is no species 'Oka'; did you mean 'Oak'?"},
      {"grow = \"Oak\"", "must be names of species"},
      {"biome = 3", "biome is a list; write [[biome]]"},
      {"model = 3", "model is a section"}};
  for (const WrongSite& one : wrong) {
    const std::string message = refusal(whole_site + one.text);
    EXPECT_THAT(message, StartsWith("s.toml:5: ")) << one.text;
    EXPECT_THAT(message, HasSubstr(one.message)) << one.text;
    EXPECT_EQ(message.find('\n'), std::string::npos) << message;
  }
}

TEST_F(SiteFile, TwoWaysToSayTheSameAreRefused) {
  EXPECT_EQ(refusal(whole_site + "heights.file = \"a.png\""),
            "s.toml:1: heights.file and heights.made set the same; give one of them");
  // Before keys of one of them.
  EXPECT_EQ(refusal("[heights]\nfile = \"h.csv\"\ncolumns = 3\nmade = \"flat\"\n"),
            "s.toml:4: heights.file and heights.made set the same; give one of them");
  EXPECT_EQ(refusal(whole_site + "ground.posterise = [\"Earth\"]"),
            "s.toml:2: ground.posterise and ground.soil set the same; give one of them");
}

TEST_F(SiteFile, WhatIsMissingIsNamed) {
  EXPECT_THAT(refusal(""), HasSubstr("there are no heights"));
  EXPECT_THAT(refusal("heights.made = \"flat\"\n"), HasSubstr("there is no soil"));
  EXPECT_THAT(refusal("heights.made = \"flat\"\nground.soil = \"Earth\"\n"),
              HasSubstr("climate.biome is missing; give one of Zone"));
  EXPECT_THAT(refusal("heights.made = \"flat\"\nground.soil = \"Erath\"\n"),
              HasSubstr("s.toml:2: ground.soil: there is no soil 'Erath'; did you mean 'Earth'?"));
  EXPECT_THAT(refusal("heights.made = \"flat\"\nground.posterise = []\n"), HasSubstr("is empty"));
  EXPECT_THAT(refusal("heights.file = \"\"\n"), HasSubstr("heights.file is empty"));
  EXPECT_THAT(refusal("entries = [\"my\"]\n"), HasSubstr("s.toml:1: entries: no entries 'my'"));
  EXPECT_THAT(refusal("entries = [\"none.toml\"]\n"), HasSubstr("none.toml"));
  EXPECT_THAT(refusal("heights = 3"), HasSubstr("heights is a section"));
  EXPECT_THAT(refusal("nonsense"), HasSubstr("not valid TOML"));
}

std::string with_biome(const std::string& losses) {
  return whole_site + "[[biome]]\nname = \"Other\"\nrain = 1\ngroundwater = 1\n" + losses;
}

TEST_F(SiteFile, EntriesAreChecked) {
  EXPECT_THAT(refusal(with_biome("absorption = 45\ndiffusion = 8\nclouds = 50\n")),
              testing::AllOf(StartsWith("s.toml:5: "),
                             HasSubstr("take 103 percent of the sun's energy; at most 100")));
  EXPECT_THAT(refusal(with_biome("absorption = 0.45\ndiffusion = 0.08\nclouds = 0.4\n")),
              testing::AllOf(StartsWith("s.toml:5: "), HasSubstr("look like shares")));
  EXPECT_EQ(refusal(with_biome("absorption = 0\ndiffusion = 0\nclouds = 0\n")), "accepted");
  EXPECT_THAT(refusal(with_biome("absorption = -1\ndiffusion = 0\nclouds = 0\n")),
              HasSubstr("biome.absorption = -1 is not allowed"));
  EXPECT_THAT(refusal(with_biome("absorption = 10\n")), HasSubstr("biome.diffusion is missing"));
  EXPECT_THAT(
      refusal(whole_site + "[[soil]]\nname = \"a b\"\nid = 1\nalbedo = 0\nwater_absorption = 0\n"),
      HasSubstr("s.toml:6: 'a b' is no name for a soil"));
  EXPECT_THAT(refusal(whole_site + "[[soil]]\nname = \"a\"\nid = 1.5\n"), HasSubstr("whole"));
  EXPECT_THAT(refusal(whole_site + "[[soil]]\nname = \"a\"\nid = 1\nalbedo = 25\n"),
              HasSubstr("soil.albedo = 25 is not allowed; give a number >= 0 and <= 1"));
  const std::string rock = "[[soil]]\nname = \"Own\"\nid = 1\nalbedo = 0\nwater_absorption = 0\n";
  EXPECT_THAT(refusal(whole_site + rock + rock), HasSubstr("a soil 'Own' already, at s.toml:5"));
}

TEST_F(SiteFile, FilesOfEntriesHoldNothingElse) {
  std::ofstream(folder_ / "mine.toml") << "heights.made = \"flat\"\n";
  EXPECT_THAT(refusal(whole_site), HasSubstr("mine.toml:1: 'heights' stands in a file of entries"));
}

}  // namespace
}  // namespace phytobench
