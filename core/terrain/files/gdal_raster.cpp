// SPDX-License-Identifier: MIT
#include "core/terrain/files/gdal_raster.hpp"

#include <algorithm>
#include <cmath>
#include <memory>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

/// An opened raster of the module.
class OpenRaster {
 public:
  OpenRaster(const RasterModule& module, const fs::path& file) : module_(module) {
    RasterMessage message{};
    raster_ = module_.open(file.c_str(), &about_, &message);
    if (raster_ == nullptr)
      throw InputError(fmt::format("{}: is no map that {} can read ({}); is it cut off?",
                                   file.string(), module_.library(), message.text));
  }
  ~OpenRaster() { module_.close(raster_); }
  OpenRaster(const OpenRaster&) = delete;
  OpenRaster& operator=(const OpenRaster&) = delete;

  const RasterDescription& about() const { return about_; }

  std::vector<double> values(const std::string& name) {
    std::vector<double> values(static_cast<std::size_t>(about_.columns) *
                               static_cast<std::size_t>(about_.rows));
    RasterMessage message{};
    if (!module_.read(raster_, values.data(), &message))
      throw InputError(
          fmt::format("{}: cannot be read to its end ({}); is it cut off?", name, message.text));
    return values;
  }

 private:
  const RasterModule& module_;
  RasterDescription about_{};
  void* raster_ = nullptr;
};

CoordinateUnit unit_of(const RasterDescription& about) {
  if (about.is_geographic) return {CoordinateUnit::Kind::degrees};
  if (about.is_projected) return {CoordinateUnit::Kind::lengths, about.metres_per_unit};
  return {};
}

/// Where the map lies, rows from north to south. Nothing if the file does not say.
std::optional<GeoReference> place_of(const RasterDescription& about, const std::string& name) {
  if (!about.has_transform) return std::nullopt;
  const double* t = about.transform;
  if (t[2] != 0.0 || t[4] != 0.0 || !(t[1] > 0.0) || !(std::abs(t[5]) > 0.0) ||
      !std::isfinite(t[0] + t[1] + t[3] + t[5]))
    throw InputError(
        fmt::format("{}: its rows do not run from west to east; turn it with gdalwarp "
                    "before",
                    name));
  const double north = t[5] < 0.0 ? t[3] : t[3] + t[5] * about.rows;
  return GeoReference{t[0], north, t[1], -std::abs(t[5]), about.projection};
}

void flip_rows(Raster& raster) {
  const auto columns = static_cast<std::ptrdiff_t>(raster.columns);
  for (std::ptrdiff_t top = 0, bottom = raster.rows - 1; top < bottom; ++top, --bottom)
    std::swap_ranges(raster.values.begin() + top * columns,
                     raster.values.begin() + (top + 1) * columns,
                     raster.values.begin() + bottom * columns);
}

}  // namespace

Raster read_gdal_raster(const fs::path& file) {
  const std::string name = file.string();
  OpenRaster opened(raster_module("reading " + name), file);
  const RasterDescription& about = opened.about();
  if (about.bands != 1)
    throw InputError(
        fmt::format("{}: has {} bands where a map has one; take one out with "
                    "gdal_translate -b 1",
                    name, about.bands));
  check_raster_size(about.columns, about.rows, name);
  Raster raster;
  raster.columns = about.columns;
  raster.rows = about.rows;
  raster.place = place_of(about, name);
  raster.unit = unit_of(about);
  raster.height_unit = about.height_unit;
  raster.has_palette = about.has_palette;
  raster.format = about.driver;
  raster.values = opened.values(name);
  if (raster.place && about.transform[5] > 0.0) flip_rows(raster);
  return raster;
}

}  // namespace phytobench
