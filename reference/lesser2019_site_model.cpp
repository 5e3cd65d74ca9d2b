// SPDX-License-Identifier: MIT
#include "reference/lesser2019_site_model.hpp"

#include <cmath>
#include <vector>

#include "core/terrain/shadow/shadow_registry.hpp"
#include "core/terrain/shadow/traced_rows.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_growth.hpp"
#include "reference/oracles/lesser2019_march.hpp"
#include "reference/oracles/lesser2019_relief.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench {

namespace {

namespace literal = oracles::lesser2019;
using enum LesserErratum;

/// The stages, in the order of the pipeline.
class PrintedSiteModel final : public SiteModel {
 public:
  PrintedSiteModel(const LesserSwitches& switches, const SiteModelOptions& corrected)
      : switches_(switches), options_(corrected), corrected_(corrected_site_model(corrected)) {}

  std::vector<SunDirection> sun_path(const HourlyPath& path) const override {
    std::vector<SunDirection> suns = corrected_->sun_path(path);
    if (has(text_elevation_step) || has(even_hours_step) || has(two_hour_azimuth))
      suns = printed_path(path);
    if (switches_.rounded_sun)
      for (SunDirection& sun : suns)
        sun = {literal::rounded_to_four(sun.east) + 0.0, literal::rounded_to_four(sun.south) + 0.0,
               literal::rounded_to_four(sun.up) + 0.0};
    return suns;
  }

  EnergyPerArea hourly_energy(const SurfaceGradient& surface,
                              const SunDirection& sun) const override {
    if (has(no_cosine)) return EnergyPerArea(literal::SOLAR_CONSTANT_K_CALORIES_PER_HOUR);
    return corrected_->hourly_energy(surface, sun);
  }

  DailyEnergy through_air(DailyEnergy raw, const Biome& biome) const override {
    if (!has(losses_as_fractions) && !has(unchecked_losses))
      return corrected_->through_air(raw, biome);
    literal::Losses losses{biome.cloud_percent, biome.absorption_percent, biome.diffusion_percent};
    if (has(losses_as_fractions))
      losses = {losses.cloud_reflection / 100, losses.atmospheric_absorption / 100,
                losses.atmospheric_diffusion / 100};
    return DailyEnergy(literal::through_the_air(raw.value(), losses));
  }

  TerrainMap absorbed(const TerrainMap& incoming, const TerrainMap& albedo, double neighbour_share,
                      int threads) const override {
    if (!has(reflect_absorbed) && !has(eight_neighbours))
      return corrected_->absorbed(incoming, albedo, neighbour_share, threads);
    const literal::Divisor divisor =
        has(eight_neighbours) ? literal::Divisor::eight : literal::Divisor::number_of_neighbours;
    literal::Values light = values_of(incoming);
    if (!has(reflect_absorbed)) {
      const auto received = options_.reflected_is_absorbed
                                ? literal::Received::partly_reflected_again
                                : literal::Received::all;
      light = literal::reflected_by_albedo(light, values_of(albedo), neighbour_share, received,
                                           divisor);
    } else {
      for (std::size_t i = 0; i < light.value.size(); ++i) light.value[i] *= 1.0 - albedo.values[i];
      light = literal::listing_9_14(light, neighbour_share, literal::Padding::zeros, divisor);
    }
    return {incoming.columns, incoming.rows, light.value};
  }

  Length soil_depth(double slope_degrees, Length max_depth) const override {
    double depth = in_centimetres(corrected_->soil_depth(slope_degrees, max_depth));
    if (has(dot_as_angle)) {
      const double dot = std::cos(slope_degrees * 3.14159265358979323846 / 180.0);
      depth = literal::listing_9_15(dot, in_centimetres(max_depth));
    }
    return centimetres(through_a_file(depth));
  }

  DailyWater water(Length depth, const Soil& soil, const Biome& biome,
                   DailyEnergy absorbed) const override {
    if (!has(latent_heat_054) && !has(multiply_evaporation))
      return DailyWater(through_a_file(corrected_->water(depth, soil, biome, absorbed).value()));
    const literal::Ground ground{in_centimetres(depth), soil.water_absorption,
                                 biome.groundwater.value(), biome.rain.value()};
    const double kcal_for_1_ml =
        has(latent_heat_054) ? literal::PRINTED_KCAL_PER_ML : heat_of_evaporation.value() / 1000;
    const auto how = has(multiply_evaporation) ? literal::Evaporation::multiplied
                                               : literal::Evaporation::divided;
    return DailyWater(
        through_a_file(literal::listing_9_16(ground, absorbed.value(), kcal_for_1_ml, how)));
  }

  double chance(double available, double needed, Tolerance tolerance) const override {
    if (has(triangle_depth) && tolerance == Tolerance::saturating) tolerance = Tolerance::triangle;
    const bool is_printed = has(zero_need) && needed == 0.0 && tolerance == Tolerance::triangle;
    return through_a_file(is_printed ? literal::listing_9_17(needed, available)
                                     : corrected_->chance(available, needed, tolerance));
  }

 private:
  bool has(LesserErratum erratum) const { return switches_.has(erratum); }

  std::vector<SunDirection> printed_path(const HourlyPath& path) const {
    using literal::ElevationStep;
    literal::Day day{path.hours, path.start_elevation, path.start_azimuth, path.max_elevation};
    day.elevation =
        path.even_hours == EvenHours::tent ? ElevationStep::tent : ElevationStep::one_formula;
    if (has(even_hours_step)) day.elevation = ElevationStep::listing;
    if (has(text_elevation_step)) day.elevation = ElevationStep::text;
    if (!has(two_hour_azimuth)) day.azimuth = literal::AzimuthStep::always_half;
    std::vector<SunDirection> suns;
    for (const literal::Angles& sun : literal::path(day))
      suns.push_back(direction_of({sun.elevation, sun.azimuth}));
    return suns;
  }

  static literal::Values values_of(const TerrainMap& map) {
    return {map.columns, map.rows, map.values};
  }

  /// What a number in a 16-bit image becomes.
  double through_a_file(double value) const {
    if (std::isnan(value)) return value;
    if (has(truncate_images) && has(wrap_images)) return literal::reloaded(value);
    if (has(truncate_images)) return literal::reloaded_without_wrap(value);
    return has(wrap_images) ? literal::reloaded_rounded(value) : value;
  }

  LesserSwitches switches_;
  SiteModelOptions options_;
  std::unique_ptr<SiteModel> corrected_;
};

/// Slow: the literal march, pixel by pixel.
class LiteralMarchShadows final : public ShadowEngine {
 public:
  explicit LiteralMarchShadows(literal::MarchForm form) : form_(form) {}

  ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                  const ShadowSetup& setup, LitMaps& lit) override {
    const literal::Heights heights{field.columns(),
                                   field.rows(),
                                   field.cell_width(),
                                   field.cell_depth(),
                                   {field.heights().begin(), field.heights().end()}};
    const literal::PrintedMarch march(heights, form_);
    return cast_each(field, suns, 1, lit, [&](const SunDirection& sun, std::size_t position) {
      return trace_rows(field.rows(), setup.threads, [&](int row, ShadowWork& work) {
        for (int column = 0; column < field.columns(); ++column) {
          const literal::MarchResult result =
              march.from(column, row, {sun.east, sun.south, sun.up});
          work.samples += result.visited.size();
          work.stuck += result.outcome == literal::Outcome::stuck ||
                        result.outcome == literal::Outcome::crashed;
          if (result.outcome != literal::Outcome::dark) lit.set_lit(position, column, row);
        }
        work.rays += static_cast<std::uint64_t>(field.columns());
      });
    });
  }

 private:
  literal::MarchForm form_;
};

}  // namespace

std::unique_ptr<SiteModel> printed_site_model(const LesserSwitches& switches,
                                              const SiteModelOptions& corrected) {
  return std::make_unique<PrintedSiteModel>(switches, corrected);
}

std::unique_ptr<ShadowEngine> lesser_shadows(const LesserSwitches& switches) {
  if (!switches.has(ray_step_rule)) return shadow_engine_named("exact_traversal").create();
  return std::make_unique<LiteralMarchShadows>(
      literal::MarchForm{.larger_remainder = true,
                         .truncates = switches.has(truncate_towards_zero),
                         .unguarded = switches.has(unguarded_march)});
}

}  // namespace phytobench
