// SPDX-License-Identifier: MIT
// The corrected stages of core against the literal transcriptions of [Lesser2019] with their errata
// corrected.
#include <cmath>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/terrain/site_model.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"
#include "reference/oracles/lesser2019_noise.hpp"
#include "reference/oracles/lesser2019_relief.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench {
namespace {

namespace lesser = oracles::lesser2019;

/// Sums of the same numbers in another order.
constexpr double lesser_rounding = 1e-12;

TEST(LesserStagesOracle, PathsOfAnyNumberOfHours) {
  for (int hours = 1; hours <= 24; ++hours)
    for (const auto& [even, ascent] :
         {std::pair{EvenHours::plateau, lesser::ElevationStep::one_formula},
          std::pair{EvenHours::tent, lesser::ElevationStep::tent}}) {
      const auto core = sun_angles({hours, 5.0, 10.0, 70.0, even});
      const auto oracle = lesser::path({.H = hours,
                                        .s0 = 5,
                                        .a0 = 10,
                                        .M = 70,
                                        .elevation = ascent,
                                        .azimuth = lesser::AzimuthStep::always_half});
      ASSERT_EQ(core.size(), oracle.size());
      for (std::size_t k = 0; k < core.size(); ++k) {
        EXPECT_NEAR(core[k].elevation, oracle[k].elevation, 1e-11) << hours << " " << k;
        EXPECT_NEAR(core[k].azimuth, oracle[k].azimuth, 1e-11) << hours << " " << k;
      }
    }
}

TEST(LesserStagesOracle, DirectionsRoundedToFourDecimals) {
  for (double elevation = 0; elevation <= 90; elevation += 2.5)
    for (double azimuth = 0; azimuth <= 360; azimuth += 2.5) {
      const SunDirection core = rounded(direction_of({elevation, azimuth}), 4);
      const lesser::Direction oracle = lesser::listing_9_7({elevation, azimuth});
      EXPECT_EQ(core, (SunDirection{oracle.u, oracle.v, oracle.w})) << elevation << " " << azimuth;
    }
}

TEST(LesserStagesOracle, NormalsOfEveryEstimatorAndOfTheBorder) {
  using lesser::Diagonal, lesser::FaceWeight;
  struct Way {
    SurfaceEstimator core;
    Diagonal diagonal;
    FaceWeight weight;
  };
  lesser::Heights map = lesser::value_noise(16, 7, 200, 16);
  map.ps_y = 23;
  HeightField field(16, 16, 16.0, 23.0);
  std::copy(map.h.begin(), map.h.end(), field.heights().begin());
  const auto expect_same = [](const SurfaceGradient& core, const lesser::Normal& oracle) {
    const Vector3 normal = surface_normal(core);
    EXPECT_NEAR(normal.x, oracle.x, lesser_rounding);
    EXPECT_NEAR(normal.y, oracle.y, lesser_rounding);
    EXPECT_NEAR(normal.z, oracle.z, lesser_rounding);
    EXPECT_NEAR(slope_degrees(core), lesser::angle_to_vertical(oracle), 1e-9);
  };
  for (int j = 0; j < 16; ++j)
    for (int i = 0; i < 16; ++i) {
      SCOPED_TRACE(testing::Message() << i << " " << j);
      for (const Way& way :
           {Way{SurfaceEstimator::six_faces, Diagonal::south_west_north_east, FaceWeight::area},
            Way{SurfaceEstimator::other_six, Diagonal::north_west_south_east, FaceWeight::area},
            Way{SurfaceEstimator::unit_faces, Diagonal::south_west_north_east, FaceWeight::unit}})
        expect_same(surface_gradient(field, i, j, way.core),
                    lesser::normal_of_six_faces(map, i, j, way.diagonal, way.weight));
      if (i > 0 && j > 0 && i < 15 && j < 15)
        expect_same(surface_gradient(field, i, j, SurfaceEstimator::sobel),
                    lesser::sobel_corrected(map, i, j));
    }
}

TEST(LesserStagesOracle, EnergyThatTheGroundKeeps) {
  const lesser::Heights noise = lesser::value_noise(16, 8, 1000, 1);
  TerrainMap light{16, 16, noise.h}, albedo{16, 16, lesser::value_noise(16, 9, 0.9, 1).h};
  light.values[37] = albedo.values[37] = std::nan("");
  for (const bool again : {true, false}) {
    const auto model = corrected_site_model({.reflected_is_absorbed = again});
    const TerrainMap core = model->absorbed(light, albedo, 0.3, 2);
    const lesser::Values oracle = lesser::reflected_by_albedo(
        {16, 16, light.values}, {16, 16, albedo.values}, 0.3,
        again ? lesser::Received::partly_reflected_again : lesser::Received::all);
    for (std::size_t i = 0; i < core.values.size(); ++i)
      if (i == 37)
        EXPECT_TRUE(std::isnan(core.values[i]) && std::isnan(oracle.value[i]));
      else
        EXPECT_NEAR(core.values[i], oracle.value[i], 1e-9) << i;
  }
}

TEST(LesserStagesOracle, AirDepthWaterAndChances) {
  const auto model = corrected_site_model();
  const Biome biome{"b", 30.0, 7.0, 21.0, DailyWater(2.0), DailyWater(0.5)};
  EXPECT_NEAR(model->through_air(DailyEnergy(9000.0), biome).value(),
              lesser::through_the_air(9000, {21, 30, 7}), 1e-9);
  const Soil soil{"s", 1, 0.2, 0.6};
  for (const double centimetres_deep : {0.0, 30.0, 99.0, 100.0, 150.0})
    for (const double kcal : {0.0, 200.0, 700.0, 5000.0}) {
      const DailyWater left =
          model->water(centimetres(centimetres_deep), soil, biome, DailyEnergy(kcal));
      EXPECT_NEAR(left.value(),
                  lesser::listing_9_16({centimetres_deep, 0.6, 0.5, 2.0}, kcal, 2.5 / 4.184,
                                       lesser::Evaporation::divided),
                  lesser_rounding);
    }
  for (const double slope : {0.0, 10.0, 45.0, 89.0})
    EXPECT_NEAR(in_centimetres(model->soil_depth(slope, centimetres(120.0))),
                lesser::listing_9_15(slope, 120), 1e-10);
  for (const double there : {0.0, 0.3, 1.0, 1.5, 2.0, 2.5}) {
    EXPECT_NEAR(model->chance(there, 1.0, Tolerance::triangle), lesser::listing_9_17(1, there),
                lesser_rounding);
    for (const auto& [core, rule] :
         {std::pair{Tolerance::saturating, lesser::DepthRule::saturating},
          std::pair{Tolerance::threshold, lesser::DepthRule::threshold},
          std::pair{Tolerance::ignored, lesser::DepthRule::ignored}})
      EXPECT_NEAR(model->chance(there, 0.8, core), lesser::depth_chance(0.8, there, rule),
                  lesser_rounding);
  }
}

}  // namespace
}  // namespace phytobench
