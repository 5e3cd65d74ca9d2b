// SPDX-License-Identifier: MIT
#include "core/lsystem/drawn_extent.hpp"

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/test_systems.hpp"

namespace phytobench {
namespace {

Word word_of(const TestCase& test) {
  DeriveOptions options;
  options.steps = test.steps;
  return derive(test.system, options);
}

void expect_equal(const BoundingBox& a, const BoundingBox& b) {
  ASSERT_EQ(a.empty(), b.empty());
  if (a.empty()) return;
  EXPECT_EQ(a.low(), b.low());
  EXPECT_EQ(a.high(), b.high());
}

void expect_near(const Vector3& a, const Vector3& b, double tolerance) {
  EXPECT_NEAR(a.x, b.x, tolerance);
  EXPECT_NEAR(a.y, b.y, tolerance);
  EXPECT_NEAR(a.z, b.z, tolerance);
}

TEST(DrawnExtentLaw, IsWhatTheMeasuresSayOfTheDrawing) {
  for (const TestCase& test : all_test_cases()) {
    SCOPED_TRACE(test.system.source);
    const Word word = word_of(test);
    const Drawing drawing = draw(test.system, word);
    const DrawnExtent extent = drawn_extent(test.system, word);
    EXPECT_EQ(extent.segments, drawing.segments.size());
    EXPECT_EQ(extent.length, total_length(drawing));
    EXPECT_EQ(extent.polygons, drawing.polygons.size());
    expect_equal(extent.segment_box, segment_box(drawing));
    expect_equal(extent.polygon_box, polygon_box(drawing));
  }
}

TEST(DrawnExtentLaw, IsTheSameOfTheStreamUpToRounding) {
  for (const TestCase& test : all_test_cases()) {
    SCOPED_TRACE(test.system.source);
    const DrawnExtent word = drawn_extent(test.system, word_of(test));
    const DrawnExtent stream = drawn_extent(SegmentStream(test.system, test.steps));
    EXPECT_EQ(stream.segments, word.segments);
    const double tolerance = 1e-9 * (1.0 + word.length);  // sums of that many lengths
    EXPECT_NEAR(stream.length, word.length, tolerance);
    ASSERT_EQ(stream.segment_box.empty(), word.segment_box.empty());
    if (word.segment_box.empty()) continue;
    expect_near(stream.segment_box.low(), word.segment_box.low(), tolerance);
    expect_near(stream.segment_box.high(), word.segment_box.high(), tolerance);
  }
}

TEST(DrawnExtent, StopsWhenToldTo) {
  const TestCase island = test_case("island", "F-F-F-F", {{'F', "F-F+F+FF-F-F+F"}}, 90, 7);
  std::uint64_t asked = 0;
  const auto stop = [&](std::uint64_t segments) {
    asked = segments;
    return false;
  };
  EXPECT_THROW(drawn_extent(SegmentStream(island.system, island.steps), stop), Interrupted);
  EXPECT_GE(asked, std::uint64_t{1} << 22);
  EXPECT_LT(asked, std::uint64_t{1} << 23);
}

}  // namespace
}  // namespace phytobench
