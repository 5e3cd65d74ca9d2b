// SPDX-License-Identifier: MIT
// A shared library of its own; GDAL is seen in this file alone. No exception leaves it.
#include <cpl_conv.h>
#include <cpl_error.h>
#include <cpl_string.h>
#include <cpl_vsi.h>
#include <gdal.h>
#include <ogr_srs_api.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <cstdio>
#include <limits>
#include <memory>
#include <string>
#include <vector>

#include "core/terrain/files/gdal/raster_module.hpp"

namespace phytobench {

namespace {

void say(RasterMessage* message, const char* text) {
  std::snprintf(message->text, sizeof(message->text), "%s", text);
  // One line, whatever came from the file.
  for (char* c = message->text; *c != '\0'; ++c)
    if (*c < ' ' || *c > '~') *c = ' ';
}

bool fail(RasterMessage* message) {
  const char* reason = CPLGetLastErrorMsg();
  say(message, *reason == '\0' ? "GDAL gives no reason" : reason);
  return false;
}

/// GDAL prints errors unless it is told not to.
class QuietErrors {
 public:
  QuietErrors() {
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
  }
  ~QuietErrors() { CPLPopErrorHandler(); }
  QuietErrors(const QuietErrors&) = delete;
  QuietErrors& operator=(const QuietErrors&) = delete;
};

struct CloseDataset {
  void operator()(void* dataset) const { GDALClose(dataset); }
};
using Dataset = std::unique_ptr<void, CloseDataset>;

const char* library_name() {
  static const std::string name = std::string("GDAL ") + GDALVersionInfo("RELEASE_NAME");
  return name.c_str();
}

RasterDescription described(GDALDatasetH dataset) {
  RasterDescription about{};
  about.columns = GDALGetRasterXSize(dataset);
  about.rows = GDALGetRasterYSize(dataset);
  about.bands = GDALGetRasterCount(dataset);
  about.has_transform = GDALGetGeoTransform(dataset, about.transform) == CE_None;
  about.metres_per_unit = 1.0;
  if (OGRSpatialReferenceH system = GDALGetSpatialRef(dataset)) {
    about.is_geographic = OSRIsGeographic(system) != 0;
    about.is_projected = OSRIsProjected(system) != 0 || OSRIsLocal(system) != 0;
    if (about.is_projected) about.metres_per_unit = OSRGetLinearUnits(system, nullptr);
  }
  about.projection = GDALGetProjectionRef(dataset);
  about.driver = GDALGetDriverLongName(GDALGetDatasetDriver(dataset));
  about.height_unit = "";
  if (about.bands > 0) {
    GDALRasterBandH band = GDALGetRasterBand(dataset, 1);
    about.has_palette = GDALGetRasterColorTable(band) != nullptr;
    about.height_unit = GDALGetRasterUnitType(band);
  }
  return about;
}

void* open_raster(const char* file, RasterDescription* about, RasterMessage* message) {
  const QuietErrors quiet;
  GDALAllRegister();
  Dataset dataset(GDALOpenEx(file, GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
                             nullptr, nullptr, nullptr));
  if (!dataset) {
    fail(message);
    return nullptr;
  }
  *about = described(dataset.get());
  return dataset.release();
}

/// Sets what the mask says has no data to NaN, and scales the rest.
void mark_and_scale(const std::vector<unsigned char>& mask, double scale, double offset,
                    double* values, std::size_t count) {
  for (std::size_t i = 0; i < count; ++i) {
    if (scale != 1.0 || offset != 0.0) values[i] = values[i] * scale + offset;
    if (!mask.empty() && mask[i] == 0) values[i] = std::numeric_limits<double>::quiet_NaN();
  }
}

bool read_band(GDALRasterBandH band, double* values, RasterMessage* message) {
  const int columns = GDALGetRasterBandXSize(band), rows = GDALGetRasterBandYSize(band);
  const double scale = GDALGetRasterScale(band, nullptr);
  const double offset = GDALGetRasterOffset(band, nullptr);
  const bool is_masked = (GDALGetMaskFlags(band) & GMF_ALL_VALID) == 0;
  const int rows_at_once = std::max(1, (1 << 22) / columns);
  std::vector<unsigned char> mask;
  for (int row = 0; row < rows; row += rows_at_once) {
    const int some = std::min(rows_at_once, rows - row);
    const std::size_t count = static_cast<std::size_t>(some) * static_cast<std::size_t>(columns);
    double* to = values + static_cast<std::size_t>(row) * static_cast<std::size_t>(columns);
    if (GDALRasterIO(band, GF_Read, 0, row, columns, some, to, columns, some, GDT_Float64, 0, 0) !=
        CE_None)
      return fail(message);
    if (is_masked) {
      mask.resize(count);
      if (GDALRasterIO(GDALGetMaskBand(band), GF_Read, 0, row, columns, some, mask.data(), columns,
                       some, GDT_Byte, 0, 0) != CE_None)
        return fail(message);
    }
    mark_and_scale(mask, scale, offset, to, count);
  }
  return true;
}

bool read_raster_values(void* raster, double* values, RasterMessage* message) {
  const QuietErrors quiet;
  try {
    return read_band(GDALGetRasterBand(raster, 1), values, message);
  } catch (const std::exception& error) {
    say(message, error.what());
    return false;
  }
}

void close_raster(void* raster) {
  const QuietErrors quiet;
  GDALClose(raster);
}

/// A file in memory, for as long as this lives.
class FileInMemory {
 public:
  FileInMemory() {
    static std::atomic<unsigned int> count{0};
    name_ = "/vsimem/phytobench_" + std::to_string(count++) + ".tif";
  }
  ~FileInMemory() { VSIUnlink(name_.c_str()); }
  FileInMemory(const FileInMemory&) = delete;
  FileInMemory& operator=(const FileInMemory&) = delete;
  const char* name() const { return name_.c_str(); }

 private:
  std::string name_;
};

bool write_geotiff(const RasterToWrite& raster, const char* name, RasterMessage* message) {
  GDALAllRegister();
  GDALDriverH driver = GDALGetDriverByName("GTiff");
  if (driver == nullptr) return fail(message);
  const char* options[] = {"COMPRESS=DEFLATE", "PREDICTOR=3", "BIGTIFF=IF_SAFER", nullptr};
  const Dataset dataset(GDALCreate(driver, name, raster.columns, raster.rows, 1, GDT_Float64,
                                   const_cast<char**>(options)));
  if (!dataset) return fail(message);
  double transform[6];
  std::copy(std::begin(raster.transform), std::end(raster.transform), transform);
  if (GDALSetGeoTransform(dataset.get(), transform) != CE_None) return fail(message);
  if (*raster.projection != '\0' && GDALSetProjection(dataset.get(), raster.projection) != CE_None)
    return fail(message);
  GDALRasterBandH band = GDALGetRasterBand(dataset.get(), 1);
  GDALSetRasterNoDataValue(band, std::numeric_limits<double>::quiet_NaN());
  if (GDALRasterIO(band, GF_Write, 0, 0, raster.columns, raster.rows,
                   const_cast<double*>(raster.values), raster.columns, raster.rows, GDT_Float64, 0,
                   0) != CE_None)
    return fail(message);
  GDALFlushCache(dataset.get());
  return CPLGetLastErrorType() < CE_Failure || fail(message);
}

bool to_geotiff(const RasterToWrite& raster, void* receiver,
                void (*take)(void* receiver, const void* bytes, std::size_t size),
                RasterMessage* message) {
  const QuietErrors quiet;
  try {
    const FileInMemory file;
    if (!write_geotiff(raster, file.name(), message)) return false;
    vsi_l_offset size = 0;
    const GByte* bytes = VSIGetMemFileBuffer(file.name(), &size, FALSE);
    if (bytes == nullptr) return fail(message);
    take(receiver, bytes, static_cast<std::size_t>(size));
    return true;
  } catch (const std::exception& error) {
    say(message, error.what());
    return false;
  }
}

constexpr RasterModule module{raster_module_version, library_name, open_raster,
                              read_raster_values,    close_raster, to_geotiff};

}  // namespace

}  // namespace phytobench

extern "C" __attribute__((visibility("default"))) const phytobench::RasterModule*
phytobench_raster_module() {
  return &phytobench::module;
}
