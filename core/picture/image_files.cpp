// SPDX-License-Identifier: MIT
// PNG and JPEG through stb, which is seen in this file alone.
#include <cstdlib>
#include <memory>

#include <fmt/format.h>
#include <boost/crc.hpp>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/picture/grey_image.hpp"
#include "core/picture/image.hpp"

#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wunused-function"
#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#define STBI_NO_STDIO
#define STBI_MAX_DIMENSIONS 16384
#include <stb/stb_image.h>
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>
#pragma GCC diagnostic pop

namespace phytobench {

namespace {

constexpr int channels = 4;

struct FreePixels {
  void operator()(void* pixels) const { stbi_image_free(pixels); }
};

void append_bytes(void* text, void* bytes, int count) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes),
                                          static_cast<std::size_t>(count));
}

constexpr std::string_view png_signature("\x89PNG\r\n\x1a\n", 8);

[[noreturn]] void refuse_png(const std::string& name) {
  throw InputError(
      fmt::format("{}: is no PNG picture that can be read ({}); save it as PNG with "
                  "at most {} pixels on a side",
                  name, stbi_failure_reason(), STBI_MAX_DIMENSIONS));
}

/// What the header says, which stands at the same place in every PNG; stb itself would make grey
/// levels out of anything.
int bits_of_grey_png(std::string_view bytes, const std::string& name) {
  constexpr std::size_t bits_at = 24, kind_at = 25;
  if (!bytes.starts_with(png_signature) || bytes.size() <= kind_at)
    throw InputError(name + ": is no PNG picture, or cut off; save it again");
  const int bits = static_cast<unsigned char>(bytes[bits_at]);
  const int kind = static_cast<unsigned char>(bytes[kind_at]);
  if (kind != 0)
    throw InputError(fmt::format("{}: is a PNG {}; save it in grey levels without opacity", name,
                                 kind == 4 ? "with opacity" : "of colours"));
  if (bits != 8 && bits != 16)
    throw InputError(
        fmt::format("{}: is a PNG of {} bits a pixel; save it with 8 or 16", name, bits));
  return bits;
}

std::string big_endian(std::uint32_t number) {
  std::string bytes;
  for (int shift = 24; shift >= 0; shift -= 8) bytes += static_cast<char>(number >> shift & 0xff);
  return bytes;
}

std::string png_chunk(const std::string& kind, std::string_view content) {
  boost::crc_32_type sum;
  sum.process_bytes(kind.data(), kind.size());
  sum.process_bytes(content.data(), content.size());
  return big_endian(static_cast<std::uint32_t>(content.size())) + kind + std::string(content) +
         big_endian(sum.checksum());
}

/// Each row as the difference to the one above it, with the number of that filter in front.
std::string differences_of_rows(const GreyImage& image) {
  constexpr char up = 2;
  const auto width = static_cast<std::size_t>(image.width);
  std::string bytes;
  bytes.reserve(static_cast<std::size_t>(image.height) * (2 * width + 1));
  const std::vector<std::uint16_t> nothing(width, 0);
  const std::uint16_t* above = nothing.data();
  for (int row = 0; row < image.height; ++row) {
    const std::uint16_t* levels = image.levels.data() + static_cast<std::size_t>(row) * width;
    bytes += up;
    for (std::size_t column = 0; column < width; ++column) {
      bytes += static_cast<char>((levels[column] >> 8) - (above[column] >> 8));
      bytes += static_cast<char>((levels[column] & 0xff) - (above[column] & 0xff));
    }
    above = levels;
  }
  return bytes;
}

/// stb writes no more than 8 bits a pixel, but it packs.
std::string sixteen_bit_png(const GreyImage& image) {
  std::string rows = differences_of_rows(image);
  int size = 0;
  constexpr int effort = 8;
  const std::unique_ptr<unsigned char, FreePixels> packed(stbi_zlib_compress(
      reinterpret_cast<unsigned char*>(rows.data()), static_cast<int>(rows.size()), &size, effort));
  if (!packed) throw EnvironmentError("the picture could not be packed as PNG; free some memory");
  const std::string header = big_endian(static_cast<std::uint32_t>(image.width)) +
                             big_endian(static_cast<std::uint32_t>(image.height)) +
                             std::string("\x10\0\0\0\0", 5);
  const std::string_view content(reinterpret_cast<const char*>(packed.get()),
                                 static_cast<std::size_t>(size));
  return std::string(png_signature) + png_chunk("IHDR", header) + png_chunk("IDAT", content) +
         png_chunk("IEND", "");
}

template <class Level>
GreyImage copy_of(const Level* levels, int width, int height, int bits) {
  GreyImage image{.width = width, .height = height, .bits = bits};
  image.levels.assign(levels,
                      levels + static_cast<std::size_t>(width) * static_cast<std::size_t>(height));
  return image;
}

}  // namespace

GreyImage parse_grey_png(std::string_view bytes, const std::string& name) {
  const int bits = bits_of_grey_png(bytes, name);
  const auto* start = reinterpret_cast<const stbi_uc*>(bytes.data());
  const int size = static_cast<int>(bytes.size());
  int width = 0, height = 0, in_file = 0;
  if (bits == 16) {
    const std::unique_ptr<stbi_us, FreePixels> levels(
        stbi_load_16_from_memory(start, size, &width, &height, &in_file, 1));
    if (!levels) refuse_png(name);
    return copy_of(levels.get(), width, height, bits);
  }
  const std::unique_ptr<stbi_uc, FreePixels> levels(
      stbi_load_from_memory(start, size, &width, &height, &in_file, 1));
  if (!levels) refuse_png(name);
  return copy_of(levels.get(), width, height, bits);
}

std::string to_png(const GreyImage& image) {
  PHYTOBENCH_EXPECT(image.width > 0 && image.height > 0 && (image.bits == 8 || image.bits == 16));
  PHYTOBENCH_EXPECT(image.width <= STBI_MAX_DIMENSIONS && image.height <= STBI_MAX_DIMENSIONS);
  PHYTOBENCH_EXPECT(image.levels.size() ==
                    static_cast<std::size_t>(image.width) * static_cast<std::size_t>(image.height));
  if (image.bits == 16) return sixteen_bit_png(image);
  std::vector<unsigned char> levels;
  levels.reserve(image.levels.size());
  for (const std::uint16_t level : image.levels) {
    PHYTOBENCH_EXPECT(level <= 0xff);
    levels.push_back(static_cast<unsigned char>(level));
  }
  std::string bytes;
  if (stbi_write_png_to_func(append_bytes, &bytes, image.width, image.height, 1, levels.data(),
                             image.width) == 0)
    throw EnvironmentError("the picture could not be packed as PNG; free some memory");
  return bytes;
}

std::string to_png(const Image& image) {
  std::string bytes;
  const int stride = channels * image.width();
  if (stbi_write_png_to_func(append_bytes, &bytes, image.width(), image.height(), channels,
                             image.pixels().data(), stride) == 0)
    throw EnvironmentError("the picture could not be packed as PNG; free some memory");
  return bytes;
}

std::string to_jpeg(const Image& image, int quality) {
  std::string bytes;
  if (stbi_write_jpg_to_func(append_bytes, &bytes, image.width(), image.height(), channels,
                             image.pixels().data(), quality) == 0)
    throw EnvironmentError("the picture could not be packed as JPEG; free some memory");
  return bytes;
}

Image parse_png(std::string_view bytes, const std::string& name) {
  int width = 0, height = 0, in_file = 0;
  const std::unique_ptr<stbi_uc, FreePixels> pixels(
      stbi_load_from_memory(reinterpret_cast<const stbi_uc*>(bytes.data()),
                            static_cast<int>(bytes.size()), &width, &height, &in_file, channels));
  if (!pixels) refuse_png(name);
  Image image(width, height);
  const stbi_uc* byte = pixels.get();
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column, byte += channels)
      image.at(column, row) = {byte[0], byte[1], byte[2], byte[3]};
  return image;
}

}  // namespace phytobench
