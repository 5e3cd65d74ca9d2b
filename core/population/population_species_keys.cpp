// SPDX-License-Identifier: MIT
// Keys of [[species]] in a population file.
#include <cmath>

#include "core/competition/competition_ranges.hpp"
#include "core/population/population_keys.hpp"

namespace phytobench {

namespace {

namespace ranges = competition_ranges;
using population_key::choice;
using population_key::number;
using Keys = std::vector<PopulationKey>;
using Values = PopulationFileValues;

/// Radii of stems, m: below the lower one zones have no area that can be computed with.
constexpr NumberRange stem_radius{.low = 1e-9, .high = 1000};
constexpr NumberRange share_range{.high = 1};
constexpr NumberRange zone_factor{.high = 1e6, .low_is_allowed = false};
constexpr NumberRange zone_exponent{.high = 3};
constexpr double most_steps = 1e9;

Keys size_keys() {
  return {{"species.name", "-", "", "how results and other keys call it", "phytobench",
           PopulationText{"a text without commas and quotes, not \"*\"",
                          [](Values & v) -> auto& {return v.species.name;
}
}  // namespace
, true, false, false, "\"oak\""
}  // namespace phytobench
,
    {"species.count",
     "plants",
     "0",
     "plants that start at random places",
     "[Alsweis] sec. 5.5 A",
     number(
         {.high = 1e9}, [](auto& v) -> auto& { return v.species.count; }),
     false,
     false,
     false,
     "100"},
    {"species.start_radius",
     "m",
     "[0.03, 0.07]",
     "smallest and largest stem radius that they start with, uniform between",
     "phytobench",
     PopulationPair{stem_radius,
                    [](const Values& v) {
                      return Point2{v.species.start_radius_low, v.species.start_radius_high};
                    },
                    [](Values& v, const Point2& p) {
                      v.species.start_radius_low = p.x;
                      v.species.start_radius_high = p.y;
                    }}},
    {"species.largest_radius",
     "m",
     "0.5",
     "stem radius R_max that growth ends at",
     "[Alsweis] (5.8)",
     number(
         stem_radius, [](auto& v) -> auto& { return v.species.largest_radius; })},
    {"species.growth",
     "-",
     "\"basal\"",
     "law of growth: (5.8) for stems, or Richards' law (2.1) with k = growth_rate / "
     "largest_radius",
     "[Alsweis] (2.1), (5.8)",
     choice(
         {"basal", "richards"}, [](auto& v) -> auto& { return v.species.growth; })},
    {"species.growth_rate",
     "m per step",
     "0.05",
     "growth rate MGR, four times the fastest growth under \"basal\"; at most largest_radius per "
     "step",
     "[Alsweis] (5.8), erratum E18",
     number(
         {.high = 1000}, [](auto& v) -> auto& { return v.species.growth_rate; })},
    {"species.growth_shape",
     "-",
     "2.0",
     "shape delta of Richards' law: 0 saturating, 1 Gompertz, 2 logistic; for growth = "
     "\"richards\"",
     "[Alsweis] (2.1)",
     number(
         {.high = 100}, [](auto& v) -> auto& { return v.species.growth_shape; })},
    {"species.largest_age",
     "steps",
     "inf",
     "age at which it dies",
     "[Alsweis] sec. 4.5",
     number(
         {.low = 1, .high = most_steps, .infinity_is_allowed = true},
         [](auto& v) -> auto& { return v.species.largest_age; })},
}
;
}

Keys zone_keys() {
  return {
      {"species.root_factor", "m^(1-b)", "15.0",
       "factor d of the root zone's radius d R^b, the only zone in rules of chapter 4",
       "[Alsweis] (4.1)",
       number(
           zone_factor, [](auto& v) -> auto& { return v.root_factor; }),
       false, false, true},
      {"species.root_factor_poor", "m^(1-b)", "15.0",
       "factor d on black places of resources.nutrients, with root_factor_rich instead of "
       "root_factor",
       "[Alsweis] sec. 4.7",
       number(
           zone_factor, [](auto& v) -> auto& { return v.species.roots.poor_factor; }),
       false, true},
      {"species.root_factor_rich", "m^(1-b)", "6.0", "factor d on white places",
       "[Alsweis] sec. 4.7",
       number(
           zone_factor, [](auto& v) -> auto& { return v.species.roots.rich_factor; }),
       false, true},
      {"species.root_exponent", "-", "0.5", "exponent b of the root zone", "[Alsweis] (4.1)",
       number(
           zone_exponent, [](auto& v) -> auto& { return v.species.roots.exponent; })},
      {"species.crown_factor", "m^(1-b)", "15.0", "factor d of the crown zone",
       "[Alsweis] (4.1), sec. 5.2",
       number(
           zone_factor, [](auto& v) -> auto& { return v.crown_factor; }),
       false, false, true},
      {"species.crown_factor_poor", "m^(1-b)", "15.0",
       "factor d on black places of resources.light, with crown_factor_rich instead of "
       "crown_factor",
       "[Alsweis] sec. 5.5 E",
       number(
           zone_factor, [](auto& v) -> auto& { return v.species.crown.poor_factor; }),
       false, true},
      {"species.crown_factor_rich", "m^(1-b)", "6.0", "factor d on white places",
       "[Alsweis] sec. 5.5 E",
       number(
           zone_factor, [](auto& v) -> auto& { return v.species.crown.rich_factor; }),
       false, true},
      {"species.crown_exponent", "-", "0.5", "exponent b of the crown zone", "[Alsweis] (4.1)",
       number(
           zone_exponent, [](auto& v) -> auto& { return v.species.crown.exponent; })},
  };
}

Keys trait_keys() {
  return {
      {"species.crown_opacity", "share", "1.0",
       "opacity L / q of the crown: 0 takes half of the light, 1 all; for rules light and combined",
       "[Alsweis] (7.2), erratum E22",
       number(
           ranges::crown_opacity, [](auto& v) -> auto& { return v.species.traits.crown_opacity; })},
      {"species.roots", "-", "\"deep\"",
       "how much its roots take from neighbours, T_f / m; for rules roots and combined",
       "[Alsweis] (7.3), table 7.1",
       PopulationChoice{{"flat", "medium", "deep"},
                        [](const Values& v) {
                          return static_cast<std::size_t>(
                              std::lround(2.0 * v.species.traits.root_rank));
                        },
                        [](Values& v, std::size_t word) {
                          v.species.traits.root_rank = 0.5 * static_cast<double>(word);
                        }}},
      {"species.open_ground_stress", "-", "0.0",
       "loss that only helpers make up for; for rules nurse and combined", "[Alsweis] sec. 7.4",
       number(
           ranges::open_ground_stress,
           [](auto& v) -> auto& { return v.species.traits.open_ground_stress; })},
  };
}

std::vector<std::string_view> dispersal_words() {
  std::vector<std::string_view> words;
  for (const DispersalLaw law : all_dispersal_laws) words.push_back(name_of(law));
  return words;
}

Keys seed_keys() {
  return {
      {"species.reproduction.threshold", "m", "inf", "stem radius from which on it bears seeds",
       "[Alsweis] sec. 4.4",
       number(
           {.high = 1000, .infinity_is_allowed = true},
           [](auto& v) -> auto& { return v.species.reproduction.threshold; })},
      {"species.reproduction.seeds_per_metre", "1/m per step", "0.0",
       "mean number of seeds in a step, per stem radius above the threshold", "[Alsweis] sec. 4.4",
       number(
           {.high = 1e6}, [](auto& v) -> auto& { return v.species.reproduction.seeds_per_metre; })},
      {"species.reproduction.dispersal", "-", "\"radial-exponential\"",
       "law of the distance that seeds fall at", "[Alsweis] (4.6), erratum E9",
       choice(
           dispersal_words(), [](auto& v) -> auto& { return v.species.reproduction.dispersal; })},
      {"species.reproduction.dispersal_distance", "m", "5.0", "scale lambda of that law",
       "[Alsweis] (4.6)",
       number(
           {.high = 1e6, .low_is_allowed = false},
           [](auto& v) -> auto& { return v.species.reproduction.dispersal_distance; })},
      {"species.reproduction.seed_mortality", "share", "0.0",
       "share pi of all seeds that dies in a step", "[Alsweis] sec. 4.6",
       number(
           share_range, [](auto& v) -> auto& { return v.species.reproduction.seed_mortality; })},
      {"species.reproduction.dormant_share", "share", "0.0",
       "share sigma of fresh seeds that rests in the soil", "[Alsweis] sec. 4.6",
       number(
           share_range, [](auto& v) -> auto& { return v.species.reproduction.dormant_share; })},
      {"species.reproduction.germination_rate", "share", "0.0",
       "share gamma of resting seeds that germinates in a step", "[Alsweis] sec. 4.6",
       number(
           share_range, [](auto& v) -> auto& { return v.species.reproduction.germination_rate; })},
      {"species.reproduction.establishment", "share", "1.0",
       "share p of germinating seeds that becomes plants", "[Alsweis] (4.9)",
       number(
           share_range, [](auto& v) -> auto& { return v.species.reproduction.establishment; })},
      {"species.reproduction.seedling_radius", "m", "0.001", "stem radius of a new plant",
       "phytobench",
       number(
           stem_radius, [](auto& v) -> auto& { return v.species.reproduction.seedling_radius; })},
  };
}

}  // namespace

std::vector<PopulationKey> species_keys() {
  Keys all;
  for (const Keys& more : {size_keys(), zone_keys(), trait_keys(), seed_keys()})
    all.insert(all.end(), more.begin(), more.end());
  return all;
}

}  // namespace phytobench
