// SPDX-License-Identifier: MIT
#include "core/terrain/files/grey_levels.hpp"

#include "core/picture/grey_image.hpp"

namespace phytobench {

Raster parse_grey_levels(std::string_view bytes, const std::string& name) {
  const GreyImage image = parse_grey_png(bytes, name);
  Raster raster;
  raster.columns = image.width;
  raster.rows = image.height;
  raster.format = "PNG";
  check_raster_size(raster.columns, raster.rows, name);
  raster.values.assign(image.levels.begin(), image.levels.end());
  return raster;
}

}  // namespace phytobench
