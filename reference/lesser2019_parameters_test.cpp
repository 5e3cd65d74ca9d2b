// SPDX-License-Identifier: MIT
// The inputs that the thesis prints twice are the same ones, and the literal constants are those of
// the file.
#include <stdexcept>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "reference/data_folder.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"
#include "reference/toml_table.hpp"

namespace phytobench {
namespace {

TomlTable lesser_parameters() {
  return TomlTable::read(paper_folder("lesser2019") / "parameters.toml");
}

TomlTable lesser_entry(const std::string& kind, const std::string& name) {
  for (const TomlTable& table : lesser_parameters().tables(kind))
    if (table.text("name") == name) return table;
  throw std::runtime_error("no " + kind + " " + name);
}

TEST(LesserParameters, TheAppleTreeIsTheSameInBothPlaces) {
  const TomlTable listing = lesser_parameters().table("apple-tree-of-listing-9-6");
  const TomlTable figure = lesser_entry("species", listing.text("name"));
  for (const char* key : {"energy_kcal_per_day", "water_l_per_day", "soil_depth_cm"})
    EXPECT_EQ(figure.number(key), listing.number(key)) << key;
  EXPECT_EQ(figure.text("soil"), listing.text("soil"));
}

TEST(LesserParameters, EverySpeciesAndMapNamesWhatIsThere) {
  for (const TomlTable& species : lesser_parameters().tables("species"))
    if (species.has("soil")) EXPECT_NO_THROW(lesser_entry("soil", species.text("soil")));
  for (const TomlTable& map : lesser_parameters().tables("map"))
    EXPECT_NO_THROW(lesser_entry("biome", map.text("biome")));
  for (const TomlTable& run : lesser_parameters().tables("run"))
    EXPECT_NO_THROW(lesser_entry("species", run.text("species")));
}

TEST(LesserParameters, ConstantsAreThoseOfTheOracles) {
  const TomlTable constants = lesser_parameters().table("constants");
  EXPECT_EQ(constants.number("solar_cal_per_cm2_and_minute") * 10 * 60,
            oracles::lesser2019::SOLAR_CONSTANT_K_CALORIES_PER_HOUR);
  EXPECT_EQ(constants.number("kcal_per_ml"), oracles::lesser2019::PRINTED_KCAL_PER_ML);
}

TEST(LesserParameters, TablesHaveTheirShape) {
  EXPECT_EQ(lesser_parameters().tables("surface").size(), 13u);
  for (const TomlTable& surface : lesser_parameters().tables("surface"))
    for (const char* key : {"emissivity", "albedo"}) {
      EXPECT_GT(surface.number(key), 0.0);
      EXPECT_LT(surface.number(key), 1.0);
    }
  const TomlTable features = lesser_parameters().table("features");
  EXPECT_EQ(features.number_lists("has").size(), features.texts("names").size());
  for (const std::vector<double>& row : features.number_lists("has"))
    EXPECT_EQ(row.size(), features.texts("systems").size());
}

}  // namespace
}  // namespace phytobench
