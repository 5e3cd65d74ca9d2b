// SPDX-License-Identifier: MIT
#include "core/picture/render.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// A square of edge 2 upright at the origin, facing +z, in one colour.
SceneObject upright_square(const Pixel& colour) {
  SceneObject object{.name = "square", .material = "square"};
  object.mesh.positions = {{-1, 0, 0}, {1, 0, 0}, {1, 2, 0}, {-1, 2, 0}};
  object.mesh.normals.assign(4, {0, 0, 1});
  object.mesh.texture_points = {{0, 0}, {1, 0}, {1, 1}, {0, 1}};
  object.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  object.texture_png = to_png(Image(2, 2, colour));
  object.has_transparency = true;
  return object;
}

class Render : public testing::Test {
 protected:
  void SetUp() override {
    if (!can_render()) GTEST_SKIP() << "Embree is not installed";
  }

  static Image picture(const SceneObject& object, double azimuth, int threads = 1) {
    const Camera camera{
        .target = {0, 1, 0}, .azimuth_deg = azimuth, .elevation_deg = 5.0, .distance = 6.0};
    return render({object}, camera, {.width = 40, .height = 50, .samples = 2, .threads = threads});
  }

  static bool is_reddish(const Pixel& pixel) { return pixel[0] > 2 * pixel[1]; }
};

TEST_F(Render, ShowsAColourWhereTheObjectIsAndTheSkyWhereItIsNot) {
  const Image image = picture(upright_square({200, 20, 20, 255}), 90.0);
  EXPECT_TRUE(is_reddish(image.at(20, 25)));
  EXPECT_FALSE(is_reddish(image.at(2, 2)));
  EXPECT_GT(image.at(2, 2)[2], 200);
}

TEST_F(Render, LooksThroughWhatIsTransparent) {
  const Image image = picture(upright_square({200, 20, 20, 0}), 90.0);
  for (const Pixel& pixel : image.pixels()) EXPECT_FALSE(is_reddish(pixel));
}

TEST_F(Render, SeesAFlatThingFromItsEdgeAsALine) {
  int columns = 0;
  const Image image = picture(upright_square({200, 20, 20, 255}), 0.0);
  for (int column = 0; column < image.width(); ++column)
    columns += is_reddish(image.at(column, 25));
  EXPECT_LE(columns, 1);
}

TEST_F(Render, CastsAShadowOnTheGround) {
  const auto brightness_behind = [](std::uint8_t opacity) {
    const Camera camera{
        .target = {0, 0, 0}, .azimuth_deg = 90.0, .elevation_deg = 89.0, .distance = 12.0};
    const Image image = render({upright_square({200, 20, 20, opacity})}, camera,
                               {.width = 60, .height = 60, .samples = 2});
    int darkest = 255;
    for (const Pixel& pixel : image.pixels()) darkest = std::min<int>(darkest, pixel[1]);
    return darkest;
  };
  EXPECT_LT(brightness_behind(255), brightness_behind(0) - 30);
}

TEST_F(Render, IsTheSamePictureForAnyNumberOfThreads) {
  const SceneObject object = upright_square({90, 160, 40, 255});
  EXPECT_EQ(picture(object, 60.0, 1), picture(object, 60.0, 2));
  EXPECT_EQ(to_png(picture(object, 60.0)), to_png(picture(object, 60.0)));
}

TEST_F(Render, StopsWhenAskedTo) {
  int calls = 0;
  const RenderOptions options{
      .width = 20, .height = 100, .progress = [&](double) { return ++calls < 2; }};
  EXPECT_THROW(render({upright_square({1, 2, 3, 255})}, Camera{}, options), Interrupted);
  EXPECT_EQ(calls, 2);
}

}  // namespace
}  // namespace phytobench
