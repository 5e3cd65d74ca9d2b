// SPDX-License-Identifier: MIT
#include "core/population/resource_map.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/picture/image.hpp"

namespace phytobench {

namespace {

constexpr std::uint64_t most_pixels = 16'000'000;

/// The cell of `count` over [low, low + length] that holds the value, or the nearest.
std::size_t cell_of(double value, double low, double length, int count) {
  const double cell = std::floor((value - low) / length * count);
  if (!(cell > 0.0)) return 0;
  return static_cast<std::size_t>(std::min(cell, count - 1.0));
}

/// Four bytes, the highest first, as PNG writes numbers.
std::uint64_t number_at(std::string_view bytes, std::size_t begin) {
  std::uint64_t number = 0;
  for (const char c : bytes.substr(begin, 4)) number = number << 8 | static_cast<unsigned char>(c);
  return number;
}

/// Looks at the header alone: a small file may unpack to more than any memory.
void refuse_many_pixels(std::string_view bytes, const std::string& file) {
  constexpr std::size_t width_begin = 16, height_begin = 20, header_end = 24;
  if (bytes.size() < header_end || bytes.substr(12, 4) != "IHDR") return;  // no PNG: parse_png
  const std::uint64_t width = number_at(bytes, width_begin);
  const std::uint64_t height = number_at(bytes, height_begin);
  if (width * height > most_pixels)
    throw InputError(fmt::format("{}: has {} x {} pixels; a map has at most {}: scale it down",
                                 file, width, height, most_pixels));
}

void refuse_other_proportions(const Image& image, const Rectangle& ground,
                              const std::string& file) {
  // Seen from the shorter side, which was rounded to whole pixels most.
  const bool is_wide = ground.width() >= ground.height();
  const double wanted = is_wide ? image.width() * (ground.height() / ground.width())
                                : image.height() * (ground.width() / ground.height());
  const double given = is_wide ? image.height() : image.width();
  if (std::abs(given - wanted) > 1.0)
    throw InputError(fmt::format(
        "{}: {} x {} pixels are not in the proportion of the ground, {} m x {} m; cut the map to "
        "the ground, or change ground.size",
        file, image.width(), image.height(), ground.width(), ground.height()));
}

double brightness(const Pixel& pixel) {
  return (pixel[0] + pixel[1] + pixel[2]) / (3.0 * 255.0);
}

}  // namespace

ResourceMap::ResourceMap(int columns, int rows, std::vector<double> values, const Rectangle& ground)
    : columns_(columns), rows_(rows), values_(std::move(values)), ground_(ground) {
  PHYTOBENCH_EXPECT(columns > 0 && rows > 0);
  PHYTOBENCH_EXPECT(values_.size() ==
                    static_cast<std::size_t>(columns) * static_cast<std::size_t>(rows));
  PHYTOBENCH_EXPECT(ground.width() > 0.0 && ground.height() > 0.0);
  PHYTOBENCH_EXPECT(std::all_of(values_.begin(), values_.end(),
                                [](double value) { return value >= 0.0 && value <= 1.0; }));
}

std::size_t ResourceMap::index_of(const Point2& place) const {
  const std::size_t column = cell_of(place.x, ground_.low.x, ground_.width(), columns_);
  // From the top downwards: the cell's upper border belongs to the row above.
  const std::size_t from_below = cell_of(place.y, ground_.low.y, ground_.height(), rows_);
  const std::size_t row = static_cast<std::size_t>(rows_) - 1 - from_below;
  return row * static_cast<std::size_t>(columns_) + column;
}

ResourceMap read_resource_map(const std::filesystem::path& file, const Rectangle& ground) {
  const std::string bytes = read_text_file(file);
  refuse_many_pixels(bytes, file.string());
  const Image image = parse_png(bytes, file.string());
  refuse_other_proportions(image, ground, file.string());
  std::vector<double> values;
  values.reserve(image.pixels().size());
  for (const Pixel& pixel : image.pixels()) values.push_back(brightness(pixel));
  return {image.width(), image.height(), std::move(values), ground};
}

}  // namespace phytobench
