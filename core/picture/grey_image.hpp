// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// Numbers as a picture holds them, which colours have no place in.
struct GreyImage {
  int width = 0;
  int height = 0;
  int bits = 16;                      ///< of a level: 8 or 16
  std::vector<std::uint16_t> levels;  ///< rows from top to bottom

  friend bool operator==(const GreyImage&, const GreyImage&) = default;
};

/// Reads a grey PNG of 8 or 16 bits from bytes. `name` stands for the file in messages. Throws
/// InputError, also for a PNG with colours, opacity, or fewer bits, whose levels would be changed.
GreyImage parse_grey_png(std::string_view bytes, const std::string& name);

/// The image as the bytes of a PNG file; the same bytes each time. Expects levels that fit the
/// bits.
std::string to_png(const GreyImage& image);

}  // namespace phytobench
