// SPDX-License-Identifier: MIT
#include "core/competition/competition_parameters.hpp"

#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/competition/competition_ranges.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

namespace ranges = competition_ranges;

void check(std::string_view name, double value, const NumberRange& range) {
  if (!is_allowed(value, range)) throw InputError(out_of_range(name, value, range));
}

void check_traits(const CompetitionTraits& traits, std::size_t species) {
  const auto name = [&](const char* key) {
    return fmt::format("{} of species number {}", key, species + 1);
  };
  check(name("species.crown_opacity"), traits.crown_opacity, ranges::crown_opacity);
  check(name("species.roots"), traits.root_rank, ranges::root_rank);
  check(name("species.open_ground_stress"), traits.open_ground_stress, ranges::open_ground_stress);
}

void check_influence(std::string_view where, const std::vector<Influence>& influence,
                     std::size_t species) {
  if (influence.empty()) return;
  if (influence.size() != species * species)
    throw InputError(
        fmt::format("influence.{} has {} entries; give one for each of {} x {} species, or none",
                    where, influence.size(), species, species));
  const bool all_are_signs = std::all_of(influence.begin(), influence.end(), [](Influence sign) {
    return sign == Influence::helps || sign == Influence::none || sign == Influence::harms;
  });
  if (!all_are_signs)
    throw InputError(
        fmt::format("influence.{} has an entry that neither harms, helps nor is none", where));
}

}  // namespace

void check_parameters(const CompetitionParameters& parameters) {
  const CompetitionParameters& p = parameters;
  check("competition.above_share", p.above_share, ranges::above_share);
  check("competition.asymmetry_exponent", p.asymmetry_exponent, ranges::asymmetry_exponent);
  check("competition.light_constant", p.light_constant, ranges::light_constant);
  check("competition.field_at_rim", p.field_at_rim, ranges::field_at_rim);
  for (std::size_t i = 0; i < p.species.size(); ++i) check_traits(p.species[i], i);
  check_influence("above", p.influence_above, p.species.size());
  check_influence("below", p.influence_below, p.species.size());
}

}  // namespace phytobench
