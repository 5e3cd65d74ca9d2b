// SPDX-License-Identifier: MIT
// The terrains that travel with the program, as the readers see them.
#include <gtest/gtest.h>

#include "core/terrain/files/height_file.hpp"
#include "reference/data_folder.hpp"

namespace phytobench {
namespace {

TEST(JacksboroTile, IsAsItsReadmeSays) {
  const HeightFile file =
      read_height_file(data_folder() / "terrains" / "jacksboro_srtm_3arcsec.asc", {});
  EXPECT_EQ(file.field.columns(), 403);
  EXPECT_EQ(file.field.rows(), 344);
  // Of 3 seconds of arc in the middle of the map, printed to the decimetre.
  EXPECT_NEAR(file.field.cell_width(), 74.6, 0.05);
  EXPECT_NEAR(file.field.cell_depth(), 92.5, 0.05);
  const HeightRange range = height_range(file.field);
  EXPECT_EQ(range.lowest, 236.0);
  EXPECT_EQ(range.highest, 1076.0);
  EXPECT_EQ(range.vertices, 403u * 344u);
  EXPECT_EQ(file.field.at(0, 0), 483.0) << "row 0 is the first of the file";
  ASSERT_TRUE(file.place);
  EXPECT_NEAR(file.place->west, -84.41375, 1e-9);
  EXPECT_NEAR(file.place->north, 36.44625 + 344.0 / 1200.0, 1e-6);
}

}  // namespace
}  // namespace phytobench
