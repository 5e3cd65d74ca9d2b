// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// Red, green and blue as shown on a screen (sRGB), each 0 to 1.
struct Colour {
  double red = 0.0;
  double green = 0.0;
  double blue = 0.0;

  friend bool operator==(const Colour&, const Colour&) = default;
};

/// "#rrggbb". Throws InputError with what is allowed.
Colour parse_colour(std::string_view text);
std::string to_text(const Colour& colour);

/// Red, green, blue and opacity, 0 to 255.
using Pixel = std::array<std::uint8_t, 4>;

/// Rows from top to bottom.
class Image {
 public:
  Image() = default;
  Image(int width, int height, const Pixel& fill = {0, 0, 0, 0});

  int width() const { return width_; }
  int height() const { return height_; }
  Pixel& at(int column, int row) { return pixels_[index(column, row)]; }
  const Pixel& at(int column, int row) const { return pixels_[index(column, row)]; }
  const std::vector<Pixel>& pixels() const { return pixels_; }

  friend bool operator==(const Image&, const Image&) = default;

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(column);
  }

  int width_ = 0;
  int height_ = 0;
  std::vector<Pixel> pixels_;
};

Pixel to_pixel(const Colour& colour, double opacity = 1.0);

/// The image as the bytes of a PNG file; the same bytes each time.
std::string to_png(const Image& image);

/// The image without its opacity as the bytes of a JPEG file, for photograph-like pictures, which
/// PNG packs badly. `quality` is 1 to 100.
std::string to_jpeg(const Image& image, int quality = 50);

/// Reads a PNG from bytes. `name` stands for the file in messages. Throws InputError.
Image parse_png(std::string_view bytes, const std::string& name);

}  // namespace phytobench
