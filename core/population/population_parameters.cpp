// SPDX-License-Identifier: MIT
#include "core/population/population_parameters.hpp"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <set>

#include <fmt/format.h>

#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/population/population_keys.hpp"

namespace phytobench {

namespace {

/// A table of influence has the square of it.
constexpr std::size_t most_species = 1000;
constexpr std::size_t longest_name = 100;

/// Stops at the first problem, which it keeps.
class ProblemSearch {
 public:
  explicit ProblemSearch(const PopulationParameters& parameters)
      : p_(parameters), values_(file_values_of(parameters)) {}

  std::optional<PopulationProblem> first() {
    check_ranges("", "");
    check_ground();
    check_all_species();
    check_competition();
    check_mortality();
    for (std::size_t i = 0; i < p_.events.size(); ++i) check_event(i);
    return problem_;
  }

 private:
  /// Keys as in "species[0].count".
  void report(std::vector<std::string> keys, const std::string& text,
              const std::string& whose = "") {
    if (!problem_) problem_ = PopulationProblem{std::move(keys), text, whose};
  }

  /// Holds the keys of a list to their ranges, or all that are in none; `path` is an entry.
  void check_ranges(std::string_view list, const std::string& path, const std::string& whose = "") {
    for (const PopulationKey& key : population_keys()) {
      const std::string_view top = key.name.substr(0, key.name.find('.'));
      const bool is_meant = list.empty() ? !is_list_of_population(top) : top == list;
      if (!is_meant || key.is_of_file_alone) continue;
      for (const auto& [value, range] : numbers_of(key))
        if (!is_allowed(value, range))
          report({list.empty() ? std::string(key.name)
                               : path + std::string(key.name.substr(list.size()))},
                 out_of_range(key.name, value, range), whose);
    }
  }

  std::vector<std::pair<double, NumberRange>> numbers_of(const PopulationKey& key) const {
    if (const auto* kind = std::get_if<PopulationNumber>(&key.kind))
      return {{kind->value(values_), kind->range}};
    if (const auto* kind = std::get_if<PopulationPair>(&key.kind)) {
      const Point2 pair = kind->value(values_);
      return {{pair.x, kind->range}, {pair.y, kind->range}};
    }
    return {};
  }

  void check_ground() {
    const Rectangle& ground = p_.ground;
    // The corner may have rounded a side that is just long enough.
    constexpr double rounding = 1e-6;
    const NumberRange side{.low = ground_side.low - rounding, .high = ground_side.high + rounding};
    for (const double length : {ground.width(), ground.height()})
      if (!is_allowed(length, side))
        report({"ground.size", "ground.corner"}, out_of_range("ground.size", length, ground_side));
    for (const double place : {ground.low.x, ground.low.y})
      if (!is_allowed(place, ground_corner))
        report({"ground.corner"}, out_of_range("ground.corner", place, ground_corner));
  }

  void check_all_species() {
    if (p_.species.empty()) report({}, "there is no species; give at least one [[species]]");
    if (p_.species.size() > most_species)
      report({"species"}, fmt::format("{} species are too many; give at most {}", p_.species.size(),
                                      most_species));
    std::set<std::string> names;
    double plants = 0.0;
    for (std::size_t i = 0; i < p_.species.size() && !problem_; ++i) {
      const std::string path = fmt::format("species[{}]", i), &name = p_.species[i].name;
      check_name(path + ".name", name);
      if (!names.insert(name).second)
        report({path + ".name"}, fmt::format("there are two species '{}'; rename one", name));
      check_species(p_.species[i], path, fmt::format("species '{}': ", name));
      plants += static_cast<double>(p_.species[i].count);
      if (plants > static_cast<double>(p_.most_plants))
        report({path + ".count"}, fmt::format("species.count adds up to {} plants; give at most {}",
                                              plants, p_.most_plants));
    }
  }

  void check_name(const std::string& key, const std::string& name) {
    const auto is_odd = [](char c) {
      return c == ',' || c == '"' || std::iscntrl(static_cast<unsigned char>(c)) != 0;
    };
    // Tables of plants name species: what they cannot write is no name.
    if (name.empty() || name == "*" || name == "all" || name.size() > longest_name ||
        name.front() == ' ' || name.back() == ' ' || std::any_of(name.begin(), name.end(), is_odd))
      report({key}, fmt::format("species.name = '{}' is not allowed; give 1 to {} characters, not "
                                "\"*\", without commas and quotes",
                                in_one_line(name), longest_name));
  }

  void check_species(const Species& species, const std::string& path, const std::string& whose) {
    values_.species = species;
    check_ranges("species", path, whose);
    check_sizes(species, path, whose);
    check_growth(species, path, whose);
    check_seeds(species.reproduction, species.largest_radius, path, whose);
  }

  void check_sizes(const Species& s, const std::string& path, const std::string& whose) {
    if (s.start_radius_low > s.start_radius_high)
      report({path + ".start_radius"},
             fmt::format("species.start_radius = [{}, {}] begins with the larger; exchange them",
                         s.start_radius_low, s.start_radius_high),
             whose);
    if (s.start_radius_high > s.largest_radius)
      report({path + ".start_radius", path + ".largest_radius"},
             fmt::format("species.start_radius = {} exceeds species.largest_radius = {}; lower the "
                         "one or raise the other",
                         s.start_radius_high, s.largest_radius),
             whose);
  }

  void check_growth(const Species& s, const std::string& path, const std::string& whose) {
    if (s.growth_rate > s.largest_radius)
      report({path + ".growth_rate", path + ".largest_radius"},
             fmt::format("species.growth_rate = {} in a step exceeds species.largest_radius = {}; "
                         "one step would overshoot: lower it and give more steps",
                         s.growth_rate, s.largest_radius),
             whose);
    if (s.growth == GrowthLaw::richards && s.growth_rate == 0.0)
      report({path + ".growth_rate", path + ".growth"},
             "species.growth_rate = 0 is no growth by Richards' law; give a rate > 0, or "
             "species.growth = \"basal\"",
             whose);
  }

  void check_seeds(const ReproductionParameters& seeds, double largest_radius,
                   const std::string& path, const std::string& whose) {
    if (seeds.seeds_per_metre == 0.0) return;
    const std::string section = path + ".reproduction.";
    if (seeds.threshold >= largest_radius)
      report({section + "threshold", section + "seeds_per_metre"},
             fmt::format("species.reproduction.threshold = {} is not below species.largest_radius "
                         "= {}: no plant would bear seeds; lower it, or leave seeds_per_metre out",
                         seeds.threshold, largest_radius),
             whose);
    if (seeds.seedling_radius >= largest_radius)
      report({section + "seedling_radius", path + ".largest_radius"},
             fmt::format("species.reproduction.seedling_radius = {} is not below "
                         "species.largest_radius = {}; lower it",
                         seeds.seedling_radius, largest_radius),
             whose);
  }

  void check_competition() {
    if (problem_) return;
    CompetitionParameters competition = p_.competition;
    competition.species.clear();
    for (const Species& species : p_.species) competition.species.push_back(species.traits);
    try {
      check_parameters(competition);
      competition_rule_named(p_.rule);
    } catch (const InputError& error) {
      report({"competition.rule"}, error.what());
    }
  }

  void check_mortality() {
    if (p_.mortality.rule != MortalityRule::none && p_.mortality.threshold == 0.0)
      report({"mortality.threshold", "mortality.rule"},
             "mortality.threshold = 0 lets no plant die; give one > 0, or mortality.rule = "
             "\"none\"");
  }

  void check_event(std::size_t i) {
    const PopulationEvent& event = p_.events[i];
    const std::string path = fmt::format("event[{}]", i);
    values_.event = event;
    check_ranges("event", path);
    if (event.species && *event.species >= p_.species.size())
      report({path + ".species"}, fmt::format("event.species is number {} of {} species",
                                              *event.species + 1, p_.species.size()));
    if (event.largest < 0 || !(event.share >= 0.0 && event.share <= 1.0))
      report({path + ".largest", path + ".share"},
             fmt::format("event.largest = {}, event.share = {} is not allowed; give a number >= 1 "
                         "of plants, or a share > 0 and <= 1",
                         event.largest, event.share));
    const int selections = !event.plants.empty() + (event.largest > 0) + (event.share > 0.0);
    if (selections != 1)
      report({path},
             fmt::format("event.plants, event.largest and event.share: {} of them strike plants; "
                         "give exactly one",
                         selections == 0 ? "none" : "several"));
    if (!event.plants.empty() && event.species)
      report({path + ".species"},
             "event.species does not go with event.plants, which are named; leave it out");
  }

  const PopulationParameters& p_;
  PopulationFileValues values_;
  std::optional<PopulationProblem> problem_;
};

}  // namespace

std::optional<PopulationProblem> find_problem(const PopulationParameters& parameters) {
  return ProblemSearch(parameters).first();
}

void check_parameters(const PopulationParameters& parameters) {
  if (const auto problem = find_problem(parameters))
    throw InputError(problem->whose + problem->text);
}

}  // namespace phytobench
