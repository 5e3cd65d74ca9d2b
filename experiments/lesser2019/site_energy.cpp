// SPDX-License-Identifier: MIT
// Sec. 8.2.1, listing 9.13: what the ground gets of a day's sunlight, and what the cosine of
// incidence makes of it.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/oracles/lesser2019_energy.hpp"
#include "reference/oracles/lesser2019_sun.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

constexpr double lit_day = 15600.0;  // kcal/m2: 13 hours

oracle::Losses losses_of(const Biome& biome) {
  return {biome.cloud_percent, biome.absorption_percent, biome.diffusion_percent};
}

/// Listings 9.3, 9.4, 9.13.
void record_polar_dirt(ExperimentContext& context) {
  const Biome polar = polar_zone();
  const Soil dirt = thesis_dirt();
  context.record("polar-dirt/cloud", lit_day * polar.cloud_percent / 100.0, "kcal/m2");
  context.record("polar-dirt/absorption", lit_day * polar.absorption_percent / 100.0, "kcal/m2");
  context.record("polar-dirt/diffusion", lit_day * polar.diffusion_percent / 100.0, "kcal/m2");
  context.record("polar-dirt/losses",
                 polar.cloud_percent + polar.absorption_percent + polar.diffusion_percent,
                 "percent");
  const double through = corrected_site_model()->through_air(DailyEnergy(lit_day), polar).value();
  context.record("polar-dirt/through-air", through, "kcal/m2");
  context.record("polar-dirt/printed/through-air",
                 oracle::through_the_air(lit_day, losses_of(polar)), "kcal/m2");
  context.record("polar-dirt/printed", oracle::listing_9_13(lit_day, losses_of(polar), dirt.albedo),
                 "kcal/m2");
  // As sec. 8.1.3 describes the numbers: between zero and one.
  context.record(
      "polar-dirt/entered-as-fractions",
      oracle::listing_9_13(lit_day,
                           {polar.cloud_percent / 100.0, polar.absorption_percent / 100.0,
                            polar.diffusion_percent / 100.0},
                           dirt.albedo),
      "kcal/m2");
  context.record("polar-dirt/one-after-the-other",
                 corrected_site_model({.sequential_losses = true})
                     ->through_air(DailyEnergy(lit_day), polar)
                     .value(),
                 "kcal/m2");
  TerrainMap incoming{1, 1, {through}}, albedo{1, 1, {dirt.albedo}};
  const double kept = corrected_site_model()->absorbed(incoming, albedo, 0.0, 1).at(0, 0);
  context.record("polar-dirt/kept", kept, "kcal/m2");
  context.record("polar-dirt/thrown-back", through - kept, "kcal/m2");
}

/// Sec. 4.2.2, 8.1.3: each loss takes something, and clouds as much as the same of another.
void record_each_loss(ExperimentContext& context) {
  const auto model = corrected_site_model();
  const Biome clear{.name = "clear sky"};
  const double all = model->through_air(DailyEnergy(lit_day), clear).value();
  context.record("clear-sky", all, "kcal/m2");
  std::int64_t not_less = 0;
  for (double Biome::*const loss :
       {&Biome::cloud_percent, &Biome::absorption_percent, &Biome::diffusion_percent}) {
    double before = all;
    for (int percent = 10; percent <= 100; percent += 10) {
      Biome biome = clear;
      biome.*loss = percent;
      const double left = model->through_air(DailyEnergy(lit_day), biome).value();
      not_less += !(left < before);
      before = left;
    }
  }
  context.record("steps-without-less-energy", not_less, "steps");
}

void record_limits(ExperimentContext& context) {
  // 103 percent.
  const Biome impossible{.name = "impossible",
                         .absorption_percent = 45.0,
                         .diffusion_percent = 8.0,
                         .cloud_percent = 50.0};
  context.record("over-100/printed", oracle::listing_9_13(lit_day, losses_of(impossible), 0.25),
                 "kcal/m2");
  bool is_refused = false;
  try {
    check_losses(impossible);
  } catch (const InputError&) {
    is_refused = true;
  }
  context.record("over-100/refused", std::int64_t{is_refused});
  check_losses(polar_zone());
  // Nothing is lost, all that neighbours have is added: a day of 24 hours, twice.
  context.record("largest", 24.0 * hourly_solar_energy.value() * 2.0, "kcal/m2");
  context.record("largest/of-16-bits", std::int64_t{65535});
}

/// What 13 hours bring a flat map: as printed, and by the sun's height.
void record_cosine(ExperimentContext& context) {
  const auto sum = [](const SiteModelOptions& options, double max_elevation) {
    const auto model = corrected_site_model(options);
    double energy = 0.0;
    for (const SunDirection& sun : model->sun_path({.hours = 13, .max_elevation = max_elevation}))
      energy += model->hourly_energy({0.0, 0.0}, sun).value();
    return energy;
  };
  const double printed = sum({.cosine = false}, 90.0), corrected = sum({}, 90.0);
  context.record("flat/printed", printed, "kcal/m2");
  context.record("flat/with-cosine", corrected, "kcal/m2");
  context.record("flat/with-cosine/closed-form",
                 1200.0 / std::tan(7.5 * (std::numbers::pi / 180.0)), "kcal/m2");
  context.record("flat/printed-over-with-cosine", printed / corrected);
  context.record("flat/with-cosine/max-80", sum({}, 80.0), "kcal/m2");
  context.record("flat/share-of-the-hours-at-the-horizon", 2.0 * 1200.0 / printed);
}

/// What comes to a horizontal area above the air, anywhere and on any day.
void record_bound(ExperimentContext& context) {
  constexpr double measured_solar_constant = 1361.0;  // W/m2, Kopp and Lean 2011
  constexpr double nearest_to_the_sun = 1.0344;       // the Earth's orbit is no circle
  double greatest = 0.0;
  for (int latitude = -89; latitude <= 89; ++latitude)
    for (double declination = -23.44; declination <= 23.45; declination += 0.586)
      greatest = std::max(
          greatest, oracle::top_of_atmosphere(latitude, declination, measured_solar_constant));
  context.record("top-of-atmosphere/greatest", greatest, "kcal/m2");
  context.record("top-of-atmosphere/bound", greatest * nearest_to_the_sun, "kcal/m2");
  context.record("top-of-atmosphere/equator-equinox",
                 oracle::top_of_atmosphere(0.0, 0.0, measured_solar_constant), "kcal/m2");
  context.record("top-of-atmosphere/weissbach-equinox",
                 oracle::top_of_atmosphere(47.52, 0.0, measured_solar_constant), "kcal/m2");
  context.record("flat-over-bound", lit_day / (greatest * nearest_to_the_sun));
}

void run(ExperimentContext& context) {
  record_polar_dirt(context);
  record_each_loss(context);
  record_limits(context);
  record_cosine(context);
  record_bound(context);
}

}  // namespace

extern const ExperimentDescriptor site_energy;
constinit const ExperimentDescriptor site_energy{
    .id = "lesser2019/site-energy",
    .question = "How much of the sun's energy reaches the ground in a day?",
    .source = "[Lesser2019] sec. 8.2, 8.2.1, listing 9.13",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
