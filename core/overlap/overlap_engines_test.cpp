// SPDX-License-Identifier: MIT
// Every engine of overlap_engines.def against the definition, on scenes where corner cases are
// common.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/overlap/lens.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/overlap/test_discs.hpp"
#include "core/parallel/vector_targets.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/running_moments.hpp"

namespace phytobench {
namespace {

struct Pair {
  DiscIndex first, second;
  double area;

  friend bool operator==(const Pair&, const Pair&) = default;
};

std::ostream& operator<<(std::ostream& out, const Pair& pair) {
  return out << pair.first << '-' << pair.second << ": " << pair.area;
}

struct NamedScene : testing_discs::Scene {
  explicit NamedScene(std::string called) : name(std::move(called)) {}
  std::string name;
};

std::vector<Pair> by_definition(const NamedScene& scene) {
  const Discs discs = scene.discs();
  std::vector<Pair> pairs;
  const int reach = scene.ground.torus ? 1 : 0;
  for (std::size_t i = 0; i < discs.size(); ++i) {
    for (std::size_t j = i + 1; j < discs.size(); ++j) {
      std::vector<double> areas;
      for (int ky = -reach; ky <= reach; ++ky) {
        for (int kx = -reach; kx <= reach; ++kx) {
          const double dx = (discs.x[j] - discs.x[i]) + kx * scene.ground.period_x();
          const double dy = (discs.y[j] - discs.y[i]) + ky * scene.ground.period_y();
          const double area =
              lens_area(discs.radius[i], discs.radius[j], std::sqrt(dx * dx + dy * dy));
          if (area > 0.0) areas.push_back(area);
        }
      }
      if (areas.empty()) continue;
      std::sort(areas.begin(), areas.end());
      double sum = 0.0;
      for (const double area : areas) sum += area;
      pairs.push_back({static_cast<DiscIndex>(i), static_cast<DiscIndex>(j), sum});
    }
  }
  return pairs;
}

std::vector<Pair> found_by(OverlapEngine& engine, const NamedScene& scene, int threads = 1) {
  OverlapPairs found;
  engine.find(scene.discs(), scene.ground, {.threads = threads}, found);
  found.sort_and_merge(scene.discs().size());
  std::vector<Pair> pairs;
  for (std::size_t p = 0; p < found.size(); ++p)
    pairs.push_back({found.first()[p], found.second()[p], found.area()[p]});
  return pairs;
}

/// Radii between 1 and `ratio`, evenly in their logarithm, about ten partners each.
NamedScene random_scene(std::string name, std::size_t count, double ratio, bool is_torus,
                        std::uint64_t seed) {
  NamedScene scene{std::move(name)};
  double side = 0.0;
  for (std::size_t i = 0; i < count; ++i) {
    const double r = std::pow(ratio, random_unit(seed, 2, i));
    side += 4.0 * r * r;
    scene.radius.push_back(r);
  }
  side = std::max(std::sqrt(side), 2.2 * ratio);
  for (std::size_t i = 0; i < count; ++i) {
    scene.x.push_back(side * random_unit(seed, 0, i) - 3.0);
    scene.y.push_back(side * random_unit(seed, 1, i) + 7.0);
  }
  if (is_torus) scene.ground.torus = Rectangle{{-3.0, 7.0}, {side - 3.0, side + 7.0}};
  return scene;
}

NamedScene lattice(std::string name, double radius, bool is_torus) {
  NamedScene scene{std::move(name)};
  for (int row = 0; row < 12; ++row)
    for (int column = 0; column < 12; ++column) scene.add(column, row, radius);
  if (is_torus) scene.ground.torus = Rectangle{{0, 0}, {12, 12}};
  return scene;
}

NamedScene scaled(NamedScene scene, std::string name, double factor) {
  scene.name = std::move(name);
  for (std::vector<double>* values : {&scene.x, &scene.y, &scene.radius})
    for (double& value : *values) value *= factor;
  if (scene.ground.torus) {
    Rectangle& torus = *scene.ground.torus;
    torus = {factor * torus.low, factor * torus.high};
  }
  return scene;
}

NamedScene tree_in_a_meadow() {
  NamedScene scene = random_scene("one tree among grasses", 600, 1.0, false, 8);
  scene.add(20, 30, 35);
  return scene;
}

NamedScene all_at_one_place() {
  NamedScene scene{"all at one place"};
  for (int i = 0; i < 60; ++i) scene.add(3.25, -2, 1.0 + i % 3);
  return scene;
}

NamedScene line(std::string name, double dx, double dy) {
  NamedScene scene{std::move(name)};
  for (int i = 0; i < 200; ++i) {
    const double at = 40.0 * random_unit(4, 0, static_cast<std::uint64_t>(i));
    scene.add(dx * at, dy * at, 0.5 + random_unit(4, 1, static_cast<std::uint64_t>(i)));
  }
  return scene;
}

/// Discs that meet several images of each other, and cells that go round to themselves.
NamedScene crowded_torus(std::size_t count) {
  NamedScene scene{"few large discs on a torus: " + std::to_string(count)};
  scene.ground.torus = Rectangle{{0, 0}, {10, 12}};
  for (std::size_t i = 0; i < count; ++i)
    scene.add(10 * random_unit(5, 0, i), 12 * random_unit(5, 1, i),
              i == 0 ? 4.99 : 0.2 + 4.5 * random_unit(5, 2, i));
  return scene;
}

NamedScene some_without_radius() {
  NamedScene scene = random_scene("some of radius 0", 200, 3.0, false, 9);
  for (std::size_t i = 0; i < scene.radius.size(); i += 3) scene.radius[i] = 0.0;
  return scene;
}

NamedScene on_the_border() {
  NamedScene scene{"on the border of a torus"};
  scene.ground.torus = Rectangle{{-1, -1}, {9, 9}};
  for (int i = 0; i <= 10; ++i) {
    scene.add(-1, i - 1, 0.75);
    scene.add(9, i - 1, 0.8);
    scene.add(i - 1, 9, 1.5);
  }
  return scene;
}

/// Diameters all but fill the period, sizes on both sides of a power of two, centers on the border.
NamedScene full_torus() {
  NamedScene scene{"nearly full torus"};
  const double side = 2.0000002;
  scene.ground.torus = Rectangle{{0, 0}, {side, side}};
  for (int i = 0; i < 40; ++i)
    scene.add(side * (i % 3) / 2, side * (i % 5) / 4, i % 2 == 0 ? 1.0 : 0.99999999);
  return scene;
}

/// No height to speak of, and discs many times as large.
NamedScene flat(std::string name, double height, bool along_x) {
  NamedScene scene{std::move(name)};
  for (std::size_t i = 0; i < 150; ++i) {
    const double along = 300 * random_unit(6, 0, i), across = i % 2 == 0 ? 0.0 : height;
    scene.add(along_x ? along : across, along_x ? across : along, i % 30 == 0 ? 120.0 : 0.4);
  }
  return scene;
}

/// Hundreds of discs in one cell of any grid that is not larger than they are many.
NamedScene lump(std::string name, bool is_torus) {
  NamedScene scene{std::move(name)};
  for (std::size_t i = 0; i < 600; ++i)
    scene.add(random_unit(7, 0, i), random_unit(7, 1, i), 0.02 * random_unit(7, 2, i));
  scene.add(1e5, 1e5, 0.01);
  scene.add(0.5, 1e5, 0.015);
  if (is_torus) scene.ground.torus = Rectangle{{0, 0}, {1e5, 1e5}};
  return scene;
}

NamedScene two(std::string name, double distance) {
  NamedScene scene{std::move(name)};
  scene.add(0, 0, 1);
  scene.add(distance, 0, 2);
  return scene;
}

NamedScene none(std::string name, int discs) {
  NamedScene scene{std::move(name)};
  for (int i = 0; i < discs; ++i) scene.add(i, 0, 0.25);
  return scene;
}

std::vector<NamedScene> scenes() {
  const NamedScene mixed = random_scene("sizes from 1 to 1000", 500, 1000.0, false, 3);
  const NamedScene mixed_torus =
      random_scene("sizes from 1 to 100 on a torus", 400, 100.0, true, 4);
  return {random_scene("equal sizes", 700, 1.0, false, 1),
          random_scene("equal sizes on a torus", 700, 1.0, true, 1),
          random_scene("sizes from 1 to 3", 500, 3.0, false, 2),
          mixed,
          mixed_torus,
          scaled(mixed, "tiny", 1e-40),
          scaled(mixed_torus, "huge", 1e40),
          lattice("touching lattice", 0.5, false),
          lattice("touching lattice on a torus", 0.5, true),
          lattice("overlapping lattice on a torus", 1.0, true),
          tree_in_a_meadow(),
          all_at_one_place(),
          line("along x", 1, 0),
          line("along y", 0, 1),
          line("along a diagonal", 1e-3, 1),
          crowded_torus(3),
          crowded_torus(40),
          some_without_radius(),
          on_the_border(),
          full_torus(),
          flat("flat up to rounding along x", 1.1e-17, true),
          flat("flat up to rounding along y", 1.1e-17, false),
          flat("flatter than can be divided by", 1e-310, true),
          lump("a lump in empty space", false),
          lump("a lump on a large torus", true),
          two("just touching", 3.0),
          two("hardly overlapping", std::nextafter(3.0, 0.0)),
          two("one inside the other", 0.5),
          none("nothing", 0),
          none("one", 1),
          none("apart", 5)};
}

class OverlapEnginesOracle : public testing::TestWithParam<const OverlapEngineDescriptor*> {};

TEST_P(OverlapEnginesOracle, FindEveryPairAndItsArea) {
  if (!GetParam()->built()) GTEST_SKIP() << GetParam()->missing_package << " was not found";
  const auto engine = GetParam()->create();  // one for all: nothing may be left from scene to scene
  for (const NamedScene& scene : scenes()) {
    ASSERT_EQ(problem_with(scene.discs(), scene.ground), std::nullopt) << scene.name;
    EXPECT_EQ(found_by(*engine, scene), by_definition(scene)) << scene.name;
  }
}

TEST_P(OverlapEnginesOracle, PiecesAreTheWholeInItsOrder) {
  if (!GetParam()->built()) GTEST_SKIP() << "needs " << GetParam()->missing_package;
  const auto engine = GetParam()->create();
  std::vector<NamedScene> all = scenes();
  all.push_back(random_scene("many jobs", 60'000, 3.0, true, 12));
  for (const NamedScene& scene : all) {
    if (scene.x.size() > 5'000 && GetParam()->name == "all_pairs") continue;
    OverlapPairs whole, scratch, joined;
    engine->find(scene.discs(), scene.ground, {}, whole);
    for (const int threads : {1, 2, 3}) {
      joined.clear();
      engine->find_in_parts(
          scene.discs(), scene.ground, {.threads = threads}, scratch,
          [&](std::span<const OverlapPairs> pieces) { joined.append_all(pieces, 1); });
      EXPECT_TRUE(std::ranges::equal(joined.first(), whole.first())) << scene.name;
      EXPECT_TRUE(std::ranges::equal(joined.second(), whole.second())) << scene.name;
      EXPECT_TRUE(std::ranges::equal(joined.area(), whole.area())) << scene.name;
    }
  }
}

TEST_P(OverlapEnginesOracle, GivesUpBeyondTheMostPairs) {
  if (!GetParam()->built()) GTEST_SKIP() << GetParam()->missing_package << " was not found";
  const NamedScene scene = all_at_one_place();
  OverlapPairs pairs;
  const std::size_t all = 60 * 59 / 2;
  EXPECT_NO_THROW(
      GetParam()->create()->find(scene.discs(), scene.ground, {.most_pairs = all}, pairs));
  EXPECT_THROW(
      GetParam()->create()->find(scene.discs(), scene.ground, {.most_pairs = all - 1}, pairs),
      InputError);
}

std::string name_of_engine(const testing::TestParamInfo<const OverlapEngineDescriptor*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(All, OverlapEnginesOracle,
                         testing::ValuesIn(all_overlap_engines().begin(),
                                           all_overlap_engines().end()),
                         name_of_engine);

TEST(OverlapEnginesOracle, ScenesHaveSomethingToFind) {
  std::size_t with_pairs = 0;
  for (const NamedScene& scene : scenes()) with_pairs += !by_definition(scene).empty();
  EXPECT_GE(with_pairs, 19u);
}

TEST(LayeredGridOracle, EveryVectorTargetAndNumberOfThreadsGivesTheSamePairs) {
  const OverlapEngineDescriptor& engine = overlap_engine_named("layered_grid");
  std::vector<NamedScene> all = scenes();
  all.push_back(random_scene("many", 20'000, 50.0, true, 6));  // more than one job
  for (const NamedScene& scene : all) {
    OverlapPairs first;
    engine.create()->find(scene.discs(), scene.ground, {}, first);
    for (const std::int64_t target : vector_targets()) {
      const ForcedTarget forced(target);
      for (const int threads : {1, 2, 5}) {
        OverlapPairs pairs;
        engine.create()->find(scene.discs(), scene.ground, {.threads = threads}, pairs);
        // Not sorted: the order is the same, too.
        EXPECT_TRUE(std::ranges::equal(pairs.first(), first.first())) << scene.name;
        EXPECT_TRUE(std::ranges::equal(pairs.second(), first.second())) << scene.name;
        EXPECT_TRUE(std::ranges::equal(pairs.area(), first.area())) << scene.name;
      }
    }
  }
}

TEST(LayeredGridLaw, ALargeDiscDoesNotMakeTheOthersLookFurther) {
  const auto candidates = [](const NamedScene& scene, const char* engine) {
    OverlapPairs pairs;
    return overlap_engine_named(engine)
        .create()
        ->find(scene.discs(), scene.ground, {}, pairs)
        .candidates;
  };
  NamedScene scene = random_scene("grasses", 20'000, 1.0, false, 7);
  const std::uint64_t grasses = candidates(scene, "layered_grid");
  const std::uint64_t in_one_grid = candidates(scene, "cell_grid");
  scene.add(100, 100, 100);
  EXPECT_LT(candidates(scene, "layered_grid"), grasses + 30'000);
  EXPECT_GT(candidates(scene, "cell_grid"), 100 * in_one_grid);  // what is to be avoided
}

/// Independent uniform discs on a torus share the product of their areas over the ground's on
/// average: search, images and areas at once.
TEST(LayeredGridLaw, PairsOnATorusAddUpToTheProductOfAreas) {
  RunningMoments ratio;
  const auto engine = overlap_engine_named("layered_grid").create();
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const NamedScene scene = random_scene("", 400, 4.0, true, 100 + seed);
    double found = 0.0, areas = 0.0, squares = 0.0;
    for (const Pair& pair : found_by(*engine, scene)) found += pair.area;
    for (const double r : scene.radius) {
      const double area = std::numbers::pi * r * r;
      areas += area;
      squares += area * area;
    }
    ratio.add(found * scene.ground.torus->area() / (0.5 * (areas * areas - squares)));
  }
  EXPECT_LT(std::abs(ratio.mean() - 1.0), 4 * ratio.standard_error());
  EXPECT_LT(ratio.standard_error(), 0.006);  // the test can fail
}

/// One center far away makes the cells of a grid too wide for all others.
TEST(LayeredGridLaw, ALumpInEmptySpaceIsNotComparedWithAllOfItself) {
  NamedScene scene{"lump"};
  for (std::size_t i = 0; i < 20'000; ++i)
    scene.add(random_unit(8, 0, i), random_unit(8, 1, i), 0.005);
  scene.add(1e5, 1e5, 0.005);
  OverlapPairs pairs;
  const OverlapWork work =
      overlap_engine_named("layered_grid").create()->find(scene.discs(), scene.ground, {}, pairs);
  EXPECT_LT(work.candidates, 4 * pairs.size());
}

TEST(OverlapRegistry, NamesAreUniqueAndUnknownOnesAreRefused) {
  std::set<std::string_view> names;
  for (const OverlapEngineDescriptor* engine : all_overlap_engines()) {
    EXPECT_TRUE(names.insert(engine->name).second) << engine->name;
    EXPECT_TRUE(engine->summary.ends_with('.')) << engine->name;
    EXPECT_FALSE(engine->source.empty()) << engine->name;
    EXPECT_EQ(engine->built(), engine->missing_package.empty()) << engine->name;
  }
  EXPECT_GE(names.size(), 8u);
  EXPECT_THROW(overlap_engine_named("layred_grid"), InputError);
}

}  // namespace
}  // namespace phytobench
