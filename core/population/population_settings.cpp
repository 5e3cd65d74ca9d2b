// SPDX-License-Identifier: MIT
#include "core/population/population_settings.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace phytobench {

namespace {

class SettingList {
 public:
  template <class Value>
  void add(const std::string& key, const Value& value) {
    if constexpr (std::is_enum_v<Value>)
      settings.push_back({key, fmt::to_string(static_cast<int>(value))});
    else
      settings.push_back({key, fmt::format("{}", value)});
  }

  std::vector<Setting> settings;
};

// Each function takes its structure apart into all its members: a member that is added later does
// not compile until it is listed here.

void add(SettingList& list, const std::string& key, const ZoneLaw& zone) {
  const auto& [poor_factor, rich_factor, exponent] = zone;
  list.add(key + "_factor_poor", poor_factor);
  list.add(key + "_factor_rich", rich_factor);
  list.add(key + "_exponent", exponent);
}

void add(SettingList& list, const std::string& key, const CompetitionTraits& traits) {
  const auto& [crown_opacity, root_rank, open_ground_stress] = traits;
  list.add(key + ".crown_opacity", crown_opacity);
  list.add(key + ".roots", root_rank);
  list.add(key + ".open_ground_stress", open_ground_stress);
}

void add(SettingList& list, const std::string& key, const ReproductionParameters& reproduction) {
  const auto& [threshold, seeds_per_metre, dispersal, dispersal_distance, seed_mortality,
               dormant_share, germination_rate, establishment, seedling_radius] = reproduction;
  list.add(key + ".threshold", threshold);
  list.add(key + ".seeds_per_metre", seeds_per_metre);
  list.add(key + ".dispersal", name_of(dispersal));
  list.add(key + ".dispersal_distance", dispersal_distance);
  list.add(key + ".seed_mortality", seed_mortality);
  list.add(key + ".dormant_share", dormant_share);
  list.add(key + ".germination_rate", germination_rate);
  list.add(key + ".establishment", establishment);
  list.add(key + ".seedling_radius", seedling_radius);
}

void add(SettingList& list, const Species& species) {
  const auto& [name, count, start_radius_low, start_radius_high, largest_radius, growth,
               growth_rate, growth_shape, roots, crown, traits, largest_age, reproduction] =
      species;
  const std::string key = "species." + name;
  list.add(key + ".count", count);
  list.add(key + ".start_radius", fmt::format("{} to {}", start_radius_low, start_radius_high));
  list.add(key + ".largest_radius", largest_radius);
  list.add(key + ".growth", growth);
  list.add(key + ".growth_rate", growth_rate);
  list.add(key + ".growth_shape", growth_shape);
  add(list, key + ".root", roots);
  add(list, key + ".crown", crown);
  add(list, key, traits);
  list.add(key + ".largest_age", largest_age);
  add(list, key + ".reproduction", reproduction);
}

std::string signs(const std::vector<Influence>& influence) {
  std::string text;
  for (const Influence sign : influence)
    text += sign == Influence::harms ? 'N' : sign == Influence::helps ? 'P' : '0';
  return text;
}

void add(SettingList& list, const CompetitionParameters& competition) {
  // Traits are listed with their species.
  const auto& [above_share, asymmetry_exponent, ties, light_constant, field_at_rim, species,
               influence_above, influence_below] = competition;
  list.add("competition.above_share", above_share);
  list.add("competition.asymmetry_exponent", asymmetry_exponent);
  list.add("competition.ties", ties);
  list.add("competition.light_constant", light_constant);
  list.add("competition.field_at_rim", field_at_rim);
  list.add("competition.influence_above", signs(influence_above));
  list.add("competition.influence_below", signs(influence_below));
}

void add(SettingList& list, const MortalityParameters& mortality) {
  const auto& [rule, window, threshold, grown_up] = mortality;
  list.add("mortality.rule", rule);
  list.add("mortality.window", window);
  list.add("mortality.threshold", threshold);
  list.add("mortality.grown_up", grown_up);
}

void add(SettingList& list, const std::string& key, const PopulationEvent& event) {
  const auto& [kind, step, species, plants, largest, share] = event;
  list.add(key, fmt::format("{} in step {}, species {}, plants [{}], largest {}, share {}",
                            kind == EventKind::disease ? "disease" : "removal", step,
                            species ? static_cast<int>(*species) : -1, fmt::join(plants, " "),
                            largest, share));
}

void add(SettingList& list, const std::string& key, const ResourceMap& map) {
  std::uint64_t hash = digest_of_nothing;
  for (const double value : map.values()) hash = digest(fmt::format("{} ", value), hash);
  list.add(key, map.is_uniform() ? "none"
                                 : fmt::format("{} by {} cells, digest {:016x}", map.columns(),
                                               map.rows(), hash));
}

}  // namespace

std::vector<Setting> settings_of(const PopulationParameters& parameters) {
  const auto& [seed, steps, ground, is_torus, rule, competition, species, mortality, illness,
               bad_year_share, events, nutrients, light, most_plants] = parameters;
  SettingList list;
  list.add("seed", seed);
  list.add("competition.rule", rule);
  list.add("ground.corner", fmt::format("[{}, {}]", ground.low.x, ground.low.y));
  list.add("ground's far corner", fmt::format("[{}, {}]", ground.high.x, ground.high.y));
  list.add("ground.torus", is_torus);
  std::vector<std::string> names;
  for (const Species& one : species) names.push_back(one.name);
  list.add("species", fmt::to_string(fmt::join(names, ", ")));
  for (const Species& one : species) add(list, one);
  add(list, competition);
  add(list, mortality);
  const auto& [duration, is_deadly] = illness;
  list.add("illness.duration", duration);
  list.add("illness.is_deadly", is_deadly);
  list.add("seasons.bad_year_share", bad_year_share);
  for (std::size_t i = 0; i < events.size(); ++i)
    add(list, fmt::format("event {}", i + 1), events[i]);
  add(list, "resources.nutrients", nutrients);
  add(list, "resources.light", light);
  return std::move(list.settings);
}

std::uint64_t digest(std::string_view bytes, std::uint64_t before) {
  std::uint64_t hash = before;
  for (const char byte : bytes) {
    hash ^= static_cast<unsigned char>(byte);
    hash *= 0x100000001b3ULL;
  }
  return hash;
}

}  // namespace phytobench
