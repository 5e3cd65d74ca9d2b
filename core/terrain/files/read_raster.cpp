// SPDX-License-Identifier: MIT
#include <algorithm>
#include <cctype>
#include <fstream>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/terrain/files/ascii_grid.hpp"
#include "core/terrain/files/gdal_raster.hpp"
#include "core/terrain/files/grey_levels.hpp"
#include "core/terrain/files/number_rows.hpp"
#include "core/terrain/files/raster.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

constexpr std::uintmax_t most_text_bytes = std::uintmax_t{8} << 30;
constexpr std::uintmax_t most_picture_bytes = std::uintmax_t{1} << 30;

std::string in_small_letters(std::string text) {
  std::transform(text.begin(), text.end(), text.begin(),
                 [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
  return text;
}

std::string first_bytes(const fs::path& file) {
  std::ifstream stream(file, std::ios::binary);
  std::string bytes(8, '\0');
  stream.read(bytes.data(), static_cast<std::streamsize>(bytes.size()));
  bytes.resize(static_cast<std::size_t>(stream.gcount()));
  return bytes;
}

/// What says where an ESRI ASCII grid lies, if there is such a file beside it.
std::string projection_beside(const fs::path& file) {
  for (const char* ending : {".prj", ".PRJ"}) {
    const fs::path beside = fs::path(file).replace_extension(ending);
    std::error_code error;
    if (fs::is_regular_file(beside, error)) return read_text_file(beside);
  }
  return {};
}

}  // namespace

void check_raster_size(std::int64_t columns, std::int64_t rows, const std::string& place) {
  if (columns < 1 || rows < 1)
    throw InputError(fmt::format(
        "{}: {} columns and {} rows make no map; give at least one of each", place, columns, rows));
  if (columns > most_vertices / rows)
    throw InputError(
        fmt::format("{}: {} x {} vertices are more than the {} that fit; cut out a "
                    "part or take wider cells",
                    place, columns, rows, most_vertices));
}

Raster read_raster(const fs::path& file) {
  std::error_code error;
  if (!fs::exists(file, error)) throw InputError(file.string() + ": no such file");
  if (!fs::is_regular_file(file, error))
    throw InputError(file.string() + ": is no plain file; name the file that holds the map");
  const std::string start = first_bytes(file);
  const std::string ending = in_small_letters(file.extension().string());
  if (start == "\x89PNG\r\n\x1a\n" || ending == ".png")
    return parse_grey_levels(read_text_file(file, most_picture_bytes), file.string());
  if (ending == ".csv")
    return parse_number_rows(read_text_file(file, most_text_bytes), file.string());
  if (ending == ".asc" || in_small_letters(start).starts_with("ncols"))
    return parse_ascii_grid(read_text_file(file, most_text_bytes), file.string(),
                            projection_beside(file));
  return read_gdal_raster(file);
}

}  // namespace phytobench
