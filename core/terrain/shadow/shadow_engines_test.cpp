// SPDX-License-Identifier: MIT
// Every engine of shadow_engines.def against exact_traversal, and that against the definition.
#include <limits>
#include <set>

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/parallel/vector_targets.hpp"
#include "core/terrain/shadow/test_terrains.hpp"

namespace phytobench {
namespace {

using namespace testing_terrains;

/// A ray by the definition: every grid line from one side of the map to the other, in long
/// double.
class LiteralRay {
 public:
  LiteralRay(const HeightField& field, const SunDirection& sun, int column, int row)
      : field_(field), column_(column), row_(row), from_(field.at(column, row)) {
    const long double horizontal =
        std::hypot(static_cast<long double>(sun.east), static_cast<long double>(sun.south));
    east_ = sun.east / horizontal / field.cell_width();
    south_ = sun.south / horizontal / field.cell_depth();
    rise_ = sun.up / horizontal;
    for (int r = 0; r < field.rows(); ++r)
      if (south_ != 0 && (r - row) / south_ > 0) cross((r - row) / south_);
    for (int c = 0; c < field.columns(); ++c)
      if (east_ != 0 && (c - column) / east_ > 0) cross((c - column) / east_);
  }
  /// By how much the terrain is above the ray where it is most above it.
  long double most_above() const { return most_; }

 private:
  static long double snapped(long double at) {
    return std::abs(at - std::round(at)) < 1e-9L ? std::round(at) : at;
  }
  /// At that distance one of x and y is a whole number.
  void cross(long double distance) {
    const long double x = snapped(column_ + distance * east_);
    const long double y = snapped(row_ + distance * south_);
    if (x < 0 || y < 0 || x > field_.columns() - 1 || y > field_.rows() - 1) return;
    const int left = static_cast<int>(std::floor(x)), top = static_cast<int>(std::floor(y));
    const int right = static_cast<int>(std::ceil(x)), bottom = static_cast<int>(std::ceil(y));
    const long double f = (x - left) + (y - top);
    const long double a = field_.at(left, top), b = field_.at(right, bottom);
    if (std::isnan(a) || std::isnan(b)) return;
    most_ = std::max(most_, a + f * (b - a) - (from_ + distance * rise_));
  }

  const HeightField& field_;
  int column_, row_;
  long double from_, east_, south_, rise_;
  long double most_ = -std::numeric_limits<long double>::infinity();
};

std::vector<SunDirection> every(std::size_t step, std::size_t first,
                                const std::vector<SunDirection>& suns) {
  std::vector<SunDirection> some;
  for (std::size_t s = first; s < suns.size(); s += step) some.push_back(suns[s]);
  return some;
}

struct Disagreement {
  std::uint64_t rays = 0, ties = 0, wrong = 0;
};

/// Rays that pass the terrain within `tie` of its heights may go either way.
Disagreement against_definition(const LitMaps& lit, const HeightField& field,
                                const std::vector<SunDirection>& suns) {
  Disagreement sum;
  const HeightRange range = height_range(field);
  const double tie = 1e-12 * (std::abs(range.highest) + std::abs(range.lowest) + 1e-3);
  for (std::size_t s = 0; s < suns.size(); ++s)
    for (int row = 0; row < field.rows(); ++row)
      for (int column = 0; column < field.columns(); ++column) {
        ++sum.rays;
        bool is_lit = suns[s].up >= 0.0;
        if (is_lit && !in_zenith(suns[s]) && field.has_data(column, row)) {
          const long double above = LiteralRay(field, suns[s], column, row).most_above();
          if (std::abs(above) <= tie) {
            ++sum.ties;
            continue;
          }
          is_lit = above < 0;
        }
        sum.wrong += is_lit != lit.is_lit(s, column, row);
      }
  return sum;
}

TEST(ExactTraversalOracle, IsTheDefinition) {
  std::size_t number = 0;
  for (const Terrain& terrain : terrains()) {
    const auto suns = every(8, number++ % 8, suns_all_round());
    const Disagreement found =
        against_definition(lit_by("exact_traversal", terrain.field, suns), terrain.field, suns);
    EXPECT_EQ(found.wrong, 0u) << terrain.name << ": of " << found.rays;
    if (terrain.name.find("fractal") != std::string::npos)
      EXPECT_LT(found.ties, found.rays / 100) << terrain.name;
  }
}

TEST(ExactTraversalOracle, CheckSeesASingleWrongBit) {
  const HeightField field = fractal(20, 20, 300.0, 1);
  const auto suns = hourly_suns();
  LitMaps lit = lit_by("exact_traversal", field, suns);
  lit.row(1, 7)[0] ^= 1u << 11;
  EXPECT_EQ(against_definition(lit, field, suns).wrong, 1u);
}

class ExactShadowEnginesOracle : public testing::TestWithParam<const ShadowEngineDescriptor*> {};

TEST_P(ExactShadowEnginesOracle, GivesTheMapsOfExactTraversal) {
  const auto engine = GetParam()->create();  // one for all: nothing may be left from map to map
  for (const Terrain& terrain : terrains()) {
    const auto suns = suns_all_round();
    LitMaps lit;
    engine->cast(terrain.field, suns, {}, lit);
    EXPECT_EQ(difference(lit, lit_by("exact_traversal", terrain.field, suns)), "") << terrain.name;
  }
}

/// Small maps of every kind, where borders and ties are common.
class RandomCase {
 public:
  explicit RandomCase(std::uint64_t number) : stream_(2019, number) {
    const double cells[] = {1.0, 16.0, 0.1, 0.1 + 9.0 * unit()};
    field_ = HeightField(1 + below(26), 1 + below(26), cells[below(4)], cells[below(4)]);
    const int kind = below(5);
    const double scale = std::pow(10.0, 4.0 * unit() - 2.0), base = below(4) == 0 ? 1e6 : 0.0;
    const double holes = below(3) == 0 ? 0.3 * unit() : 0.0;
    const double slope_x = unit() - 0.5, slope_y = unit() - 0.5;
    for (int row = 0; row < field_.rows(); ++row)
      for (int column = 0; column < field_.columns(); ++column) {
        const double heights[] = {
            unit() * scale, std::floor(3.0 * unit()), scale * (slope_x * column + slope_y * row),
            unit() < 0.05 ? scale : 0.0, scale * ((column / 3 + row / 2) % 2)};
        field_.at(column, row) = unit() < holes ? HeightField::no_data : base + heights[kind];
      }
    for (int s = 0; s < 3; ++s) suns_.push_back(sun());
  }
  const HeightField& field() const { return field_; }
  const std::vector<SunDirection>& suns() const { return suns_; }

 private:
  double unit() { return stream_.next_unit(); }
  int below(int end) { return static_cast<int>(unit() * end); }
  SunDirection sun() {
    if (below(4) == 0)  // along vertices
      return {below(7) - 3.0, below(7) - 3.0, 0.5 * (1 + below(4))};
    const SunDirection sun = direction_of({below(3) == 0 ? 15.0 * below(6) : 90.0 * unit(),
                                           below(3) == 0 ? 22.5 * below(16) : 360.0 * unit()});
    return below(2) == 0 ? rounded(sun, 4) : sun;
  }

  CounterStream stream_;
  HeightField field_;
  std::vector<SunDirection> suns_;
};

TEST_P(ExactShadowEnginesOracle, GivesThemOnManySmallMaps) {
  const auto engine = GetParam()->create();
  std::uint64_t dark = 0;
  for (std::uint64_t number = 0; number < 10'000; ++number) {
    const RandomCase one(number);
    LitMaps lit;
    engine->cast(one.field(), one.suns(), {}, lit);
    const LitMaps right = lit_by("exact_traversal", one.field(), one.suns());
    ASSERT_EQ(difference(lit, right), "") << "case " << number;
    dark += 3 * one.field().size() - right.lit();
  }
  EXPECT_GT(dark, 500'000u);
}

std::string name_of_exact_one(const testing::TestParamInfo<const ShadowEngineDescriptor*>& info) {
  return std::string(info.param->name);
}

INSTANTIATE_TEST_SUITE_P(All, ExactShadowEnginesOracle, testing::ValuesIn(engines_that_are(true)),
                         name_of_exact_one);

TEST(ExactShadowEnginesOracle, TerrainsHaveShadows) {
  std::size_t with_shadows = 0;
  for (const Terrain& terrain : terrains()) {
    const auto suns = hourly_suns();
    with_shadows +=
        lit_by("exact_traversal", terrain.field, suns).lit() < suns.size() * terrain.field.size();
  }
  EXPECT_GE(with_shadows, 15u);
}

TEST(ShadowEnginesOracle, ZenithLightsAllAndNightNothing) {
  const std::vector<SunDirection> suns{{0, 0, 1}, direction_of({-1, 40}), {0, 0, -1}};
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    if (!engine->built()) continue;
    for (const Terrain& terrain : terrains()) {
      const LitMaps lit = lit_by(engine->name, terrain.field, suns);
      EXPECT_EQ(lit.lit(0), terrain.field.size()) << engine->name << ", " << terrain.name;
      EXPECT_EQ(lit.lit(1) + lit.lit(2), 0u) << engine->name << ", " << terrain.name;
    }
  }
}

/// Two walls as high as each other, and a post that is higher, so that rays look at both.
TEST(ShadowEnginesOracle, WhatIsAsHighAsARayDoesNotBlockIt) {
  HeightField field = made(70, 30, 16.0, 16.0, 0, [](int column, int, double) {
    return column == 20 || column == 40 ? 10.0 : 0.0;
  });
  field.at(60, 29) = 50.0;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    if (!engine->built()) continue;
    const LitMaps lit = lit_by(engine->name, field, {{1.0, 0.0, 0.0}, {-1.0, 0.0, 0.0}});
    for (const int wall : {20, 40})
      for (const std::size_t sun : {0u, 1u})
        EXPECT_TRUE(lit.is_lit(sun, wall, 5)) << engine->name << ", wall " << wall;
    EXPECT_FALSE(lit.is_lit(0, 30, 5)) << engine->name;
    EXPECT_FALSE(lit.is_lit(0, 20, 29)) << engine->name;
  }
}

/// A map and what it took, of every terrain.
struct Cast {
  ShadowWork work;
  LitMaps lit;
};
std::vector<Cast> casts_of(const ShadowEngineDescriptor& engine, int threads) {
  std::vector<Cast> casts;
  const auto suns = every(3, 0, suns_all_round());
  for (const Terrain& terrain : terrains()) {
    Cast& cast = casts.emplace_back();
    cast.work = engine.create()->cast(terrain.field, suns, {.threads = threads}, cast.lit);
  }
  return casts;
}
void expect_same(const std::vector<Cast>& casts, const std::vector<Cast>& others,
                 const std::string& what) {
  for (std::size_t i = 0; i < casts.size(); ++i) {
    EXPECT_EQ(difference(casts[i].lit, others[i].lit), "") << what << ", terrain " << i;
    EXPECT_EQ(casts[i].work, others[i].work) << what << ", terrain " << i;
  }
}

TEST(ShadowEnginesOracle, EveryVectorTargetAndNumberOfThreadsGivesTheSame) {
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    if (!engine->built()) continue;
    const std::vector<Cast> first = casts_of(*engine, 1);
    for (const int threads : {2, 4, 8})
      expect_same(casts_of(*engine, threads), first, std::string(engine->name) + ", threads");
    for (const std::int64_t target : vector_targets()) {
      const ForcedTarget forced(target);
      expect_same(casts_of(*engine, 1), first, std::string(engine->name) + ", vectors");
    }
  }
}

TEST(ShadowRegistry, NamesAreUniqueAndUnknownOnesAreRefused) {
  std::set<std::string_view> names;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    EXPECT_TRUE(names.insert(engine->name).second) << engine->name;
    EXPECT_TRUE(engine->summary.ends_with('.')) << engine->name;
    EXPECT_FALSE(engine->source.empty()) << engine->name;
    EXPECT_EQ(engine->built(), engine->missing_package.empty()) << engine->name;
  }
  EXPECT_GE(engines_that_are(true).size(), 3u);
  EXPECT_GE(engines_that_are(false).size(), 4u);
  EXPECT_THROW(shadow_engine_named("max_pyramids"), InputError);
}

}  // namespace
}  // namespace phytobench
