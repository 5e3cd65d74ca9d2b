// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/drawing_judge.hpp"

#include <cmath>
#include <cstring>

#include <gtest/gtest.h>

#include "benchmarks/lsystem/literal_turtle.hpp"
#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {
namespace {

using Vector = LiteralDrawer::Vector;

std::vector<SegmentEnds<long double>> literally(const std::string& text, int steps) {
  const LSystem system = parse_lsystem(text, "x");
  std::vector<SegmentEnds<long double>> all;
  LiteralDrawer(system).draw(steps, [&](const Vector& a, const Vector& b) {
    all.push_back({a[0], a[1], a[2], b[0], b[1], b[2]});
  });
  return all;
}

using Ends = SegmentEnds<long double>;

TEST(LiteralDrawer, DoesWhatLettersSay) {
  const auto line = literally("axiom: F+F[-fF]|F\nangle: 90\n", 0);
  ASSERT_EQ(line.size(), 4u);
  EXPECT_EQ(line[0], (Ends{0, 0, 0, 0, 1, 0}));
  EXPECT_EQ(line[1], (Ends{0, 1, 0, -1, 1, 0}));   // left
  EXPECT_EQ(line[2], (Ends{-1, 2, 0, -1, 3, 0}));  // up again, past a move
  EXPECT_EQ(line[3], (Ends{-1, 1, 0, 0, 1, 0}));   // from the bracket, and back
  const auto space = literally("axiom: &F\\+F/^F\nangle: 90\n", 0);
  ASSERT_EQ(space.size(), 3u);
  EXPECT_EQ(space[0], (Ends{0, 0, 0, 0, 0, -1}));    // down is away from up, which is +z
  EXPECT_EQ(space[1], (Ends{0, 0, -1, 0, -1, -1}));  // rolled left, the left side was below
}

TEST(LiteralDrawer, ReplacesAllLettersAtOnce) {
  EXPECT_EQ(literally("axiom: AF\nA -> FB\nB -> A\nF -> FF\nangle: 90\n", 3).size(), 4u + 1u + 8u);
}

TEST(DrawingJudge, TakesARoundedDrawingAndNoOther) {
  const LSystemWorkload workload = lsystem_workload("plant", 100'000);
  const DrawingJudge judge(workload);
  EXPECT_GT(judge.bound(), 0.0);
  EXPECT_LT(judge.bound(), 1e-8);
  std::vector<PlanarSegment> all;
  LiteralDrawer(workload.system).draw(workload.steps, [&](const Vector& a, const Vector& b) {
    const auto number = [](long double n) { return static_cast<double>(n); };
    all.push_back({number(a[0]), number(a[1]), number(b[0]), number(b[1])});
  });
  const auto said_of = [&](std::size_t place, double by) {
    std::vector<PlanarSegment> changed = all;
    changed[place].to_y += by;
    DrawingDigest digest;
    digest.add(std::span<const PlanarSegment>(changed));
    return judge.disagreement(digest);
  };
  EXPECT_EQ(said_of(0, 0.0), "");
  EXPECT_EQ(said_of(5, 0.5 * judge.bound()), "");
  EXPECT_NE(said_of(5, 3.0 * judge.bound()), "");
  EXPECT_NE(said_of(all.size() - 2, 3.0 * judge.bound()), "");
  EXPECT_NE(said_of(all.size() / 2, 1.0), "");
}

/// Where all numbers are whole, nothing may be off.
TEST(DrawingJudge, KnowsWhatIsExact) {
  for (const char* name : {"koch_island", "hilbert_curve", "dragon_curve"})
    EXPECT_EQ(DrawingJudge(lsystem_workload(name, 5'000)).bound(), 0.0) << name;
  for (const char* name : {"gosper_curve", "bush"})
    EXPECT_GT(DrawingJudge(lsystem_workload(name, 5'000)).bound(), 0.0) << name;
}

}  // namespace
}  // namespace phytobench
