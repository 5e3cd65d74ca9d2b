// SPDX-License-Identifier: MIT
// Figure 4.6: emissivities and albedos, and what a surface of water reflects.
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"
#include "reference/oracles/lesser2019_growth.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

namespace oracle = oracles::lesser2019;

void run(ExperimentContext& context) {
  constexpr double snow = 0.84;    // sec. 4.2.2
  constexpr double water = 1.333;  // refractive index
  const std::vector<TomlTable> surfaces = thesis_parameters().tables("surface");
  const double of_water = thesis_entry("surface", "water").number("albedo");
  std::int64_t in_range = 0, darker_than_snow = 0, darker_than_water = 0;
  for (const TomlTable& surface : surfaces) {
    const auto is_share = [](double number) { return number > 0.0 && number < 1.0; };
    const double albedo = surface.number("albedo");
    in_range += is_share(surface.number("emissivity")) && is_share(albedo);
    darker_than_snow += albedo < snow;
    darker_than_water += albedo < of_water;
  }
  context.record("rows", whole(surfaces.size()), "rows");
  context.record("in-range", in_range, "rows");
  context.record("rows-below-snow", darker_than_snow, "rows");
  context.record("rows-below-water", darker_than_water, "rows");
  const double diffuse = oracle::diffuse_fresnel(water);
  context.record("water/diffuse", diffuse);
  context.record("water/from-above", oracle::fresnel(0.0, water));
  context.record("water-ratio", of_water / diffuse);
}

}  // namespace

extern const ExperimentDescriptor albedo_table;
constinit const ExperimentDescriptor albedo_table{
    .id = "lesser2019/albedo-table",
    .question = "Are the albedos of the table shares, and is that of water one that water has?",
    .source = "[Lesser2019] figure 4.6, sec. 4.2.2",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
