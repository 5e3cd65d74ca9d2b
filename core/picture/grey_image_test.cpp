// SPDX-License-Identifier: MIT
#include "core/picture/grey_image.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/picture/image.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;

GreyImage random_grey(int width, int height, int bits) {
  CounterStream numbers(1, 2);
  GreyImage image{.width = width, .height = height, .bits = bits};
  for (int i = 0; i < width * height; ++i)
    image.levels.push_back(
        static_cast<std::uint16_t>(numbers.next_unit() * (bits == 16 ? 65536.0 : 256.0)));
  return image;
}

std::string grey_error(std::string_view bytes) {
  try {
    parse_grey_png(bytes, "hill.png");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// Of another program (zlib's compressor, no filter): levels 0, 1, 256 / 65535, 40, 12345.
const std::string sixteen_bits_elsewhere(
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\003\000\000"
    "\000\002\020\000\000\000\000\350\217\345\205\000\000\000\026\111\104\101\124\170\332\143"
    "\140\140\140\140\144\144\140\370\377\237\101\303\300\022\000\014\047\002\222\275\336\066"
    "\363\000\000\000\000\111\105\116\104\256\102\140\202",
    79);
/// Levels 0, 128, 255.
const std::string eight_bits_elsewhere(
    "\211\120\116\107\015\012\032\012\000\000\000\015\111\110\104\122\000\000\000\003\000\000"
    "\000\001\010\000\000\000\000\076\213\113\150\000\000\000\014\111\104\101\124\170\332\143"
    "\140\150\370\017\000\002\003\001\200\032\234\046\073\000\000\000\000\111\105\116\104\256"
    "\102\140\202",
    69);

TEST(GreyImage, ReadsWhatOtherProgramsWrite) {
  const GreyImage sixteen = parse_grey_png(sixteen_bits_elsewhere, "x");
  EXPECT_EQ(sixteen.width, 3);
  EXPECT_EQ(sixteen.height, 2);
  EXPECT_EQ(sixteen.bits, 16);
  EXPECT_THAT(sixteen.levels, ElementsAre(0, 1, 256, 65535, 40, 12345));
  const GreyImage eight = parse_grey_png(eight_bits_elsewhere, "x");
  EXPECT_EQ(eight.bits, 8);
  EXPECT_THAT(eight.levels, ElementsAre(0, 128, 255)) << "levels are not spread to 16 bits";
}

TEST(GreyImage, ComesBackAsItWasWritten) {
  for (const int bits : {8, 16})
    for (const auto& [width, height] : {std::pair{1, 1}, {1, 300}, {300, 1}, {61, 47}}) {
      const GreyImage image = random_grey(width, height, bits);
      const std::string bytes = to_png(image);
      EXPECT_EQ(parse_grey_png(bytes, "x"), image) << bits << " bits, " << width << " x " << height;
      EXPECT_EQ(to_png(image), bytes);
    }
}

TEST(GreyImage, RefusesColoursAndOpacity) {
  EXPECT_EQ(grey_error(to_png(Image(2, 2, {1, 2, 3, 255}))),
            "hill.png: is a PNG of colours; save it in grey levels without opacity");
  const auto with = [](std::size_t at, char value) {
    std::string bytes = sixteen_bits_elsewhere;
    bytes[at] = value;
    return bytes;
  };
  constexpr std::size_t bits_at = 24, kind_at = 25;
  EXPECT_THAT(grey_error(with(kind_at, 2)), HasSubstr("of colours"));
  EXPECT_THAT(grey_error(with(kind_at, 3)), HasSubstr("of colours")) << "a palette";
  EXPECT_THAT(grey_error(with(kind_at, 4)), HasSubstr("with opacity"));
  EXPECT_THAT(grey_error(with(bits_at, 4)), HasSubstr("of 4 bits a pixel"));
}

TEST(GreyImage, RefusesWhatIsCutOffOrNoPng) {
  const std::string bytes = to_png(random_grey(40, 40, 16));
  for (const std::size_t size : {std::size_t{0}, std::size_t{8}, std::size_t{25}, std::size_t{33},
                                 bytes.size() / 2, bytes.size() - 100})
    EXPECT_THAT(grey_error(bytes.substr(0, size)), HasSubstr("hill.png: is no PNG")) << size;
  EXPECT_THAT(grey_error("ncols 3"), HasSubstr("hill.png: is no PNG"));
  std::string wide = bytes;
  wide[17] = 1;  // 65576 pixels
  EXPECT_THAT(grey_error(wide), HasSubstr("at most 16384 pixels"));
}

TEST(GreyImage, LevelsBeyondTheBitsBreakTheContract) {
  EXPECT_THROW(to_png(GreyImage{.width = 1, .height = 1, .bits = 8, .levels = {256}}),
               ContractViolation);
  EXPECT_THROW(to_png(GreyImage{.width = 2, .height = 1, .levels = {1}}), ContractViolation);
  EXPECT_THROW(to_png(GreyImage{}), ContractViolation);
  EXPECT_THROW(to_png(GreyImage{.width = 1, .height = 1, .bits = 4, .levels = {1}}),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
