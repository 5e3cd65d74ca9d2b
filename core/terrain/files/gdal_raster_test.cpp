// SPDX-License-Identifier: MIT
// Files as other programs write them, read through GDAL's module, and GeoTIFF there and back.
#include "core/terrain/files/gdal_raster.hpp"

#include <cmath>
#include <cstring>
#include <vector>

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/picture/grey_image.hpp"
#include "core/terrain/files/coordinate_unit.hpp"
#include "core/terrain/files/map_files.hpp"
#include "core/terrain/files/test_folder.hpp"
#include "core/terrain/made/fractal_terrain.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;
using testing::ElementsAre;
using testing::HasSubstr;

const std::string geographic =
    "GEOGCS[\"WGS 84\",DATUM[\"WGS_1984\",SPHEROID[\"WGS 84\",6378137,298.257223563]],"
    "PRIMEM[\"Greenwich\",0],UNIT[\"degree\",0.0174532925199433]]";

/// A Mercator projection whose lengths are counted in units of so many metres.
std::string projected(const std::string& unit, double metres) {
  return fmt::format(
      "PROJCS[\"flat\",{},PROJECTION[\"Mercator_1SP\"],PARAMETER[\"central_meridian\",0],"
      "PARAMETER[\"scale_factor\",1],PARAMETER[\"false_easting\",0],"
      "PARAMETER[\"false_northing\",0],UNIT[\"{}\",{}]]",
      geographic, unit, metres);
}

class GdalRaster : public TestFolder {
 protected:
  /// As ESRI writes maps in binary: 3 columns, 2 rows, 32 bits each, and a header.
  fs::path binary_map(const std::vector<float>& values, const std::string& projection,
                      double step) const {
    std::string bytes(values.size() * sizeof(float), '\0');
    std::memcpy(bytes.data(), values.data(), bytes.size());
    written("map.hdr", fmt::format("NROWS 2\nNCOLS 3\nNBANDS 1\nNBITS 32\nPIXELTYPE FLOAT\n"
                                   "BYTEORDER I\nLAYOUT BIL\nULXMAP {}\nULYMAP {}\nXDIM {}\n"
                                   "YDIM {}\nNODATA -9999\n",
                                   10.0 + step / 2.0, 50.0 - step, step, 2.0 * step));
    if (!projection.empty()) written("map.prj", projection);
    return written("map.bil", bytes);
  }

  /// GDAL's own description of a map, with an inside. Without sources all its numbers are 0.
  fs::path described_map(int columns, int rows, const std::string& inside,
                         const std::string& kind = "Float64") const {
    return written("map.vrt",
                   fmt::format("<VRTDataset rasterXSize=\"{}\" rasterYSize=\"{}\"><GeoTransform>0, "
                               "10, 0, 100, 0, -10</GeoTransform><VRTRasterBand dataType=\"{}\" "
                               "band=\"1\">{}</VRTRasterBand></VRTDataset>",
                               columns, rows, kind, inside));
  }

  std::string gdal_error(const fs::path& file, const HeightFileOptions& options = {}) const {
    return input_error_of([&] { read_height_file(file, options); });
  }
};

TEST_F(GdalRaster, IsThere) {
  EXPECT_THAT(map_reader_name(), testing::StartsWith("GDAL 3"));
}

TEST_F(GdalRaster, ReadsNumbersNoDataAndPlace) {
  const HeightFile file =
      read_height_file(binary_map({1, 2, 3, 4, -9999, 6.5}, projected("metre", 1.0), 20.0), {});
  EXPECT_EQ(file.field.columns(), 3);
  EXPECT_EQ(file.field.rows(), 2);
  EXPECT_EQ(file.field.at(2, 0), 3.0);
  EXPECT_EQ(file.field.at(2, 1), 6.5);
  EXPECT_FALSE(file.field.has_data(1, 1));
  EXPECT_NEAR(file.field.cell_width(), 20.0, 1e-12);
  EXPECT_NEAR(file.field.cell_depth(), 40.0, 1e-12);
  ASSERT_TRUE(file.place);
  EXPECT_NEAR(file.place->west, 10.0, 1e-12);
  EXPECT_NEAR(file.place->north, 50.0, 1e-12);
  EXPECT_THAT(file.place->projection, HasSubstr("Mercator"));
  EXPECT_THAT(file.format, HasSubstr("ESRI"));
}

TEST_F(GdalRaster, TurnsDegreesAndFeetIntoMetres) {
  const HeightFile degrees = read_height_file(binary_map({1, 2, 3, 4, 5, 6}, geographic, 0.01), {});
  const DegreeLength degree = degree_length(49.98);
  EXPECT_NEAR(degrees.field.cell_width(), 0.01 * degree.east, 1e-6);
  EXPECT_NEAR(degrees.field.cell_depth(), 0.02 * degree.north, 1e-6);
  const HeightFile feet =
      read_height_file(binary_map({1, 2, 3, 4, 5, 6}, projected("foot", 0.3048), 10.0), {});
  EXPECT_NEAR(feet.field.cell_width(), 3.048, 1e-12);
  EXPECT_EQ(feet.field.at(0, 0), 1.0) << "heights are another matter";
}

TEST_F(GdalRaster, RefusesHeightsInFeetUnlessToldHowLongTheyAre) {
  const fs::path file = described_map(2, 2, "<UnitType>ft</UnitType>");
  EXPECT_THAT(gdal_error(file), HasSubstr("its heights are in 'ft', not in metres; set "
                                          "height_conversion"));
  EXPECT_EQ(gdal_error(file, {.height_conversion = 0.3048}), "no error");
  EXPECT_EQ(gdal_error(described_map(2, 2, "<UnitType>m</UnitType>")), "no error");
}

TEST_F(GdalRaster, ScalesAsTheFileSays) {
  EXPECT_EQ(read_height_file(described_map(2, 2, "<Offset>150</Offset><Scale>0.5</Scale>"), {})
                .field.at(1, 1),
            150.0);
}

// A tile of the shuttle mission: 1201 x 1201 numbers of 16 bits, the higher byte first; its name
// is its place.
TEST_F(GdalRaster, ReadsTilesOfTheShuttleMission) {
  std::string bytes;
  for (int row = 0; row < 1201; ++row)
    for (int column = 0; column < 1201; ++column) {
      const int height = row == 7 && column == 9 ? -32768 : row + column;
      bytes += static_cast<char>(height >> 8 & 0xff);
      bytes += static_cast<char>(height & 0xff);
    }
  const HeightFile file = read_height_file(written("N47E012.hgt", bytes), {});
  EXPECT_EQ(file.field.columns(), 1201);
  EXPECT_EQ(file.field.at(1200, 3), 1203.0);
  EXPECT_FALSE(file.field.has_data(9, 7)) << "a void";
  const DegreeLength degree = degree_length(47.5);
  EXPECT_NEAR(file.field.cell_width(), degree.east / 1200.0, 1e-6);
  EXPECT_NEAR(file.field.cell_depth(), degree.north / 1200.0, 1e-6);
}

TEST_F(GdalRaster, MapsFromTheSouthAreTurnedAround) {
  const fs::path upward =
      written("map.vrt",
              "<VRTDataset rasterXSize=\"1\" rasterYSize=\"3\"><GeoTransform>0, 10, 0, 100, 0, "
              "10</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\"><SimpleSource>"
              "<SourceFilename relativeToVRT=\"1\">map.pgm</SourceFilename></SimpleSource>"
              "</VRTRasterBand></VRTDataset>");
  written("map.pgm", "P5 1 3 255\n\x01\x02\x03");
  const HeightFile file = read_height_file(upward, {});
  EXPECT_EQ(file.field.at(0, 0), 3.0);
  EXPECT_EQ(file.field.at(0, 2), 1.0);
  EXPECT_EQ(file.place->north, 130.0);
  EXPECT_EQ(file.place->row_step, -10.0);
}

TEST_F(GdalRaster, RefusesWhatIsNoMapOfHeights) {
  EXPECT_THAT(gdal_error(written("a.tif", "no picture")), HasSubstr("a.tif: is no map that GDAL"));
  EXPECT_THAT(gdal_error(written("b.ppm", "P6 1 1 255\n\x01\x02\x03"), {.cell_width = 1.0}),
              HasSubstr("has 3 bands where a map has one"));
  EXPECT_THAT(gdal_error(described_map(20000, 20000, "")), HasSubstr("20000 x 20000 vertices"));
  const std::string table = "<ColorTable><Entry c1=\"1\" c2=\"2\" c3=\"3\"/></ColorTable>";
  const fs::path colours = described_map(1, 1, table, "Byte");
  EXPECT_THAT(gdal_error(colours), HasSubstr("holds numbers of colours"));
  EXPECT_THAT(read_number_map(colours).numbers, ElementsAre(0)) << "which are ids, too";
  const fs::path turned =
      written("c.vrt",
              "<VRTDataset rasterXSize=\"1\" rasterYSize=\"1\"><GeoTransform>0, 10, 3, 100, 3, "
              "-10</GeoTransform><VRTRasterBand dataType=\"Byte\" band=\"1\"/></VRTDataset>");
  EXPECT_THAT(gdal_error(turned), HasSubstr("do not run from west to east"));
  EXPECT_THAT(gdal_error(written("d.pgm", "P5 1 1 255\n\x01")),
              HasSubstr("how wide its cells are"));
  EXPECT_THAT(gdal_error(described_map(2, 2, "<NoDataValue>0</NoDataValue>")),
              HasSubstr("no vertex has data"));
}

TEST_F(GdalRaster, RefusesWhatIsCutOff) {
  const HeightField field = noise_terrain({.columns = 200, .rows = 200}, {});
  const std::string bytes = to_geotiff(map_view(field, field.heights(), {}));
  const fs::path file = written("a.tif", std::string_view(bytes).substr(0, bytes.size() / 2));
  EXPECT_THAT(gdal_error(file), HasSubstr("a.tif: "));
  EXPECT_THAT(gdal_error(file), HasSubstr("is it cut off?"));
  EXPECT_THAT(gdal_error(file), testing::Not(HasSubstr("\n")));
}

TEST_F(GdalRaster, LeavesNothingBeside) {
  read_height_file(written("a.pgm", "P5 2 1 255\n\x01\x02"), {.cell_width = 1.0});
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 1);
}

// 16 bits through a reader that is not the writer's.
TEST_F(GdalRaster, ReadsOurOwnPictures) {
  const GreyImage image{.width = 2, .height = 3, .bits = 16, .levels = {0, 1, 256, 4000, 65535, 7}};
  const Raster raster = read_gdal_raster(written("a.png", to_png(image)));
  EXPECT_EQ(raster.columns, 2);
  EXPECT_THAT(raster.values, ElementsAre(0.0, 1.0, 256.0, 4000.0, 65535.0, 7.0));
}

TEST_F(GdalRaster, ReadsOurOwnAsciiGrids) {
  HeightField field =
      noise_terrain({.columns = 20, .rows = 10, .cell_width = 3.0, .cell_depth = 4.0}, {});
  field.at(3, 3) = HeightField::no_data;
  const Raster raster =
      read_gdal_raster(written("a.asc", to_ascii_grid(map_view(field, field.heights(), {}))));
  EXPECT_EQ(raster.place->column_step, 3.0);
  EXPECT_EQ(raster.place->row_step, -4.0);
  EXPECT_EQ(raster.place->north, 40.0);
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (std::isnan(field.heights()[i]))
      EXPECT_TRUE(std::isnan(raster.values[i]));
    else
      // GDAL keeps such numbers in 32 bits.
      EXPECT_NEAR(raster.values[i], field.heights()[i], 1e-7 * 400.0) << i;
  }
}

class GeoTiff : public GdalRaster {};

TEST_F(GeoTiff, ComesBackWithAllBitsNoDataAndPlace) {
  HeightField field = noise_terrain({.columns = 301, .rows = 77}, {});
  field.at(0, 0) = field.at(300, 76) = HeightField::no_data;
  const GeoReference place{.west = 12.5,
                           .north = 47.75,
                           .column_step = 1.0 / 1200.0,
                           .row_step = -1.0 / 3600.0,
                           .projection = geographic};
  write_files_atomically(map_files(folder_ / "map.tif", map_view(field, field.heights(), place)));
  EXPECT_EQ(std::distance(fs::directory_iterator(folder_), fs::directory_iterator{}), 1);
  const HeightFile read = read_height_file(folder_ / "map.tif", {});
  EXPECT_EQ(read.format, "GeoTIFF");
  ASSERT_EQ(read.field.size(), field.size());
  for (std::size_t i = 0; i < field.size(); ++i) {
    if (std::isnan(field.heights()[i]))
      EXPECT_TRUE(std::isnan(read.field.heights()[i])) << i;
    else
      EXPECT_EQ(read.field.heights()[i], field.heights()[i]) << i;
  }
  ASSERT_TRUE(read.place);
  EXPECT_DOUBLE_EQ(read.place->west, place.west);
  EXPECT_DOUBLE_EQ(read.place->north, place.north);
  EXPECT_DOUBLE_EQ(read.place->column_step, place.column_step);
  EXPECT_DOUBLE_EQ(read.place->row_step, place.row_step);
  EXPECT_THAT(read.place->projection, HasSubstr("WGS 84"));
  EXPECT_GT(read.field.cell_width(), 60.0) << "degrees";
}

TEST_F(GeoTiff, WithoutAPlaceItKeepsTheCellsInMetres) {
  const HeightField field =
      noise_terrain({.columns = 5, .rows = 4, .cell_width = 0.03, .cell_depth = 0.04}, {});
  const MapView map = map_view(field, field.heights(), {});
  const std::string bytes = to_geotiff(map);
  EXPECT_EQ(to_geotiff(map), bytes) << "the same bytes each time";
  const HeightFile read = read_height_file(written("map.tif", bytes), {});
  EXPECT_DOUBLE_EQ(read.field.cell_width(), 0.03);
  EXPECT_DOUBLE_EQ(read.field.cell_depth(), 0.04);
}

TEST_F(GeoTiff, RefusesProjectionsThatAreNone) {
  const HeightField field(2, 2, 1.0, 1.0);
  const GeoReference place{.projection = "PROJCS[nonsense"};
  EXPECT_THAT(input_error_of([&] { to_geotiff(map_view(field, field.heights(), place)); }),
              HasSubstr("cannot be written as GeoTIFF ("));
}

}  // namespace
}  // namespace phytobench
