// SPDX-License-Identifier: MIT
// PNG and JPEG through stb, which is seen in this file alone.
#include <cstdlib>
#include <memory>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
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
  void operator()(stbi_uc* pixels) const { stbi_image_free(pixels); }
};

void append_bytes(void* text, void* bytes, int count) {
  static_cast<std::string*>(text)->append(static_cast<const char*>(bytes),
                                          static_cast<std::size_t>(count));
}

}  // namespace

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
  if (!pixels)
    throw InputError(
        fmt::format("{}: is no PNG picture that can be read ({}); save it as PNG with "
                    "at most {} pixels on a side",
                    name, stbi_failure_reason(), STBI_MAX_DIMENSIONS));
  Image image(width, height);
  const stbi_uc* byte = pixels.get();
  for (int row = 0; row < height; ++row)
    for (int column = 0; column < width; ++column, byte += channels)
      image.at(column, row) = {byte[0], byte[1], byte[2], byte[3]};
  return image;
}

}  // namespace phytobench
