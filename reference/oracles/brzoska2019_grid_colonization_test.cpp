// SPDX-License-Identifier: MIT
#include "reference/oracles/brzoska2019_grid_colonization.hpp"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "reference/oracles/brzoska2019_space_colonization.hpp"

namespace phytobench::oracles::brzoska2019 {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double nan = std::numeric_limits<double>::quiet_NaN();
constexpr double full_angle = 2 * std::numbers::pi;

// A number in [0, 1) as a pure function (SplitMix64).
double draw(std::uint64_t stream, std::uint64_t index) {
  std::uint64_t z = (stream * 1'000'003 + index + 1) * 0x9e3779b97f4a7c15;
  z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9;
  z = (z ^ (z >> 27)) * 0x94d049bb133111eb;
  return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-53;
}

// Evenly in a box at the origin; an edge of 0 makes it flat.
std::vector<Point> random_points(int count, Point edges, std::uint64_t stream) {
  std::vector<Point> points;
  for (std::uint64_t i = 0; i < static_cast<std::uint64_t>(count); ++i)
    points.push_back({edges.x * draw(stream, 3 * i), edges.y * draw(stream, 3 * i + 1),
                      edges.z * draw(stream, 3 * i + 2)});
  return points;
}

std::vector<Point> random_directions(std::size_t count, std::uint64_t stream) {
  std::vector<Point> directions;
  for (Point p : random_points(static_cast<int>(count), {2, 2, 2}, stream))
    directions.push_back(equation_9(minus(p, {1, 1, 1})));
  return directions;
}

std::vector<Point> lattice(int edge) {
  std::vector<Point> points;
  for (int i = 0; i < edge * edge * edge; ++i)
    points.push_back({static_cast<double>(i % edge), static_cast<double>(i / edge % edge),
                      static_cast<double>(i / edge / edge)});
  return points;
}

std::vector<Point> slice(const std::vector<Point>& all, std::size_t begin, std::size_t end) {
  return {all.begin() + static_cast<std::ptrdiff_t>(begin),
          all.begin() + static_cast<std::ptrdiff_t>(end)};
}

GrowthProblem growth_into(std::vector<Point> points) {
  GrowthProblem problem;
  problem.attraction_points = std::move(points);
  problem.start_nodes = {{1, 0, 1}, {1, 0.25, 1}, {1, 0.5, 1}};
  problem.start_directions = {{0, 1, 0}, {0, 1, 0}, {0, 1, 0}};
  problem.start_parents = {-1, 0, 1};
  problem.iterations = 30;
  problem.D = 0.1;
  problem.d_i = 0.5;
  problem.theta_rad = 2.5;
  problem.g = {0, 0.2, 0};
  problem.d_c = [](int i) { return 0.3 - 0.005 * i; };
  return problem;
}

GrowthProblem random_cube() {
  return growth_into(random_points(240, {2, 2, 2}, 1));
}

GrowthProblem dense_cube() {
  return growth_into(random_points(1500, {2, 2, 2}, 2));
}

template <class Change>
GrowthProblem changed(GrowthProblem problem, Change change) {
  change(problem);
  return problem;
}

GrowthProblem moved_and_scaled(GrowthProblem problem, Point offset, double factor) {
  for (auto* points : {&problem.attraction_points, &problem.start_nodes})
    for (Point& p : *points) p = times(factor, plus(p, offset));
  problem.D *= factor;
  problem.d_i *= factor;
  problem.d_c = [factor, d_c = problem.d_c](int i) { return factor * d_c(i); };
  return problem;
}

// Integer coordinates, so that many nodes are equally near and many points exactly at the limit.
GrowthProblem lattice_with_ties() {
  GrowthProblem problem = growth_into(lattice(7));
  problem.start_nodes.clear();
  for (Point p : lattice(4)) problem.start_nodes.push_back(times(2, p));
  problem.start_directions.assign(problem.start_nodes.size(), {0, 1, 0});
  problem.start_parents.assign(problem.start_nodes.size(), 0);
  problem.start_parents[0] = -1;
  problem.theta_rad = std::numbers::pi;
  problem.D = 1;
  problem.d_i = 2;
  problem.g = {0, 0, 0};
  problem.d_c = [](int) { return 1.0; };
  return problem;
}

GrowthProblem duplicates() {
  GrowthProblem problem = random_cube();
  auto& points = problem.attraction_points;
  for (std::size_t i = 0; i < 240; i += 2) points.push_back(points[i]);
  points.insert(points.end(), {problem.start_nodes[2], problem.start_nodes[2]});
  problem.start_nodes.push_back(problem.start_nodes[2]);
  problem.start_directions.push_back({1, 0, 0});
  problem.start_parents.push_back(2);
  return problem;
}

struct Named {
  const char* name;
  GrowthProblem problem;
};

std::vector<Named> problems() {
  const auto with = [](auto change) { return changed(random_cube(), change); };
  const auto with_points = [&](std::vector<Point> more) {
    return with([&](auto& p) {
      p.attraction_points.insert(p.attraction_points.end(), more.begin(), more.end());
    });
  };
  const auto see_all = [](auto& p) { p.theta_rad = full_angle; };
  const auto at = [](Point p, double f) { return moved_and_scaled(random_cube(), p, f); };
  return {
      {"random cube", random_cube()},
      {"dense cube", dense_cube()},
      {"lattice with ties", lattice_with_ties()},
      {"duplicates", duplicates()},
      {"plane", growth_into(random_points(200, {2, 2, 0}, 3))},
      {"plane through the stem",
       moved_and_scaled(growth_into(random_points(200, {0, 2, 2}, 4)), {1, 0, 0}, 1)},
      {"line", moved_and_scaled(growth_into(random_points(100, {0, 3, 0}, 5)), {1, 0, 1}, 1)},
      {"one point", growth_into({{1.1, 0.7, 1}})},
      {"the same point", growth_into(std::vector<Point>(20, Point{1.1, 0.7, 1}))},
      {"no point", growth_into({})},
      {"one point far away", with_points({{1e9, -1e9, 0}})},
      {"extent overflows", with_points({{1.7e308, 0, 0}, {-1.7e308, 0, 0}})},
      {"no number", with_points({{nan, 0, 0}, {0, 0, nan}})},
      {"no number, full angle", changed(with_points({{nan, 0, 0}}), see_all)},
      {"infinite coordinates", with_points({{infinity, 0, 0}, {0, -infinity, 0}})},
      {"infinite coordinates, full angle", changed(with_points({{0, infinity, 0}}), see_all)},
      {"cloud out of reach", with([](auto& p) {
         p.start_nodes[0] = p.start_nodes[1] = {9, 9, 9};
       })},
      {"infinite d_i", with([](auto& p) { p.d_i = infinity; })},
      {"d_i whose square is infinite", with([](auto& p) { p.d_i = 1e200; })},
      {"d_i as wide as the cloud", with([](auto& p) { p.d_i = 3.5; })},
      {"tiny d_i", with([](auto& p) { p.d_i = 1e-3; })},
      {"no d_i", changed(duplicates(), [](auto& p) { p.d_i = 0; })},
      {"full angle", with(see_all)},
      {"narrow angle", with([](auto& p) { p.theta_rad = 0.7; })},
      {"d_c above d_i", with([](auto& p) { p.d_c = [](int) { return 0.6; }; })},
      {"d_c of zero", changed(duplicates(), [](auto& p) { p.d_c = [](int) { return 0.0; }; })},
      {"infinite d_c", with([](auto& p) { p.d_c = [](int) { return infinity; }; })},
      {"huge", at({0, 0, 0}, 1e150)},
      {"squares overflow", at({0, 0, 0}, 1e160)},
      {"everything overflows", at({-1, -1, -1}, 1.7e308)},
      {"tiny", at({0, 0, 0}, 1e-150)},
      {"squares underflow", at({0, 0, 0}, 1e-161)},
      {"squares vanish", at({0, 0, 0}, 1e-170)},
      {"far from the origin", at({1e8, -1e8, 1e8}, 1)},
      {"coordinates merge", at({3e15, -3e15, 3e15}, 1)},
      {"crown stem kills",
       changed(dense_cube(), [](auto& p) { p.departures.crown_stem_kills = true; })},
      {"all nodes kill", with([](auto& p) { p.departures.all_nodes_kill = true; })},
      {"angle after the search", with([](auto& p) { p.departures.cone_after_search = true; })},
      {"repeated children", with([](auto& p) { p.departures.no_repeat_guard = true; })},
      {"deferred removal", with([](auto& p) { p.deferred.enabled = true; })},
  };
}

// What the literal oracle's removal i is made with, its nodes so far being `grown` of them.
std::vector<Point> killers(const GrowthProblem& problem, const GrownTree& tree, std::size_t i,
                           std::size_t grown) {
  if (problem.departures.all_nodes_kill) return slice(tree.nodes, 0, grown);
  std::vector<Point> found = slice(tree.nodes, tree.passes[i].nodes_seen, grown);
  if (i > 0) return found;
  const std::size_t stem = problem.departures.crown_stem_kills ? problem.start_nodes.size() : 1;
  const std::vector<Point> start = slice(tree.nodes, 0, stem);
  found.insert(found.end(), start.begin(), start.end());
  return found;
}

/// Where the judge first differs; empty if nowhere.
struct Differences {
  std::string assignment, removal, recomputation;

  bool none() const { return assignment.empty() && removal.empty() && recomputation.empty(); }
};

/// Tells the judge of a problem what grew in the literal oracle, and compares every answer.
Differences differences(const GrowthProblem& told, const GrownTree& truth) {
  GridJudge judge(told.attraction_points, told.d_i,
                  told.departures.cone_after_search ? full_angle : told.theta_rad);
  Differences first;
  const auto note = [](std::string& where, bool same, std::size_t i) {
    if (!same && where.empty()) where = "iteration " + std::to_string(i);
  };
  for (std::size_t i = 0; i < truth.passes.size(); ++i) {
    const std::size_t seen = truth.passes[i].nodes_seen, known = judge.nodes().size();
    const std::vector<int>& nearest =
        judge.associate(slice(truth.nodes, known, seen), slice(truth.directions, known, seen));
    note(first.assignment, nearest == truth.passes[i].nearest, i);
    for (std::size_t s = 0; s < nearest.size(); ++s)
      note(first.recomputation, judge.recompute(s) == nearest[s], i);
    if (i >= truth.removals.size()) continue;
    const std::size_t grown =
        i + 1 < truth.passes.size() ? truth.passes[i + 1].nodes_seen : truth.nodes.size();
    const std::vector<int> removed =
        judge.remove(killers(told, truth, i, grown), told.d_c(static_cast<int>(i)));
    note(first.removal, removed == truth.removals[i], i);
  }
  return first;
}

TEST(GridJudgeOracle, AgreesWithTheLiteralOracleInEveryIteration) {
  for (const auto& [name, problem] : problems()) {
    SCOPED_TRACE(name);
    const GrownTree truth = grow(problem);
    ASSERT_FALSE(truth.passes.empty());
    ASSERT_LE(truth.removals.size(), truth.passes.size());
    const Differences first = differences(problem, truth);
    EXPECT_EQ(first.assignment, "");
    EXPECT_EQ(first.removal, "");
    EXPECT_EQ(first.recomputation, "");
  }
}

// Agreement says something only where there is something to disagree about.
TEST(GridJudgeOracle, IsTriedOnGrowthWithEveryKindOfAnswer) {
  for (const GrowthProblem& problem : {random_cube(), lattice_with_ties(), duplicates()}) {
    const GrownTree truth = grow(problem);
    std::size_t answers = 0, none = 0, later_nodes = 0, removed = 0;
    for (const GrowthPass& pass : truth.passes)
      for (int v : pass.nearest) {
        ++(v < 0 ? none : answers);
        if (v >= static_cast<int>(problem.start_nodes.size())) ++later_nodes;
      }
    for (const auto& removal : truth.removals) removed += removal.size();
    EXPECT_GT(truth.passes.size(), 4u);
    EXPECT_GT(answers, 100u);
    EXPECT_GT(none, 100u);
    EXPECT_GT(later_nodes, 20u);
    EXPECT_GT(removed, 20u);
  }
}

TEST(GridJudgeOracle, DisagreesWhenItIsToldSomethingElse) {
  const GrowthProblem problem = dense_cube();
  const GrownTree truth = grow(problem);
  ASSERT_TRUE(differences(problem, truth).none());
  const auto told = [&](auto change) { return differences(changed(problem, change), truth); };
  EXPECT_NE(told([](auto& p) { p.d_i *= 0.9; }).assignment, "");
  EXPECT_NE(told([](auto& p) { p.d_i *= 1.1; }).assignment, "");
  EXPECT_NE(told([](auto& p) { p.theta_rad *= 0.9; }).assignment, "");
  EXPECT_NE(told([](auto& p) { p.attraction_points[100].x += 0.1; }).assignment, "");
  EXPECT_NE(told([](auto& p) { p.departures.crown_stem_kills = true; }).removal, "");
}

TEST(GridJudgeOracle, DisagreesWhenOneRemovedPointIsKept) {
  GrowthProblem problem = random_cube();
  problem.theta_rad = full_angle;
  GrownTree truth = grow(problem);
  // Shorten the first kill distance so far that its farthest point stays.
  const auto killing = killers(problem, truth, 0, truth.passes[1].nodes_seen);
  double farthest = 0;
  for (int s : truth.removals[0]) {
    double squared = infinity;
    for (Point killer : killing)
      squared = std::min(
          squared, equation_24(problem.attraction_points[static_cast<std::size_t>(s)], killer));
    farthest = std::max(farthest, squared);
  }
  ASSERT_GT(farthest, 0);
  problem.d_c = [farthest, d_c = problem.d_c](int i) {
    return i == 0 ? std::sqrt(farthest) * (1 - 1e-9) : d_c(i);
  };
  EXPECT_EQ(differences(problem, truth).removal, "iteration 0");
  EXPECT_EQ(differences(problem, truth).assignment, "iteration 1");
}

TEST(GridJudgeOracle, GivesTiesOnALatticeToTheLowestIndex) {
  const std::vector<Point> points = lattice(9), nodes = lattice(5);
  GridJudge judge(points, 2.0, full_angle);
  std::vector<Point> fed;
  int ties = 0;
  for (std::size_t batch = 0; batch < 5; ++batch) {
    std::vector<Point> fresh;
    for (std::size_t v = batch; v < nodes.size(); v += 5) fresh.push_back(times(2, nodes[v]));
    fed.insert(fed.end(), fresh.begin(), fresh.end());
    const auto& nearest = judge.associate(fresh, random_directions(fresh.size(), batch));
    for (std::size_t s = 0; s < points.size(); ++s) {
      int lowest = -1, equally_near = 0;
      double shortest = 4;
      for (std::size_t v = 0; v < fed.size(); ++v) {
        const double squared = equation_24(points[s], fed[v]);
        if (squared == shortest) ++equally_near;
        if (squared > shortest || (squared == shortest && lowest >= 0)) continue;
        equally_near = 1;
        lowest = static_cast<int>(v);
        shortest = squared;
      }
      ties += equally_near > 1;
      ASSERT_EQ(nearest[s], lowest);
      ASSERT_EQ(judge.recompute(s), lowest);
    }
  }
  EXPECT_GT(ties, 500);
}

// Boxes of all shapes and sizes, nodes inside and far outside, distances of every proportion.
TEST(GridJudgeOracle, AgreesWithPlainLoopsOnRandomScenes) {
  for (std::uint64_t scene = 0; scene < 400; ++scene) {
    SCOPED_TRACE(scene);
    const auto number = [scene](std::uint64_t i) { return draw(1000 + scene, i); };
    const double scale = std::pow(10, std::floor(scene % 4 ? 0 : 300 * number(0) - 160));
    const auto edge = [&](std::uint64_t i) {
      return number(i) < 0.2 ? 0.0 : scale * std::pow(10, 2 * number(i + 3) - 1);
    };
    const Point edges{edge(1), edge(2), edge(3)};
    const auto points = random_points(static_cast<int>(200 * number(7)), edges, 2000 + scene);
    const double d_i = scale * std::pow(10, 3 * number(8) - 2);
    GridJudge judge(points, d_i, number(9) < 0.3 ? full_angle : 6 * number(10));
    std::vector<char> gone(points.size(), 0);
    for (std::uint64_t batch = 0; batch < 4; ++batch) {
      auto nodes = random_points(15, times(batch == 3 ? 9 : 3, edges), 10 * scene + batch);
      for (Point& node : nodes) node = minus(node, edges);
      const auto& nearest = judge.associate(nodes, random_directions(nodes.size(), scene + batch));
      for (std::size_t s = 0; s < points.size(); ++s) ASSERT_EQ(nearest[s], judge.recompute(s));
      const double d_c = d_i * 2 * number(20 + batch);
      std::vector<int> expected;
      for (std::size_t s = 0; s < points.size(); ++s) {
        bool near = false;
        for (Point node : nodes) near = near || equation_24(points[s], node) <= d_c * d_c;
        if (!near || gone[s]) continue;
        gone[s] = 1;
        expected.push_back(static_cast<int>(s));
      }
      ASSERT_EQ(judge.remove(nodes, d_c), expected);
      for (int s : expected) ASSERT_EQ(judge.recompute(static_cast<std::size_t>(s)), -1);
    }
    EXPECT_EQ(judge.live_points(),
              static_cast<std::size_t>(std::count(gone.begin(), gone.end(), 0)));
  }
}

TEST(GridJudgeOracle, TakesNodesFromAnywhere) {
  const std::vector<Point> strange = {{nan, 0, 0}, {infinity, 1, 1}, {1, -infinity, 1},
                                      {0, 0, nan}, {1e308, 1, 1},    {-1e308, 1e308, 1},
                                      {1, 1, 1e9}, {1, 1, 1}};
  for (double d_i : {0.5, 2e9, 1e308, infinity, nan})
    for (double theta : {2.0, full_angle}) {
      auto points = random_points(100, {2, 2, 2}, 6);
      for (int round = 0; round < 2; ++round) {
        GridJudge judge(points, d_i, theta);
        for (Point node : strange) {
          const auto& nearest = judge.associate({node}, {{0, 1, 0}});
          for (std::size_t s = 0; s < points.size(); ++s) ASSERT_EQ(nearest[s], judge.recompute(s));
        }
        points.insert(points.end(), strange.begin(), strange.end());
      }
    }
}

// The way to the second point is longer than d_i, but is d_i as rounded; node + d_i rounds to a
// coordinate before that point.
TEST(GridJudgeOracle, ReachesAPointThatRoundingBringsIn) {
  GridJudge judge({{0, 0, 0}, {0.5, 0, 0}, {1, 0, 0}}, 0.5, full_angle);
  const Point node{-0x1.8p-55, 0, 0};
  ASSERT_LT(node.x + 0.5, 0.5);
  EXPECT_EQ(judge.associate({node}, {{1, 0, 0}}), (std::vector<int>{0, 0, -1}));
}

TEST(GridJudgeOracle, HasNoMoreCellsThanPoints) {
  for (Point edges : {Point{2, 2, 2}, Point{1e3, 0, 0}, Point{1e-9, 1e9, 1}, Point{0, 0, 0},
                      Point{1e308, 1e308, 1e-308}})
    for (double d : {0.0, 1e-200, 0.01, 0.5, 1e9, infinity})
      for (int count : {0, 1, 2, 1000}) {
        const PointGrid grid(random_points(count, edges, 7), d);
        EXPECT_GE(grid.cells(), 1u);
        EXPECT_LE(grid.cells(), std::max<std::size_t>(1, static_cast<std::size_t>(count)));
      }
  // And not one for everything, where there is something to divide.
  EXPECT_GT(PointGrid(random_points(1000, {2, 2, 2}, 7), 0.2).cells(), 500u);
}

TEST(GridJudgeOracle, WantsADirectionForEveryNode) {
  GridJudge judge({{0, 0, 0}}, 1, full_angle);
  EXPECT_THROW(judge.associate({{0, 0, 0}}, {}), std::invalid_argument);
}

}  // namespace
}  // namespace phytobench::oracles::brzoska2019
