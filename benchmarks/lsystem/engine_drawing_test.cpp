// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/engine_drawing.hpp"

#include <vector>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

/// Hands over blocks of 2, 3 and 1 segments that start at 0, 1, ...
DrawingWork draw_six(const LSystem&, int steps, int threads,
                     const SegmentSink<PlanarSegment>& sink) {
  std::vector<PlanarSegment> all(6);
  for (std::size_t i = 0; i < all.size(); ++i) all[i].from_x = static_cast<double>(i);
  const std::span<const PlanarSegment> segments(all);
  sink(segments.first(2));
  sink(segments.subspan(2, 3));
  sink(segments.last(1));
  return {.bytes_held = static_cast<std::uint64_t>(threads),
          .modules_made = static_cast<std::uint64_t>(steps)};
}

DrawingWork write_in_space(const LSystem&, int, int, std::span<SpatialSegment>) {
  return {};
}

DerivationEngine engine_of_six() {
  DerivationEngine engine;
  engine.draw_planar = draw_six;
  engine.write = write_in_space;
  return engine;
}

std::vector<double> starts(const std::vector<PlanarSegment>& segments) {
  std::vector<double> x;
  for (const PlanarSegment& segment : segments) x.push_back(segment.from_x);
  return x;
}

TEST(CopyDrawing, CopiesEveryBlockAndSaysWhatItTook) {
  LSystemWorkload workload;
  workload.steps = 7;
  std::vector<PlanarSegment> out(6);
  const CopiedDrawing copied =
      copy_drawing(engine_of_six(), workload, 3, std::span<PlanarSegment>(out));
  EXPECT_EQ(starts(out), (std::vector<double>{0, 1, 2, 3, 4, 5}));
  EXPECT_EQ(copied.segments, 6u);
  EXPECT_EQ(copied.blocks, 3u);
  EXPECT_EQ(copied.work.modules_made, 7u);
  EXPECT_EQ(copied.work.bytes_held, 3u);
}

TEST(CopyDrawing, CountsButDoesNotWriteWhatIsTooMuch) {
  std::vector<PlanarSegment> memory(6, PlanarSegment{.from_x = -1.0});
  const CopiedDrawing copied =
      copy_drawing(engine_of_six(), {}, 1, std::span<PlanarSegment>(memory.data(), 4));
  EXPECT_EQ(copied.segments, 6u);
  EXPECT_EQ(starts(memory), (std::vector<double>{0, 1, -1, -1, -1, -1}));
}

TEST(EngineFunctions, AreThoseOfTheKindOfSegment) {
  const DerivationEngine engine = engine_of_six();
  EXPECT_EQ(draw_function<PlanarSegment>(engine), &draw_six);
  EXPECT_EQ(draw_function<SpatialSegment>(engine), nullptr);
  EXPECT_EQ(write_function<PlanarSegment>(engine), nullptr);
  EXPECT_EQ(write_function<SpatialSegment>(engine), &write_in_space);
}

}  // namespace
}  // namespace phytobench
