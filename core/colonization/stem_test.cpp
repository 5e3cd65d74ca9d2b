// SPDX-License-Identifier: MIT
#include "core/colonization/stem.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <gtest/gtest.h>

#include "core/colonization/test_streams.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double edge_rounding = 1e-12;  // a few floating-point operations on numbers below 10
constexpr double five_degrees_rad = 5.0 * std::numbers::pi / 180.0;

struct GrownStem {
  Skeleton skeleton{Vector3{}};
  std::int32_t top = 0;
};

GrownStem stem(double length, double piece_length, double tilt_rad, std::uint64_t seed = 0) {
  GrownStem grown;
  CounterStream stream(seed, 0);
  grown.top = append_stem(grown.skeleton, 0, length, piece_length, tilt_rad, stream);
  return grown;
}

/// The edge that ends in `node`.
Vector3 edge(const Skeleton& skeleton, std::size_t node) {
  return skeleton.positions()[node] - skeleton.position(skeleton.parents()[node]);
}

TEST(AppendStem, CutsTheLengthIntoPieces) {
  const std::pair<double, std::size_t> cases[] = {{0.0, 0}, {1.0, 4}, {1.2, 5}, {1.8, 8}, {2.0, 8}};
  for (const auto& [length, edges] : cases) {
    const GrownStem grown = stem(length, 0.25, five_degrees_rad);
    EXPECT_EQ(grown.skeleton.edge_count(), edges) << "length " << length;
    EXPECT_EQ(static_cast<std::size_t>(grown.top), edges) << "length " << length;
  }
}

TEST(AppendStem, RoundingMakesNoPieceOfItsOwn) {
  EXPECT_EQ(stem(0.1 + 0.2, 0.1, 0.0).skeleton.edge_count(), 3u);  // 0.30000000000000004
  EXPECT_EQ(stem(10.0, 0.1, 0.0).skeleton.edge_count(), 100u);
}

TEST(AppendStem, MakesTheLastPieceShorter) {
  const Skeleton skeleton = stem(1.1, 0.25, five_degrees_rad).skeleton;
  ASSERT_EQ(skeleton.edge_count(), 5u);
  for (std::size_t node = 1; node < 5; ++node)
    EXPECT_NEAR(norm(edge(skeleton, node)), 0.25, edge_rounding);
  EXPECT_NEAR(norm(edge(skeleton, 5)), 0.1, edge_rounding);
}

TEST(AppendStem, StandsStraightWithoutTilt) {
  const Skeleton skeleton = stem(2.0, 0.25, 0.0).skeleton;
  for (std::size_t node = 0; node < skeleton.node_count(); ++node) {
    EXPECT_EQ(skeleton.positions()[node].x, 0.0);
    EXPECT_EQ(skeleton.positions()[node].z, 0.0);
    EXPECT_EQ(skeleton.positions()[node].y, 0.25 * static_cast<double>(node));
  }
}

TEST(AppendStem, StartsAtItsFoot) {
  Skeleton skeleton{Vector3{}};
  const std::int32_t foot = skeleton.append(0, {1, 2, 3});
  skeleton.append(0, {-1, 0, 0});
  CounterStream stream(1, 0);
  EXPECT_EQ(append_stem(skeleton, foot, 0.0, 0.25, 0.1, stream), foot);
  EXPECT_EQ(skeleton.node_count(), 3u);
  EXPECT_EQ(append_stem(skeleton, foot, 0.5, 0.25, 0.1, stream), 4);
  EXPECT_EQ(skeleton.parents()[3], foot);
  EXPECT_EQ(skeleton.parents()[4], 3);
}

// Published counts depend on it: angle, axis x, one number unused, axis z.
TEST(AppendStem, DrawsFourNumbersPerPiece) {
  ScriptedStream stream({1.0, 1.0, 0.3, 0.5,    // angle +0.1 about the x axis
                         0.9, 0.5, 0.3, 0.5});  // no axis: upright
  Skeleton skeleton{Vector3{}};
  append_stem(skeleton, 0, 2.0, 1.0, 0.1, stream);
  EXPECT_EQ(stream.used(), 8u);
  const Vector3 first = edge(skeleton, 1);
  EXPECT_NEAR(first.x, 0.0, edge_rounding);
  EXPECT_NEAR(first.y, std::cos(0.1), edge_rounding);
  EXPECT_NEAR(first.z, std::sin(0.1), edge_rounding);
  const Vector3 second = edge(skeleton, 2);
  EXPECT_EQ(second.x, 0.0);
  EXPECT_NEAR(second.y, 1.0, edge_rounding);
  EXPECT_NEAR(second.z, 0.0, edge_rounding);
}

TEST(AppendStemLaw, NeverTiltsBeyondTheLimit) {
  for (const double limit_rad : {five_degrees_rad, 0.5, 0.5 * std::numbers::pi}) {
    double largest_rad = 0.0;
    for (std::uint64_t seed = 0; seed < 20; ++seed) {
      const Skeleton skeleton = stem(5.0, 0.25, limit_rad, seed).skeleton;
      for (std::size_t node = 1; node < skeleton.node_count(); ++node) {
        const Vector3 piece = edge(skeleton, node);
        // Unlike the arc cosine of a dot product, this is accurate for small angles.
        const double tilt_rad = std::atan2(std::hypot(piece.x, piece.z), piece.y);
        ASSERT_LE(tilt_rad, limit_rad + edge_rounding) << "seed " << seed << ", node " << node;
        largest_rad = std::max(largest_rad, tilt_rad);
      }
    }
    EXPECT_GT(largest_rad, 0.9 * limit_rad);  // 400 uniform draws all below nine tenths: 0.9^400
  }
}

TEST(AppendStemLaw, SameStreamGivesTheSameStem) {
  EXPECT_EQ(tree_hash(stem(2.0, 0.25, 0.1, 7).skeleton),
            tree_hash(stem(2.0, 0.25, 0.1, 7).skeleton));
  EXPECT_NE(tree_hash(stem(2.0, 0.25, 0.1, 7).skeleton),
            tree_hash(stem(2.0, 0.25, 0.1, 8).skeleton));
}

}  // namespace
}  // namespace phytobench
