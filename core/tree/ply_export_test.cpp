// SPDX-License-Identifier: MIT
#include "core/tree/ply_export.hpp"

#include <bit>
#include <cstdint>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/picture/image.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;
using testing::StartsWith;

SceneObject triangle_at(double x, const std::string& name, const std::string& colour) {
  SceneObject object;
  object.name = object.material = name;
  object.mesh.positions = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}};
  object.mesh.normals = {{0, 0, 1}, {0, 0, 1}, {0, 0, 1}};
  object.mesh.texture_points = {{}, {}, {}};
  object.mesh.triangles = {{0, 1, 2}};
  object.texture_png = to_png(Image(2, 2, to_pixel(parse_colour(colour))));
  return object;
}

std::uint32_t word_at(const std::string& bytes, std::size_t offset) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i)
    word |= std::uint32_t{static_cast<unsigned char>(bytes.at(offset + i))} << (8 * i);
  return word;
}

float number_at(const std::string& bytes, std::size_t offset) {
  return std::bit_cast<float>(word_at(bytes, offset));
}

TEST(PlyExport, HoldsAllObjectsAsOneMesh) {
  const std::string ply =
      to_ply({triangle_at(0, "bark", "#6b4a2b"), triangle_at(5, "leaves", "#457d29")});
  EXPECT_THAT(ply, StartsWith("ply\nformat binary_little_endian 1.0\nelement vertex 6\n"));
  EXPECT_THAT(ply, HasSubstr("\nelement face 2\n"));
  const std::size_t data = ply.find("end_header\n") + 11;
  ASSERT_EQ(ply.size(), data + 6 * 27 + 2 * 13);
  EXPECT_EQ(number_at(ply, data + 27), 1.0f);  // x of the second vertex
  EXPECT_EQ(number_at(ply, data + 20), 1.0f);  // z of the first normal
  EXPECT_EQ(ply.substr(data + 24, 3), "\x6b\x4a\x2b");
  EXPECT_EQ(number_at(ply, data + 3 * 27), 5.0f);
  EXPECT_EQ(ply.substr(data + 3 * 27 + 24, 3), "\x45\x7d\x29");
  const std::size_t faces = data + 6 * 27;
  EXPECT_EQ(ply[faces], 3);
  EXPECT_EQ(word_at(ply, faces + 9), 2u);
  EXPECT_EQ(word_at(ply, faces + 13 + 1), 3u);  // the second object's first vertex
}

TEST(PlyExport, OfNothingIsAHeader) {
  EXPECT_THAT(to_ply({}), testing::EndsWith("element face 0\nproperty list uchar uint "
                                            "vertex_indices\nend_header\n"));
}

}  // namespace
}  // namespace phytobench
