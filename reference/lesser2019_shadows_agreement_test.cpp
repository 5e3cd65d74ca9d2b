// SPDX-License-Identifier: MIT
// Engines of core and the literal transcriptions of [Lesser2019] have nothing in common but the
// terrain.
#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/terrain/shadow/shadow_registry.hpp"
#include "reference/lesser2019_site_model.hpp"
#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_noise.hpp"
#include "reference/oracles/lesser2019_rays.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench {
namespace {

namespace lesser = oracles::lesser2019;

HeightField field_of(const lesser::Heights& map) {
  HeightField field(map.n_x, map.n_y, map.ps_x, map.ps_y);
  std::copy(map.h.begin(), map.h.end(), field.heights().begin());
  return field;
}

/// Hours of several days, rounded to four decimals.
std::vector<SunDirection> hours_of(double max_elevation) {
  std::vector<SunDirection> suns;
  for (const lesser::Direction& sun : lesser::directions({.M = max_elevation}))
    suns.push_back({sun.u, sun.v, sun.w});
  return suns;
}

/// Pixel-hours in which an engine and the rays of the surface disagree; ties, where rounding
/// decides, are counted apart.
struct Disagreement {
  int wrong = 0, ties = 0, dark = 0;
};
Disagreement disagreement(const lesser::Heights& map, const std::vector<SunDirection>& suns,
                          const std::string& engine) {
  LitMaps lit;
  shadow_engine_named(engine).create()->cast(field_of(map), suns, {}, lit);
  Disagreement found;
  for (std::size_t hour = 0; hour < suns.size(); ++hour) {
    if (in_zenith(suns[hour])) continue;
    for (int y = 0; y < map.n_y; ++y)
      for (int x = 0; x < map.n_x; ++x) {
        const lesser::Ray ray =
            lesser::ray(map, x, y, {suns[hour].east, suns[hour].south, suns[hour].up},
                        lesser::Reading::surface);
        found.dark += !ray.lit;
        if (std::abs(ray.margin) < 1e-9)
          ++found.ties;
        else
          found.wrong += ray.lit != lit.is_lit(hour, x, y);
      }
  }
  return found;
}

TEST(LesserShadowsOracle, ExactEnginesAreTheRaysOfTheSurface) {
  lesser::Heights oblong = lesser::value_noise(64, 4, 300, 16);
  oblong.ps_y = 21.7;
  for (const ShadowEngineDescriptor* engine : all_shadow_engines()) {
    if (!engine->built() || !engine->exact) continue;
    for (const double max_elevation : {90.0, 80.0, 20.0}) {
      const Disagreement found = disagreement(lesser::value_noise(64, 1, 400, 16),
                                              hours_of(max_elevation), std::string(engine->name));
      EXPECT_EQ(found.wrong, 0) << engine->name << " " << max_elevation;
      EXPECT_LT(found.ties, 200) << "of 53 248";
      EXPECT_GT(found.dark, 5000);
    }
    EXPECT_EQ(disagreement(oblong, hours_of(40), std::string(engine->name)).wrong, 0)
        << engine->name << " on cells that are not square";
  }
}

TEST(LesserShadowsOracle, NothingIsKnownThereAndNothingHidden) {
  lesser::Heights map = lesser::value_noise(32, 6, 400, 16);
  for (int k = 0; k < 32; ++k) map.at((7 * k) % 32, k) = std::nan("");
  const std::vector<SunDirection> suns = hours_of(60);
  LitMaps lit;
  shadow_engine_named("exact_traversal").create()->cast(field_of(map), suns, {}, lit);
  int wrong = 0;
  for (std::size_t hour = 0; hour < suns.size(); ++hour)
    for (int y = 0; y < 32; ++y)
      for (int x = 0; x < 32; ++x) {
        if (std::isnan(map.at(x, y))) continue;
        const lesser::Ray ray =
            lesser::ray(map, x, y, {suns[hour].east, suns[hour].south, suns[hour].up},
                        lesser::Reading::surface);
        wrong += std::abs(ray.margin) > 1e-9 && ray.lit != lit.is_lit(hour, x, y);
      }
  EXPECT_EQ(wrong, 0);
}

/// The engine and the literal march are two transcriptions of one listing.
TEST(LesserShadowsOracle, ThePrintedMarchIsTheLiteralOne) {
  const auto literal_march = lesser_shadows(lesser_switches("E08,E09,E10"));
  const auto engine = shadow_engine_named("printed_march").create();
  for (const double ps : {16.0, 0.1, 7.3})
    for (const double max_elevation : {90.0, 20.0}) {
      const HeightField field = field_of(lesser::value_noise(64, 1, 25 * ps, ps));
      const std::vector<SunDirection> suns = hours_of(max_elevation);
      LitMaps one, other;
      const ShadowWork by_engine = engine->cast(field, suns, {}, one);
      const ShadowWork by_listing = literal_march->cast(field, suns, {}, other);
      EXPECT_EQ(differing_bits(one, other), 0u) << ps << " " << max_elevation;
      EXPECT_EQ(by_engine, by_listing) << ps << " " << max_elevation;
      EXPECT_EQ(by_listing.stuck > 0, ps != 16.0);
    }
}

TEST(LesserShadowsOracle, EachFaultOfTheMarchByItself) {
  const HeightField field = field_of(lesser::value_noise(64, 1, 400, 16));
  const std::vector<SunDirection> suns = hours_of(90);
  const auto lit_with = [&](const char* printed) {
    LitMaps lit;
    lesser_shadows(lesser_switches(printed))->cast(field, suns, {.threads = 2}, lit);
    return lit.lit();
  };
  EXPECT_EQ(lit_with("E08,E10"), 35128u);
  EXPECT_EQ(lit_with("E08"), 35141u);
  EXPECT_EQ(lit_with("none"), 35468u);
  EXPECT_EQ(lit_with("E09,E10"), 35468u) << "nothing to truncate on exact rays";
}

}  // namespace
}  // namespace phytobench
