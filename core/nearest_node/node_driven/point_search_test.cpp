// SPDX-License-Identifier: MIT
// Both searches of the node-driven engine against a plain loop, for every vector instruction set of
// this processor, any number of threads, and sizes at which corner cases are common.
#include "core/nearest_node/node_driven/point_search.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <gtest/gtest.h>

#include "core/nearest_node/node_driven/row_search.hpp"
#include "core/nearest_node/node_driven/tree_search.hpp"
#include "core/nearest_node/perception.hpp"
#include "core/parallel/vector_targets.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

/// Points, and batches of nodes that arrive among them.
struct Scene {
  std::string name;
  std::vector<Vector3> points;
  std::vector<std::vector<SearchableNode>> batches;
  double reach;
  double kill_distance;
  double half_angle_rad = 80.0 * std::numbers::pi / 180.0;
};

Vector3 random_unit_vector(CounterStream& stream) {
  for (;;) {
    const Vector3 v{stream.next_between(-1, 1), stream.next_between(-1, 1),
                    stream.next_between(-1, 1)};
    if (squared_norm(v) > 0.01 && squared_norm(v) <= 1.0) return v / norm(v);
  }
}

/// Nodes near random points of the cloud, so that they have something to find.
std::vector<std::vector<SearchableNode>> nodes_among(const std::vector<Vector3>& points,
                                                     std::size_t batches, std::size_t size,
                                                     double distance, CounterStream& stream) {
  std::vector<std::vector<SearchableNode>> all(batches);
  for (auto& batch : all)
    for (std::size_t i = 0; i < size; ++i) {
      const auto pick =
          static_cast<std::size_t>(stream.next_unit() * static_cast<double>(points.size()));
      const Vector3 centre = points.empty() ? Vector3{} : points[pick];
      batch.push_back({centre + distance * random_unit_vector(stream), random_unit_vector(stream)});
    }
  return all;
}

std::vector<Vector3> random_box(std::size_t count, const Vector3& size, CounterStream& stream) {
  std::vector<Vector3> points;
  for (std::size_t i = 0; i < count; ++i) {
    const double x = stream.next_unit(), y = stream.next_unit(), z = stream.next_unit();
    points.push_back({x * size.x, y * size.y, z * size.z});
  }
  return points;
}

Scene random_scene(std::string name, std::size_t count, const Vector3& size, double reach,
                   double kill_distance) {
  CounterStream stream(17, count);
  Scene scene{std::move(name), random_box(count, size, stream), {}, reach, kill_distance};
  scene.batches = nodes_among(scene.points, 8, 80, 0.3 * std::min(reach, 1.0), stream);
  return scene;
}

/// Points and nodes on one lattice: every distance occurs many times, also exactly the reach and
/// exactly the kill distance.
Scene lattice_scene() {
  Scene scene{"lattice", {}, {}, 0.5, 0.25, std::numbers::pi};
  for (int x = 0; x < 16; ++x)
    for (int y = 0; y < 16; ++y)
      for (int z = 0; z < 16; ++z) scene.points.push_back({0.25 * x, 0.25 * y, 0.25 * z});
  CounterStream stream(5, 0);
  scene.batches.resize(6);
  for (auto& batch : scene.batches)
    for (int i = 0; i < 90; ++i) {
      const auto step = [&] { return 0.25 * std::floor(16.0 * stream.next_unit()); };
      const double x = step(), y = step(), z = step();
      batch.push_back({{x, y, z}, random_unit_vector(stream)});
    }
  return scene;
}

Scene repeated(Scene scene) {
  const auto once = scene.points;
  scene.points.insert(scene.points.end(), once.begin(), once.end());
  scene.name = "duplicates";
  return scene;
}

Scene scaled(Scene scene, double factor, const Vector3& shift, std::string name) {
  for (Vector3& point : scene.points) point = factor * point + shift;
  for (auto& batch : scene.batches)
    for (SearchableNode& node : batch) node.position = factor * node.position + shift;
  scene.reach *= factor;
  scene.kill_distance *= factor;
  scene.name = std::move(name);
  return scene;
}

std::vector<Scene> scenes() {
  std::vector<Scene> all;
  all.push_back(random_scene("random", 4000, {5, 5, 5}, 0.5, 0.3));
  all.push_back(random_scene("dense", 4000, {2, 2, 2}, 0.5, 0.1));
  all.push_back(random_scene("long_x", 3000, {60, 1, 1}, 0.5, 0.3));
  all.push_back(random_scene("long_z", 3000, {1, 1, 60}, 0.5, 0.3));
  all.push_back(random_scene("plane", 2000, {8, 8, 0}, 0.5, 0.3));
  all.push_back(random_scene("line", 800, {0, 40, 0}, 0.5, 0.3));
  all.push_back(random_scene("tiny_reach", 3000, {5, 5, 5}, 1e-9, 1e-9));
  all.push_back(random_scene("kill_up_to_the_reach", 3000, {5, 5, 5}, 0.4, 0.4));
  all.push_back(random_scene("kill_nothing", 3000, {5, 5, 5}, 0.4, 0.0));
  all.push_back(lattice_scene());
  all.push_back(repeated(random_scene("", 1500, {4, 4, 4}, 0.5, 0.3)));
  all.push_back(scaled(all.front(), 1e12, {}, "huge"));
  all.push_back(scaled(all.front(), 1e-12, {}, "tiny"));
  all.push_back(scaled(all.front(), 1.0, {1e9, -1e9, 1e9}, "far_away"));
  return all;
}

/// The plain loop.
struct Truth {
  explicit Truth(const Scene& s)
      : scene(s),
        best(s.points.size()),
        node(s.points.size(), no_node),
        live(s.points.size(), true) {
    const Perception perception(s.reach, s.half_angle_rad);
    std::fill(best.begin(), best.end(), perception.beyond_reach());
  }
  void associate(const std::vector<SearchableNode>& nodes) {
    const Perception perception(scene.reach, scene.half_angle_rad);
    for (const SearchableNode& candidate : nodes) {
      for (std::size_t i = 0; i < best.size(); ++i) {
        const double squared = squared_distance(scene.points[i], candidate.position);
        if (!live[i] || !(squared < best[i]) ||
            !perception.within_angle(candidate.position, candidate.direction, scene.points[i],
                                     squared))
          continue;
        best[i] = squared;
        node[i] = count;
      }
      ++count;
    }
  }
  std::vector<PointIndex> remove(const std::vector<SearchableNode>& killers) {
    std::vector<PointIndex> removed;
    const double reach = scene.kill_distance * scene.kill_distance;
    for (std::size_t i = 0; i < best.size(); ++i) {
      const bool hit = std::any_of(killers.begin(), killers.end(), [&](const SearchableNode& k) {
        return squared_distance(scene.points[i], k.position) <= reach;
      });
      if (!live[i] || !hit) continue;
      live[i] = false;
      node[i] = no_node;
      removed.push_back(static_cast<PointIndex>(i));
    }
    return removed;
  }
  const Scene& scene;
  std::vector<double> best;
  std::vector<NodeIndex> node;
  std::vector<char> live;
  NodeIndex count = 0;
};

/// In which order a caller removes and associates.
enum class Calls { remove_first, associate_first, associate_only, remove_others };

struct Outcome {
  std::size_t wrong_nodes = 0;
  std::size_t wrong_reached = 0;
  std::size_t wrong_removals = 0;
  std::size_t associations = 0;
  std::size_t removals = 0;
  WorkCounters work;
};

Outcome compare(PointSearch& search, const Scene& scene, Calls calls) {
  Truth truth(scene);
  Outcome outcome;
  std::vector<NodeIndex> node(scene.points.size(), no_node);
  const auto associate = [&](const std::vector<SearchableNode>& batch) {
    const std::vector<NodeIndex> before = node;
    std::vector<PointIndex> unreached, reached;
    for (std::size_t i = 0; i < node.size(); ++i)
      if (node[i] == no_node) unreached.push_back(static_cast<PointIndex>(i));
    search.associate(batch, truth.count, node, reached);
    std::sort(reached.begin(), reached.end());
    std::erase_if(unreached,
                  [&](PointIndex i) { return node[static_cast<std::size_t>(i)] == no_node; });
    outcome.wrong_reached += reached != unreached;
    for (std::size_t i = 0; i < node.size(); ++i) outcome.associations += node[i] != before[i];
    truth.associate(batch);
    for (std::size_t i = 0; i < node.size(); ++i) outcome.wrong_nodes += node[i] != truth.node[i];
  };
  const auto remove = [&](const std::vector<SearchableNode>& killers) {
    std::vector<PointIndex> removed;
    search.remove(killers, scene.kill_distance * scene.kill_distance, removed);
    for (const PointIndex point : removed) node[static_cast<std::size_t>(point)] = no_node;
    std::sort(removed.begin(), removed.end());
    outcome.wrong_removals += removed != truth.remove(killers);
    outcome.removals += removed.size();
  };
  for (std::size_t i = 0; i < scene.batches.size(); ++i) {
    const auto& batch = scene.batches[i];
    if (calls == Calls::remove_first) remove(batch);
    if (calls == Calls::remove_others) remove(scene.batches[(i + 1) % scene.batches.size()]);
    associate(batch);
    if (calls == Calls::associate_first) remove(batch);
  }
  outcome.work = search.counters();
  return outcome;
}

EngineSetup setup_of(const Scene& scene, int threads) {
  return {.influence_distance = scene.reach,
          .perception_half_angle_rad = scene.half_angle_rad,
          .threads = threads};
}

constexpr Calls all_calls[] = {Calls::remove_first, Calls::associate_first, Calls::associate_only,
                               Calls::remove_others};

void expect_right(const Outcome& outcome, const std::string& what) {
  EXPECT_EQ(outcome.wrong_nodes, 0u) << what;
  EXPECT_EQ(outcome.wrong_reached, 0u) << what;
  EXPECT_EQ(outcome.wrong_removals, 0u) << what;
}

TEST(RowSearchOracle, EqualsAPlainLoopWithEveryInstructionSetAndAnyThreads) {
  ASSERT_GE(vector_targets().size(), 2u);
  for (const Scene& scene : scenes())
    for (const std::int64_t target : vector_targets()) {
      const ForcedTarget forced(target);
      for (const Calls calls : all_calls)
        for (const int threads : {1, 2, 3}) {
          RowSearch search;
          ASSERT_TRUE(search.reset(scene.points, setup_of(scene, threads))) << scene.name;
          expect_right(compare(search, scene, calls),
                       scene.name + ", target " + std::to_string(target) + ", calls " +
                           std::to_string(static_cast<int>(calls)) + ", " +
                           std::to_string(threads) + " threads");
        }
    }
}

// Beyond half of the points, the others move together.
TEST(RowSearchOracle, ScenesLoseEnoughPointsToBeCompacted) {
  for (const Scene& scene : scenes()) {
    if (scene.name != "kill_up_to_the_reach" && scene.name != "line") continue;
    RowSearch search;
    ASSERT_TRUE(search.reset(scene.points, setup_of(scene, 1)));
    const Outcome outcome = compare(search, scene, Calls::remove_first);
    EXPECT_GT(10 * outcome.removals, 7 * scene.points.size()) << scene.name;
  }
}

TEST(RowSearchOracle, ScenesHaveSomethingToFindAndToRemove) {
  for (const Scene& scene : scenes()) {
    RowSearch search;
    ASSERT_TRUE(search.reset(scene.points, setup_of(scene, 1)));
    const Outcome outcome = compare(search, scene, Calls::remove_first);
    if (scene.name == "tiny_reach") continue;
    if (scene.kill_distance < scene.reach) EXPECT_GT(outcome.associations, 50u) << scene.name;
    if (scene.kill_distance > 0.0) EXPECT_GT(outcome.removals, 100u) << scene.name;
  }
}

TEST(RowSearchLaw, WorkDoesNotDependOnThreadsOrInstructionSet) {
  const Scene scene = scenes().front();
  std::vector<WorkCounters> work;
  for (const std::int64_t target : vector_targets()) {
    const ForcedTarget forced(target);
    for (const int threads : {1, 2, 5}) {
      RowSearch search;
      ASSERT_TRUE(search.reset(scene.points, setup_of(scene, threads)));
      work.push_back(compare(search, scene, Calls::remove_first).work);
    }
  }
  for (const WorkCounters& counters : work) {
    EXPECT_EQ(counters.search_evaluations, work.front().search_evaluations);
    EXPECT_EQ(counters.kill_evaluations, work.front().kill_evaluations);
  }
  EXPECT_GT(work.front().kill_evaluations, 0u);
}

// One scan serves removal and association: the second finds nothing left to look at.
TEST(RowSearchLaw, AssociatingWhatWasJustRemovedForCostsNoSecondScan) {
  const Scene scene = scenes().front();
  RowSearch search;
  ASSERT_TRUE(search.reset(scene.points, setup_of(scene, 1)));
  EXPECT_EQ(compare(search, scene, Calls::remove_first).work.search_evaluations, 0u);
  ASSERT_TRUE(search.reset(scene.points, setup_of(scene, 1)));
  EXPECT_GT(compare(search, scene, Calls::remove_others).work.search_evaluations, 0u);
}

TEST(RowSearchLaw, TheLastRemovalLooksOnlyAsFarAsItMustAndMayStillBeFollowed) {
  const Scene scene = random_scene("last", 4000, {5, 5, 5}, 0.5, 0.1);
  EngineSetup setup = setup_of(scene, 1);
  RowSearch search;
  ASSERT_TRUE(search.reset(scene.points, setup));
  const Outcome wide = compare(search, scene, Calls::associate_first);
  setup.associations = 1;  // an understatement: seven more follow
  ASSERT_TRUE(search.reset(scene.points, setup));
  const Outcome narrow = compare(search, scene, Calls::associate_first);
  expect_right(narrow, "understated");
  EXPECT_LT(narrow.work.kill_evaluations, wide.work.kill_evaluations / 2);
}

TEST(RowSearch, LeavesToOthersWhatDoesNotSuitIt) {
  const Scene scene = scenes().front();
  EngineSetup setup = setup_of(scene, 1);
  RowSearch search;
  setup.influence_distance = infinity;
  EXPECT_FALSE(search.reset(scene.points, setup));
  setup.influence_distance = 4.9;  // reaches nearly all of 4000 points
  EXPECT_FALSE(search.reset(scene.points, setup));
  const std::vector<Vector3> same(70'000, Vector3{1, 1, 1});  // more than a row can hold
  setup.influence_distance = 0.5;
  EXPECT_FALSE(search.reset(same, setup));
}

TEST(RowSearch, HoldsFewBytesPerPoint) {
  const Scene scene = random_scene("large", 50'000, {12, 12, 12}, 0.5, 0.3);
  RowSearch search;
  ASSERT_TRUE(search.reset(scene.points, setup_of(scene, 1)));
  EXPECT_LT(static_cast<double>(search.bytes()) / static_cast<double>(scene.points.size()), 64.0);
}

TEST(TreeSearchOracle, EqualsAPlainLoopForAnyLeafSizeAndThreads) {
  std::vector<Scene> all = scenes();
  for (const double reach : {0.05, 0.5, 3.0, 100.0, infinity}) {
    all.push_back(random_scene("reach", 600, {5, 5, 5}, reach, 0.3));
    all.push_back(random_scene("one_point", 1, {5, 5, 5}, reach, 0.3));
  }
  all.push_back(Scene{"no_point", {}, all.front().batches, 0.5, 0.3});
  for (const Scene& scene : all)
    for (const std::size_t leaf : {std::size_t{1}, std::size_t{2}, TreeSearch::default_leaf_size})
      for (const Calls calls : all_calls)
        for (const int threads : {1, 3}) {
          TreeSearch search(leaf);
          search.reset(scene.points, setup_of(scene, threads));
          expect_right(compare(search, scene, calls), scene.name + ", leaf " +
                                                          std::to_string(leaf) + ", calls " +
                                                          std::to_string(static_cast<int>(calls)));
        }
}

// With an infinite reach every node could look at every point; the tree knows better.
TEST(TreeSearchLaw, SkipsMostPointsHoweverFarANodeReaches) {
  Scene scene = random_scene("infinite", 4000, {5, 5, 5}, infinity, 0.0);
  scene.half_angle_rad = std::numbers::pi;
  TreeSearch search;
  search.reset(scene.points, setup_of(scene, 1));
  const Outcome outcome = compare(search, scene, Calls::associate_only);
  expect_right(outcome, scene.name);
  const std::size_t nodes = scene.batches.size() * scene.batches.front().size();
  EXPECT_LT(outcome.work.search_evaluations, nodes * scene.points.size() / 10);
}

TEST(PointSearch, ANewResetForgetsEverything) {
  const std::vector<Scene> all = scenes();
  RowSearch rows;
  TreeSearch tree;
  for (const Scene* scene : {&all[0], &all[9], &all[1]}) {
    ASSERT_TRUE(rows.reset(scene->points, setup_of(*scene, 1)));
    tree.reset(scene->points, setup_of(*scene, 1));
    expect_right(compare(rows, *scene, Calls::remove_first), "rows after another scene");
    expect_right(compare(tree, *scene, Calls::remove_first), "tree after another scene");
  }
}

}  // namespace
}  // namespace phytobench
