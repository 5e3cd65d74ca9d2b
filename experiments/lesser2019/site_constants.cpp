// SPDX-License-Identifier: MIT
// Numbers that the thesis converts from one unit to another, converted once more.
#include <cmath>

#include "core/terrain/site_model.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

/// Sec. 8.2: 2 cal/cm2 a minute.
void record_solar_constant(ExperimentContext& context) {
  constexpr double calories_per_cm2_and_minute = 2.0, cm2_per_m2 = 1e4, calories_per_kcal = 1e3;
  const double per_minute = calories_per_cm2_and_minute * cm2_per_m2 / calories_per_kcal;
  context.record("kcal-per-minute", per_minute, "kcal/m2/min");
  context.record("kcal-per-hour", per_minute * 60.0, "kcal/m2/h");
  context.record("kcal-per-hour/of-the-suite", hourly_solar_energy.value(), "kcal/m2/h");
  // 1361 W/m2 is the solar constant of Kopp and Lean 2011.
  constexpr double measured_watt_per_m2 = 1361.0, joule_per_calorie = 4.184;
  const double measured = measured_watt_per_m2 * 60.0 / joule_per_calorie / cm2_per_m2;
  context.record("solar-constant", measured, "cal/cm2/min");
  context.record("solar-constant/printed-over-measured", calories_per_cm2_and_minute / measured);
}

/// Sec. 8.5: from J/kg to kcal/ml.
void record_heat_of_evaporation(ExperimentContext& context) {
  constexpr double joule_per_kg = 2.5e6, joule_per_kcal = 4184.0, printed_kcal_per_joule = 2.39e-4,
                   printed_kcal_per_ml = 0.54, last_printed_digit = 0.01;
  context.record("kcal-per-joule", 1.0 / joule_per_kcal, "kcal/J");
  context.record("joule-per-gram", joule_per_kg / 1000.0, "J/g");
  const double product = joule_per_kg / 1000.0 * printed_kcal_per_joule;
  context.record("latent-heat", product, "kcal/ml");
  context.record("latent-heat/printed", printed_kcal_per_ml, "kcal/ml");
  context.record("latent-heat/of-the-suite", heat_of_evaporation.value() / 1000.0, "kcal/ml");
  context.record("latent-heat/half-digits-off",
                 std::abs(product - printed_kcal_per_ml) / (last_printed_digit / 2.0));
  context.record("latent-heat/joule-per-gram-of-the-printed", printed_kcal_per_ml * joule_per_kcal,
                 "J/g");
}

/// Sec. 8.1.4 and listing 9.5.
void record_map(ExperimentContext& context) {
  constexpr double conversion_m = 0.1, pixel_m = 16.0;
  constexpr int pixels = 512, grey_levels = 65536;
  context.record("height-step", conversion_m * 100.0, "cm");
  context.record("height-step/highest", conversion_m * (grey_levels - 1), "m");
  context.record("extent", pixels * pixel_m / 1000.0, "km");
  context.record("extent/between-first-and-last", (pixels - 1) * pixel_m / 1000.0, "km");
}

void run(ExperimentContext& context) {
  record_solar_constant(context);
  record_heat_of_evaporation(context);
  record_map(context);
}

}  // namespace

extern const ExperimentDescriptor site_constants;
constinit const ExperimentDescriptor site_constants{
    .id = "lesser2019/site-constants",
    .question = "What do the numbers of the thesis become in other units?",
    .source = "[Lesser2019] sec. 8.1.4, 8.2, 8.5, listing 9.5",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
