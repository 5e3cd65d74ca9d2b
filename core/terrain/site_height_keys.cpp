// SPDX-License-Identifier: MIT
// Keys of [heights] and [model] in a site file.
#include <limits>

#include "core/terrain/site_keys.hpp"

namespace phytobench {

namespace {

using Keys = std::vector<SiteKey>;
using Values = SiteFileValues;

/// Above it not every whole number is a double.
constexpr double largest_seed = 9007199254740991;
constexpr NumberRange cell_range{.low = 0.01, .high = 1e5};
/// With one row or column nothing has a slope.
constexpr NumberRange side_range{.low = 2.0, .high = 16384.0, .whole = true};
constexpr NumberRange height_range_m{.high = 1e5, .low_is_allowed = false};

constexpr SiteKeyCondition for_files{
    "heights.file", [](const SiteDescription& d) { return !d.heights.file.empty(); }};
constexpr SiteKeyCondition for_made{
    "heights.made", [](const SiteDescription& d) { return d.heights.file.empty(); }};

template <MadeTerrain... kinds>
bool makes(const SiteDescription& site) {
  return site.heights.file.empty() && ((site.heights.made == kinds) || ...);
}

constexpr SiteKeyCondition for_fractals{"heights.made = \"fractal\" or \"diamond-square\"",
                                        makes<MadeTerrain::fractal, MadeTerrain::diamond_square>};
constexpr SiteKeyCondition for_slopes{
    "heights.made = \"plane\", \"ridge\", \"valley\" or \"cone\"",
    makes<MadeTerrain::plane, MadeTerrain::ridge, MadeTerrain::valley, MadeTerrain::cone>};
constexpr SiteKeyCondition for_planes{"heights.made = \"plane\"", makes<MadeTerrain::plane>};
constexpr SiteKeyCondition for_round_forms{
    "heights.made = \"cone\", \"hemisphere\" or \"ring-wall\"",
    makes<MadeTerrain::cone, MadeTerrain::hemisphere, MadeTerrain::ring_wall>};
constexpr SiteKeyCondition for_walls{"heights.made = \"ring-wall\"", makes<MadeTerrain::ring_wall>};
constexpr SiteKeyCondition for_reliefs{
    "heights.made = \"fractal\", \"diamond-square\", \"ring-wall\" or \"needle\"",
    makes<MadeTerrain::fractal, MadeTerrain::diamond_square, MadeTerrain::ring_wall,
          MadeTerrain::needle>};

Keys file_keys() {
  return {
      {"heights.file", "-", "\"heights.png\"",
       "map of heights: .asc, grey .png of 8 or 16 bits, .csv, or what GDAL reads; north is at the "
       "top",
       "[Lesser2019] listing 9.5",
       SiteFileName{[](Values& v) -> std::string& { return v.site.heights.file; }}, false, true},
      {"heights.conversion", "m", "0.1",
       "height of a step of the numbers in the file; 1 without it", "[Lesser2019] listing 9.5",
       SiteNumber{{.high = 1e6, .low_is_allowed = false},
                  [](Values& v, double x) { v.site.heights.conversion = x; }},
       false, true, for_files},
      {"heights.cell_width", "m", "16.0",
       "between columns; without it what the file says, or 16 of a made terrain",
       "[Lesser2019] listing 9.5",
       SiteNumber{cell_range, [](Values& v, double x) { v.site.heights.cell_width = x; }}, false,
       true},
      {"heights.cell_depth", "m", "16.0", "between rows; as wide without it", "phytobench",
       SiteNumber{cell_range, [](Values& v, double x) { v.site.heights.cell_depth = x; }}, false,
       true},
  };
}

Keys made_keys() {
  return {
      {"heights.made", "-", "\"fractal\"",
       "a terrain that is made, instead of heights.file; all are centred in the map", "phytobench",
       SiteChoice{
           {"fractal", "diamond-square", "flat", "plane", "ridge", "valley", "cone", "hemisphere",
            "ring-wall", "needle"},
           [](Values& v, std::size_t i) { v.site.heights.made = static_cast<MadeTerrain>(i); }}},
      {"heights.columns", "-", "256", "from west to east", "phytobench",
       SiteNumber{side_range,
                  [](Values& v, double x) { v.site.heights.columns = static_cast<int>(x); }},
       false, false, for_made},
      {"heights.rows", "-", "256", "from north to south", "phytobench",
       SiteNumber{side_range,
                  [](Values& v, double x) { v.site.heights.rows = static_cast<int>(x); }},
       false, false, for_made},
      {"heights.relief", "m", "400.0", "from the lowest to the highest place", "phytobench",
       SiteNumber{height_range_m, [](Values& v, double x) { v.site.heights.relief = x; }}, false,
       false, for_reliefs},
      {"heights.roughness", "-", "0.5",
       "how much of the swing of one size of hills the next smaller one has", "phytobench",
       SiteNumber{{.high = 1.0, .low_is_allowed = false},
                  [](Values& v, double x) { v.site.heights.roughness = x; }},
       false, false, for_fractals},
      {"heights.seed", "-", "1", "of a fractal", "phytobench",
       SiteNumber{{.high = largest_seed, .whole = true},
                  [](Values& v, double x) { v.site.heights.seed = static_cast<std::uint64_t>(x); }},
       false, false, for_fractals},
  };
}

Keys form_keys() {
  return {
      {"heights.slope", "degrees", "30.0",
       "of a plane or cone, or of the flanks of a ridge or valley from west to east", "phytobench",
       SiteNumber{{.high = 89.0}, [](Values& v, double x) { v.site.heights.slope_degrees = x; }},
       false, true, for_slopes},
      {"heights.aspect", "degrees", "90.0", "where a plane falls to, from east over south",
       "phytobench",
       SiteNumber{{.high = 360.0}, [](Values& v, double x) { v.site.heights.aspect_degrees = x; }},
       false, true, for_planes},
      {"heights.radius", "m", "1000.0", "of a cone's foot, a hemisphere or a ring wall",
       "phytobench",
       SiteNumber{{.high = 1e6, .low_is_allowed = false},
                  [](Values& v, double x) { v.site.heights.radius = x; }},
       false, true, for_round_forms},
      {"heights.thickness", "m", "50.0", "of a ring wall", "phytobench",
       SiteNumber{{.high = 1e6, .low_is_allowed = false},
                  [](Values& v, double x) { v.site.heights.thickness = x; }},
       false, true, for_walls},
  };
}

}  // namespace

std::vector<SiteKey> site_height_keys() {
  Keys keys = file_keys();
  for (const Keys& more : {made_keys(), form_keys()})
    keys.insert(keys.end(), more.begin(), more.end());
  return keys;
}

std::vector<SiteKey> site_choice_keys() {
  return {
      {"model.engine", "-", "\"bounded_sweep\"", "what finds the shadows",
       "phytobench list shadow-engines",
       SiteText{"a name of phytobench list shadow-engines",
                [](Values& v) -> std::string& { return v.site.choices.engine; }}},
      {"model.cosine", "-", "true",
       "whether light that falls at an angle brings less; the thesis has it bring all",
       "[Lesser2019] erratum E07",
       SiteSwitch{[](Values& v, bool x) { v.site.choices.options.cosine = x; }}},
      {"model.sequential_losses", "-", "false",
       "whether the air's losses follow each other, instead of being shares of the whole",
       "[Lesser2019] listing 9.13, erratum E19",
       SiteSwitch{[](Values& v, bool x) { v.site.choices.options.sequential_losses = x; }}},
      {"model.reflected_is_absorbed", "-", "true",
       "whether light from neighbours is partly thrown back again",
       "[Lesser2019] listing 9.14, erratum E13",
       SiteSwitch{[](Values& v, bool x) { v.site.choices.options.reflected_is_absorbed = x; }}},
      {"model.surface", "-", "\"sobel\"", "how slopes are found from the heights around a place",
       "[Lesser2019] sec. 8.3",
       SiteChoice{{"sobel", "six-faces", "other-six", "unit-faces"},
                  [](Values& v, std::size_t i) {
                    v.site.choices.surface = static_cast<SurfaceEstimator>(i);
                  }}},
      {"model.depth_tolerance", "-", "\"saturating\"",
       "how the chance to grow depends on the soil's depth: deeper than needed is no harm, or a "
       "harm as too much light is, or all or nothing, or no matter",
       "[Lesser2019] sec. 8.6, erratum E21",
       SiteChoice{{"triangle", "saturating", "threshold", "ignored"},
                  [](Values& v, std::size_t i) {
                    v.site.choices.depth_tolerance = static_cast<Tolerance>(i);
                  }}},
  };
}

}  // namespace phytobench
