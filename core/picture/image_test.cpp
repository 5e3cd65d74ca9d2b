// SPDX-License-Identifier: MIT
#include "core/picture/image.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

TEST(Colour, IsReadFromSixDigits) {
  EXPECT_EQ(parse_colour("#ff0080").red, 1.0);
  EXPECT_EQ(parse_colour("#ff0080").green, 0.0);
  EXPECT_NEAR(parse_colour("#FF0080").blue, 128.0 / 255.0, 1e-15);
  EXPECT_EQ(to_text(parse_colour("#6b4a2b")), "#6b4a2b");
}

TEST(Colour, RefusesAnythingElse) {
  for (const char* wrong : {"", "#", "6b4a2b", "#6b4a2", "#6b4a2bb", "#6b4a2g", "brown", "#-b4a2b"})
    EXPECT_THROW(parse_colour(wrong), InputError) << wrong;
}

Image checkered() {
  Image image(5, 3, {10, 20, 30, 0});
  image.at(4, 2) = {255, 1, 2, 128};
  image.at(0, 1) = {0, 255, 0, 255};
  return image;
}

TEST(Png, ComesBackAsItWas) {
  const std::string bytes = to_png(checkered());
  EXPECT_EQ(bytes, to_png(checkered()));
  EXPECT_EQ(parse_png(bytes, "x.png"), checkered());
}

TEST(Png, SaysWhichFileIsNone) {
  const std::string bytes = to_png(checkered());
  for (const std::string& wrong :
       {std::string("P6 5 3"), std::string(), bytes.substr(0, bytes.size() / 2)}) {
    try {
      parse_png(wrong, "bark.png");
      ADD_FAILURE() << "should have been refused";
    } catch (const InputError& error) {
      EXPECT_NE(std::string(error.what()).find("bark.png"), std::string::npos);
    }
  }
}

TEST(Jpeg, HasItsMarksAndIsTheSameEachTime) {
  const Image image(40, 30, {90, 120, 60, 255});
  const std::string bytes = to_jpeg(image);
  ASSERT_GT(bytes.size(), 100u);
  EXPECT_EQ(bytes.substr(0, 2), "\xff\xd8");
  EXPECT_EQ(bytes.substr(bytes.size() - 2), "\xff\xd9");
  EXPECT_EQ(bytes, to_jpeg(image));
  EXPECT_LT(to_jpeg(checkered(), 10).size(), to_jpeg(checkered(), 100).size() + 1);
}

}  // namespace
}  // namespace phytobench
