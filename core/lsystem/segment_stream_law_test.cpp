// SPDX-License-Identifier: MIT
// What must hold of every drawing, whatever the system.
#include <algorithm>
#include <cmath>
#include <tuple>

#include <gtest/gtest.h>

#include "core/lsystem/segment_stream.hpp"
#include "core/lsystem/test_literal_turtle.hpp"
#include "core/lsystem/test_systems.hpp"
#include "core/memory/large_array.hpp"
#include "core/parallel/vector_targets.hpp"

namespace phytobench {
namespace {

using Segments = std::vector<SpatialSegment>;

Segments drawn(const LSystem& system, int steps) {
  Segments all;
  SegmentStream(system, steps).stream(collector<SpatialSegment>(all));
  return all;
}

/// Past what small caches hold, and more than one task for each thread.
std::vector<TestCase> large_test_cases() {
  return {test_case("island", "F-F-F-F", {{'F', "F-F+F+FF-F-F+F"}}, 90, 6),
          test_case("plant", "X", {{'X', "F-[[X]+X]+F[+FX]-X"}, {'F', "FF"}}, 22.5, 9),
          test_case("no fraction", "F", {{'F', "F[+F]F[-F][F]"}}, std::sqrt(3.0) * 14, 8),
          test_case("in space", "F", {{'F', "F[&F]F/[^F]F"}}, 27.3, 8),
          test_case("along the way", "A", {{'A', "FB[A]"}, {'B', "F+B"}}, 3, 900)};
}

template <class Segment>
LargeArray<Segment> written(const SegmentStream& stream, int threads) {
  LargeArray<Segment> all;
  all.resize_for_overwrite(stream.segment_count());
  stream.write(std::span(all.data(), all.size()), threads);
  return all;
}

template <class Segment>
std::span<const Segment> all_of(const LargeArray<Segment>& array) {
  return {array.data(), array.size()};
}

template <class Segment>
void expect_same_bits(const SegmentStream& stream, const std::string& name) {
  const auto one = written<Segment>(stream, 1);
  for (const int threads : {2, 3, 5})
    EXPECT_TRUE(are_equal(all_of(one), all_of(written<Segment>(stream, threads)))) << name;
  std::size_t at = 0;
  bool is_same = true;
  stream.stream(SegmentSink<Segment>([&](std::span<const Segment> block) {
    ASSERT_LE(at + block.size(), one.size()) << name;
    is_same = is_same && are_equal(block, all_of(one).subspan(at, block.size()));
    at += block.size();
  }));
  EXPECT_EQ(at, one.size()) << name;
  EXPECT_TRUE(is_same) << name;
}

TEST(SegmentStreamLaw, ThreadsAndWaysToTakeItGiveTheSameBits) {
  for (const auto& [system, steps] : large_test_cases()) {
    const SegmentStream stream(system, steps);
    EXPECT_GT(stream.segment_count(), 200'000u) << system.source;
    if (stream.planar()) expect_same_bits<PlanarSegment>(stream, system.source);
    expect_same_bits<SpatialSegment>(stream, system.source);
  }
}

TEST(SegmentStreamLaw, EveryVectorTargetGivesTheSameBits) {
  for (const auto& [system, steps] : all_test_cases()) {
    const Segments first = drawn(system, steps);
    for (const std::int64_t target : vector_targets()) {
      const ForcedTarget forced(target);
      EXPECT_TRUE(are_equal(drawn(system, steps), first)) << system.source;
    }
  }
}

/// Deriving once more is the same as deriving what one derivation has made.
TEST(SegmentStreamLaw, AStepCanBeTakenBefore) {
  for (const auto& [system, steps] : all_test_cases()) {
    if (steps == 0) continue;
    LSystem derived = system;
    derived.axiom.clear();
    for (const char c : literal_word(system, 1))
      derived.axiom.push_back({test_symbol(derived, c), {}});
    const Segments at_once = drawn(system, steps), later = drawn(derived, steps - 1);
    ASSERT_EQ(at_once.size(), later.size()) << system.source;
    const double bound = literal_drawing(system, steps).bound;
    for (std::size_t i = 0; i < at_once.size(); ++i)
      EXPECT_LE(norm(at_once[i].to - later[i].to), 4.0 * bound) << system.source << " " << i;
  }
}

/// Without branches and moves the pen never leaves the paper: the end of one segment is the start
/// of the next, to the last bit.
TEST(SegmentStreamLaw, LinesWithoutBranchesAreConnected) {
  std::size_t looked_at = 0;
  for (const auto& [system, steps] : all_test_cases()) {
    const std::string word = literal_word(system, steps);
    if (word.find_first_of("[" + system.turtle.moves) != std::string::npos) continue;
    const Segments all = drawn(system, steps);
    for (std::size_t i = 1; i < all.size(); ++i)
      ASSERT_EQ(all[i].from, all[i - 1].to) << system.source << " " << i;
    looked_at += all.size();
  }
  EXPECT_GT(looked_at, 30'000u);
}

TEST(SegmentStreamLaw, EverySegmentIsAsLongAsAStep) {
  for (const auto& [system, steps] : all_test_cases()) {
    const double bound = literal_drawing(system, steps).bound;
    for (const SpatialSegment& s : drawn(system, steps))
      ASSERT_NEAR(norm(s.to - s.from), system.turtle.step, 4.0 * bound) << system.source;
  }
}

/// Doubling is exact in binary, so a step twice as long doubles every number.
TEST(SegmentStreamLaw, TwiceTheStepIsTwiceTheDrawing) {
  for (const auto& [system, steps] : all_test_cases()) {
    LSystem doubled = system;
    doubled.turtle.step *= 2.0;
    const Segments once = drawn(system, steps), twice = drawn(doubled, steps);
    ASSERT_EQ(once.size(), twice.size());
    for (std::size_t i = 0; i < once.size(); ++i)
      ASSERT_EQ(2.0 * once[i].to, twice[i].to) << system.source << " " << i;
  }
}

/// [Liebemann2017] fig. 2.4: 4 * 8^n segments, closed, about an area that no step changes.
TEST(SegmentStreamLaw, TheKochIslandKeepsItsArea) {
  for (int steps = 0; steps <= 5; ++steps) {
    LSystem island = test_system("island", "F-F-F-F", {{'F', "F-F+F+FF-F-F+F"}}, 90);
    island.turtle.step = 256.0 / std::pow(4.0, steps);
    const Segments all = drawn(island, steps);
    EXPECT_EQ(all.size(), std::size_t{4} << (3 * steps));
    EXPECT_EQ(all.back().to, Vector3{});
    double twice_area = 0.0;
    for (const SpatialSegment& s : all) twice_area += s.from.x * s.to.y - s.to.x * s.from.y;
    EXPECT_EQ(twice_area, -2.0 * 256.0 * 256.0) << steps;
  }
}

/// [Brzoska2019] eq. 5: each step puts three times as much between the ends.
TEST(SegmentStreamLaw, TheKochCurveEndsThreeTimesAsFarAway) {
  const LSystem curve = test_system("curve", "F", {{'F', "F+F--F+F"}}, 60);
  for (int steps = 0; steps <= 9; ++steps) {
    const Segments all = drawn(curve, steps);
    const double distance = std::pow(3.0, steps);
    EXPECT_EQ(all.size(), std::size_t{1} << (2 * steps));
    EXPECT_NEAR(norm(all.back().to), distance, 1e-12 * distance);
  }
}

/// A Hilbert curve comes to every cell of its cube once.
TEST(SegmentStreamLaw, TheHilbertCurveFillsItsCube) {
  for (const TestCase& test : spatial_test_cases()) {
    if (test.system.source != "hilbert in space") continue;
    const Segments all = drawn(test.system, test.steps);
    std::vector<Vector3> cells{all.front().from};
    for (const SpatialSegment& s : all) cells.push_back(s.to);
    EXPECT_EQ(cells.size(), std::size_t{1} << (3 * test.steps));
    const auto before = [](const Vector3& a, const Vector3& b) {
      return std::tie(a.x, a.y, a.z) < std::tie(b.x, b.y, b.z);
    };
    std::sort(cells.begin(), cells.end(), before);
    EXPECT_EQ(std::adjacent_find(cells.begin(), cells.end()), cells.end());
    const double side = std::pow(2.0, test.steps) - 1.0;
    for (const double Vector3::*axis : {&Vector3::x, &Vector3::y, &Vector3::z}) {
      const auto [low, high] = std::minmax_element(
          cells.begin(), cells.end(),
          [&](const Vector3& a, const Vector3& b) { return a.*axis < b.*axis; });
      EXPECT_EQ((*high).*axis - (*low).*axis, side);
    }
    return;
  }
  ADD_FAILURE() << "no such curve";
}

}  // namespace
}  // namespace phytobench
