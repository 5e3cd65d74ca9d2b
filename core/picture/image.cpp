// SPDX-License-Identifier: MIT
#include "core/picture/image.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

int to_byte(double share) {
  return static_cast<int>(std::lround(255.0 * std::clamp(share, 0.0, 1.0)));
}

/// -1 if it is no hexadecimal digit.
int digit_value(char c) {
  if (c >= '0' && c <= '9') return c - '0';
  if (c >= 'a' && c <= 'f') return c - 'a' + 10;
  if (c >= 'A' && c <= 'F') return c - 'A' + 10;
  return -1;
}

}  // namespace

Image::Image(int width, int height, const Pixel& fill)
    : width_(width),
      height_(height),
      pixels_(static_cast<std::size_t>(width) * static_cast<std::size_t>(height), fill) {
  PHYTOBENCH_EXPECT(width > 0 && height > 0);
}

Colour parse_colour(std::string_view text) {
  const bool has_form =
      text.size() == 7 && text[0] == '#' &&
      std::all_of(text.begin() + 1, text.end(), [](char c) { return digit_value(c) >= 0; });
  if (!has_form)
    throw InputError(
        fmt::format("'{}' is no colour; write six hexadecimal digits, as in \"#6b4a2b\"", text));
  const auto channel = [&](std::size_t at) {
    return (16 * digit_value(text[at]) + digit_value(text[at + 1])) / 255.0;
  };
  return {channel(1), channel(3), channel(5)};
}

std::string to_text(const Colour& colour) {
  return fmt::format("#{:02x}{:02x}{:02x}", to_byte(colour.red), to_byte(colour.green),
                     to_byte(colour.blue));
}

Pixel to_pixel(const Colour& colour, double opacity) {
  const auto byte = [](double share) { return static_cast<std::uint8_t>(to_byte(share)); };
  return {byte(colour.red), byte(colour.green), byte(colour.blue), byte(opacity)};
}

}  // namespace phytobench
