// SPDX-License-Identifier: MIT
#include "core/lsystem/segment_stream.hpp"

#include <algorithm>
#include <cstring>
#include <limits>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/test_literal_turtle.hpp"
#include "core/lsystem/test_systems.hpp"

namespace phytobench {
namespace {

using testing::HasSubstr;

constexpr std::uint64_t too_many = std::numeric_limits<std::uint64_t>::max();

LSystem dragon() {
  return test_system("dragon", "FX", {{'X', "X+YF+"}, {'Y', "-FX-Y"}}, 90);
}

std::string refusal_of(const LSystem& system, int steps) {
  try {
    const SegmentStream stream(system, steps);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

TEST(SegmentStream, CountsWithoutDrawing) {
  const SegmentStream few(dragon(), 3);
  EXPECT_EQ(few.segment_count(), 8u);
  EXPECT_EQ(few.module_count(), literal_word(dragon(), 3).size());
  const SegmentStream many(dragon(), 60);
  EXPECT_EQ(many.segment_count(), std::uint64_t{1} << 60);
  EXPECT_TRUE(many.planar());
  const SegmentStream no_end(dragon(), 2'000);
  EXPECT_EQ(no_end.segment_count(), too_many);
  EXPECT_EQ(no_end.module_count(), too_many);
}

TEST(SegmentStream, CountsWhatTheWordHolds) {
  for (const auto& [system, steps] : all_test_cases()) {
    const SegmentStream stream(system, steps);
    const std::string word = literal_word(system, steps);
    const auto draws = [&, &draw = system.turtle.draws](char c) {
      return draw.find(c) != std::string::npos;
    };
    EXPECT_EQ(stream.module_count(), word.size()) << system.source;
    EXPECT_EQ(stream.segment_count(),
              static_cast<std::uint64_t>(std::count_if(word.begin(), word.end(), draws)))
        << system.source;
  }
}

/// What it keeps stays in a cache, whatever the system and however many its steps.
TEST(SegmentStream, KeepsLittle) {
  for (const auto& [system, steps] : all_test_cases())
    for (const int more : {steps, steps + 5, 1'000}) {
      const std::size_t bytes = SegmentStream(system, more).block_bytes();
      EXPECT_LE(bytes, 257u * 1024) << system.source;
    }
  EXPECT_GT(SegmentStream(dragon(), 20).block_bytes(), 8'000u);
}

TEST(SegmentStream, GivesTheBeginningOfWhatHasNoEnd) {
  struct Enough {};
  const SegmentStream stream(dragon(), 300);
  std::vector<SpatialSegment> found;
  const SegmentSink<PlanarSegment> sink = [&](std::span<const PlanarSegment> block) {
    for (const PlanarSegment& segment : block) found.push_back(in_space(segment));
    if (found.size() > 10'000) throw Enough{};
  };
  EXPECT_THROW(stream.stream(sink), Enough);
  const LiteralDrawing first = literal_drawing(dragon(), 14);
  found.resize(1u << 13);
  EXPECT_EQ(
      difference_from({{first.segments.begin(), first.segments.begin() + (1 << 13)}, 0.0}, found),
      "");
}

TEST(SegmentStream, DeepChainsNeedNoDeepCalls) {
  const LSystem line = test_system("line", "A", {{'A', "FA"}}, 90);
  const SegmentStream stream(line, 200'000);
  std::uint64_t segments = 0;
  double end = 0.0;
  stream.stream(SegmentSink<PlanarSegment>([&](std::span<const PlanarSegment> block) {
    segments += block.size();
    end = block.back().to_y;
  }));
  EXPECT_EQ(segments, 200'000u);
  EXPECT_EQ(end, 200'000.0);
  const LSystem nest = test_system("nest", "A", {{'A', "F[+A]F"}}, 90);
  segments = 0;
  SegmentStream(nest, 200'000)
      .stream(SegmentSink<PlanarSegment>(
          [&](std::span<const PlanarSegment> block) { segments += block.size(); }));
  EXPECT_EQ(segments, 400'000u);
}

TEST(SegmentStream, LongChainsOfWhatDrawsNothingAreShort) {
  const LSystem chain = test_system("chain", "FA", {{'A', "BB"}, {'B', "[A+]A"}}, 90);
  const SegmentStream stream(chain, 300);
  EXPECT_EQ(stream.segment_count(), 1u);
  EXPECT_EQ(stream.module_count(), too_many);
  std::uint64_t segments = 0;
  stream.stream(SegmentSink<SpatialSegment>(
      [&](std::span<const SpatialSegment> block) { segments += block.size(); }));
  EXPECT_EQ(segments, 1u);
}

TEST(SegmentStream, WritesNothingBesideItsPlace) {
  for (const auto& [system, steps] : all_test_cases()) {
    const SegmentStream stream(system, steps);
    const SpatialSegment guard{{-7, -7, -7}, {7, 7, 7}};
    std::vector<SpatialSegment> all(stream.segment_count() + 2, guard);
    stream.write(std::span(all).subspan(1, all.size() - 2), 2);
    for (const SpatialSegment& edge : {all.front(), all.back()})
      EXPECT_EQ(0, std::memcmp(&edge, &guard, sizeof(guard))) << system.source;
    EXPECT_TRUE(std::none_of(all.begin() + 1, all.end() - 1, [](const SpatialSegment& s) {
      return s.from.x == -7 && s.to.z == 7;
    })) << system.source;
  }
}

TEST(SegmentStream, RefusesWhatDependsOnMoreThanTheSymbol) {
  const auto with = [](const std::string& letters) {
    return test_system("x", "F" + letters, {{'F', "FF"}}, 90);
  };
  EXPECT_EQ(objection_to_streaming(with("+-|[]{}.!'")), "");
  EXPECT_THAT(objection_to_streaming(with("%")), HasSubstr("%"));
  EXPECT_THAT(objection_to_streaming(with("$")), HasSubstr("$"));
  LSystem system = with("");
  system.symbols.push_back({"?P", 0});
  EXPECT_THAT(objection_to_streaming(system), HasSubstr("?P"));
  system = with("");
  system.symbols.push_back({"A", 1});
  EXPECT_THAT(objection_to_streaming(system), HasSubstr("parameters"));
  system = with("");
  system.productions[0].left = {{0, 0}};
  EXPECT_THAT(objection_to_streaming(system), HasSubstr("contexts"));
  system = with("");
  system.productions[0].condition = Expression(1.0);
  EXPECT_THAT(objection_to_streaming(system), HasSubstr("conditions"));
  system = with("");
  system.productions[0].probability = 0.5;
  EXPECT_THAT(objection_to_streaming(system), HasSubstr("lots"));
  EXPECT_THAT(objection_to_streaming(test_system("x", "[F]", {{'[', "["}}, 90)),
              HasSubstr("bracket"));
  EXPECT_THAT(refusal_of(with("%"), 1), HasSubstr("x: cuts"));
}

TEST(SegmentStream, RefusesStepsThatItCannotCount) {
  EXPECT_THAT(refusal_of(dragon(), -1), HasSubstr("-1 derivations"));
  EXPECT_THAT(refusal_of(dragon(), std::numeric_limits<int>::max()), HasSubstr("400000 times"));
}

TEST(SegmentStream, LinesInSpaceAreNotForThePlane) {
  const SegmentStream stream(test_system("x", "F/F", {}, 90), 1);
  EXPECT_FALSE(stream.planar());
  EXPECT_THROW(stream.stream(SegmentSink<PlanarSegment>([](std::span<const PlanarSegment>) {})),
               ContractViolation);
}

}  // namespace
}  // namespace phytobench
