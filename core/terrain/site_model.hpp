// SPDX-License-Identifier: MIT
// The stages from sunlight to the chance to grow, each behind one call, so that whole maps can be
// made with any of them exchanged.
#pragma once

#include <memory>
#include <vector>

#include "core/terrain/relief.hpp"
#include "core/terrain/site_parameters.hpp"
#include "core/terrain/sun/hourly_path.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

/// What the sun brings in an hour on an area that faces it: 2 cal/cm2 a minute ([Lesser2019]
/// sec. 8.2).
inline constexpr EnergyPerArea hourly_solar_energy{1200.0};

/// 2.5e6 J/kg ([Lesser2019] sec. 8.5) at 4184 J/kcal and 1 kg/l.
inline constexpr HeatOfEvaporation heat_of_evaporation{2.5e6 / 4184.0};

/// A map of numbers, row by row as a HeightField.
struct TerrainMap {
  int columns = 0;
  int rows = 0;
  std::vector<double> values;

  double at(int column, int row) const {
    return values[static_cast<std::size_t>(row) * static_cast<std::size_t>(columns) +
                  static_cast<std::size_t>(column)];
  }
  friend bool operator==(const TerrainMap&, const TerrainMap&) = default;
};

/// One call for each stage of [Lesser2019] sec. 8.2 to 8.6; what core gives is corrected.
class SiteModel {
 public:
  virtual ~SiteModel() = default;

  virtual std::vector<SunDirection> sun_path(const HourlyPath& path) const = 0;
  /// What an hour brings a vertex that the sun reaches, per area of its surface.
  virtual EnergyPerArea hourly_energy(const SurfaceGradient& surface,
                                      const SunDirection& sun) const = 0;
  /// What of it comes through the air.
  virtual DailyEnergy through_air(DailyEnergy raw, const Biome& biome) const = 0;
  /// What the ground keeps of what comes through the air, together with what its neighbours throw
  /// at it. `incoming` in kcal/m2 a day; `albedo` of each vertex; NaN where there is no data.
  virtual TerrainMap absorbed(const TerrainMap& incoming, const TerrainMap& albedo,
                              double neighbour_share, int threads) const = 0;
  virtual Length soil_depth(double slope_degrees, Length max_depth) const = 0;
  /// What is left for plants when the sun has taken its part.
  virtual DailyWater water(Length depth, const Soil& soil, const Biome& biome,
                           DailyEnergy absorbed) const = 0;
  /// The chance to grow by one factor, 0 to 1. `available` and `needed` in the same unit, needed
  /// not negative.
  virtual double chance(double available, double needed, Tolerance tolerance) const = 0;
};

/// Variants that the text leaves open, or that it leaves out.
struct SiteModelOptions {
  bool cosine =
      true;  ///< of the sun's incidence on the surface; without it any lit hour brings all
  /// Losses of the air one after the other, instead of as shares of the whole.
  bool sequential_losses = false;
  /// What neighbours throw over is partly thrown back again.
  bool reflected_is_absorbed = true;
};

std::unique_ptr<SiteModel> corrected_site_model(const SiteModelOptions& options = {});

/// The parts of the air's losses, checked: throws InputError if one is negative or all together
/// exceed 100 percent.
void check_losses(const Biome& biome);

}  // namespace phytobench
