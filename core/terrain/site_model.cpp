// SPDX-License-Identifier: MIT
#include "core/terrain/site_model.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/geometry/vector3.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// The mean of `share(neighbour)` over the up to eight vertices around one that have it; 0 for
/// none.
template <class Share>
double mean_of_neighbours(const TerrainMap& map, int column, int row, const Share& share) {
  double sum = 0.0;
  int count = 0;
  for (int r = std::max(row - 1, 0); r <= std::min(row + 1, map.rows - 1); ++r)
    for (int c = std::max(column - 1, 0); c <= std::min(column + 1, map.columns - 1); ++c) {
      if (r == row && c == column) continue;
      const double given = share(c, r);
      if (std::isnan(given)) continue;
      sum += given;
      ++count;
    }
  return count == 0 ? 0.0 : sum / count;
}

class CorrectedSiteModel final : public SiteModel {
 public:
  explicit CorrectedSiteModel(const SiteModelOptions& options) : options_(options) {}

  std::vector<SunDirection> sun_path(const HourlyPath& path) const override {
    std::vector<SunDirection> directions;
    for (const SunAngles& angles : sun_angles(path)) directions.push_back(direction_of(angles));
    return directions;
  }

  EnergyPerArea hourly_energy(const SurfaceGradient& surface,
                              const SunDirection& sun) const override {
    if (!options_.cosine) return hourly_solar_energy;
    const Vector3 normal = surface_normal(surface);
    const double cosine = dot(normal, Vector3{sun.east, sun.south, sun.up});
    return hourly_solar_energy * std::max(cosine, 0.0);
  }

  DailyEnergy through_air(DailyEnergy raw, const Biome& biome) const override {
    const std::array<double, 3> losses = {biome.cloud_percent, biome.absorption_percent,
                                          biome.diffusion_percent};
    DailyEnergy left = raw;
    for (const double percent : losses)
      left = left - (options_.sequential_losses ? left : raw) * (percent / 100.0);
    return left;
  }

  TerrainMap absorbed(const TerrainMap& incoming, const TerrainMap& albedo, double neighbour_share,
                      int threads) const override {
    TerrainMap result = incoming;
    for_tasks(static_cast<std::size_t>(incoming.rows), threads, [&](std::size_t task) {
      const int row = static_cast<int>(task);
      for (int column = 0; column < incoming.columns; ++column) {
        const double thrown = mean_of_neighbours(incoming, column, row, [&](int c, int r) {
          return albedo.at(c, r) * incoming.at(c, r);
        });
        const double kept = 1.0 - albedo.at(column, row);
        const double received = neighbour_share * thrown;
        result.values[task * static_cast<std::size_t>(incoming.columns) +
                      static_cast<std::size_t>(column)] =
            kept * incoming.at(column, row) +
            (options_.reflected_is_absorbed ? kept * received : received);
      }
    });
    return result;
  }

  Length soil_depth(double slope, Length max_depth) const override {
    return max_depth * (1.0 - slope / 90.0);
  }

  DailyWater water(Length depth, const Soil& soil, const Biome& biome,
                   DailyEnergy absorbed) const override {
    // Less than a metre of soil holds only a part.
    const double held = std::min(1.0, depth.value());
    const DailyWater supply = (biome.groundwater + biome.rain) * (held * soil.water_absorption);
    const DailyWater evaporated = absorbed / heat_of_evaporation;
    return std::max(supply - evaporated, DailyWater(0.0));
  }

  double chance(double available, double needed, Tolerance tolerance) const override {
    PHYTOBENCH_EXPECT(!(needed < 0.0));
    // What is not needed limits nothing.
    if (needed == 0.0 || tolerance == Tolerance::ignored) return 1.0;
    const double share = available / needed;
    switch (tolerance) {
      case Tolerance::triangle:
        return share <= 1.0 ? share : std::max(0.0, 2.0 - share);
      case Tolerance::saturating:
        return std::min(share, 1.0);
      case Tolerance::threshold:
        return share >= 1.0 ? 1.0 : 0.0;
      case Tolerance::ignored:
        break;
    }
    return 1.0;
  }

 private:
  SiteModelOptions options_;
};

}  // namespace

std::unique_ptr<SiteModel> corrected_site_model(const SiteModelOptions& options) {
  return std::make_unique<CorrectedSiteModel>(options);
}

void check_losses(const Biome& biome) {
  const double sum = biome.cloud_percent + biome.absorption_percent + biome.diffusion_percent;
  for (const double percent :
       {biome.cloud_percent, biome.absorption_percent, biome.diffusion_percent})
    if (!(percent >= 0.0))
      throw InputError(fmt::format(
          "biome '{}': a loss of {:g} percent; give shares of the sun's energy, 0 to 100",
          biome.name, percent));
  if (!(sum <= 100.0))
    throw InputError(
        fmt::format("biome '{}': clouds, absorption and diffusion take {:g} percent of the sun's "
                    "energy; at most "
                    "100 are there",
                    biome.name, sum));
}

}  // namespace phytobench
