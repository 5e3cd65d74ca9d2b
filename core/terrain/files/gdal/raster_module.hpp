// SPDX-License-Identifier: MIT
// Between the program and the module that reads and writes maps through GDAL: plain structs and
// functions only. The program is not linked to GDAL, since 114 shared libraries would be loaded
// with it at every start; it opens the module when a file needs it.
#pragma once

#include <cstddef>
#include <cstdint>

namespace phytobench {

inline constexpr const char* raster_module_file = "phytobench_gdal.so";
inline constexpr const char* raster_module_entry = "phytobench_raster_module";
/// Counts changes of this file: program and module must agree.
inline constexpr std::int32_t raster_module_version = 1;

/// Why something failed: one line.
struct RasterMessage {
  char text[400];
};

struct RasterDescription {
  std::int32_t columns, rows, bands;
  bool has_transform;
  double transform[6];  ///< GDAL's: x = t0 + t1 column + t2 row, y = t3 + t4 column + t5 row
  bool is_geographic;   ///< in degrees
  bool is_projected;    ///< in lengths of metres_per_unit
  double metres_per_unit;
  bool has_palette;
  const char* projection;   ///< well-known text; these three live until the raster is closed
  const char* driver;       ///< name of the format
  const char* height_unit;  ///< of the first band
};

struct RasterToWrite {
  std::int32_t columns, rows;
  const double* values;  ///< NaN where there is no data
  double transform[6];
  const char* projection;  ///< empty: none
};

struct RasterModule {
  std::int32_t version;
  /// "GDAL 3.6.2".
  const char* (*library)();
  /// Null with a message if it cannot be opened.
  void* (*open)(const char* file, RasterDescription*, RasterMessage*);
  /// The first band in the file's order of rows, scaled as the file says; NaN without data.
  bool (*read)(void* raster, double* values, RasterMessage*);
  void (*close)(void* raster);
  /// Hands the bytes of a GeoTIFF over, in one piece.
  bool (*to_geotiff)(const RasterToWrite&, void* receiver,
                     void (*take)(void* receiver, const void* bytes, std::size_t size),
                     RasterMessage*);
};

using RasterModuleEntry = const RasterModule* (*)();

}  // namespace phytobench
