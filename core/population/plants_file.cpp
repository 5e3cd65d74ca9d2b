// SPDX-License-Identifier: MIT
#include "core/population/plants_file.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/csv_file.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

namespace {

/// Finds the species of a name.
class SpeciesIndices {
 public:
  explicit SpeciesIndices(const std::vector<Species>& species) {
    for (std::size_t i = 0; i < species.size(); ++i)
      indices_[species[i].name] = static_cast<SpeciesIndex>(i);
  }

  std::optional<SpeciesIndex> of(const std::string& name) const {
    const auto found = indices_.find(name);
    return found == indices_.end() ? std::nullopt : std::optional(found->second);
  }

  std::string suggestion(const std::string& name) const {
    std::vector<std::string> known;
    for (const auto& [species, index] : indices_) known.push_back(species);
    return did_you_mean(name, known);
  }

 private:
  std::map<std::string, SpeciesIndex> indices_;
};

/// What is wrong with the plant, or "".
std::string problem_with(const StartPlant& plant, const PopulationParameters& parameters) {
  const Rectangle& ground = parameters.ground;
  const auto& [x, y] = plant.place;
  if (!ground.contains(plant.place))
    return fmt::format(
        "x = {}, y = {} is not on the ground from {}, {} to {}, {}; move the plant "
        "or enlarge ground.size",
        x, y, ground.low.x, ground.low.y, ground.high.x, ground.high.y);
  const Species& species = parameters.species[plant.species];
  if (!(plant.stem_radius >= smallest_stem_radius && plant.stem_radius <= species.largest_radius))
    return fmt::format(
        "radius = {} is not allowed; give a number >= {} and <= {}, the "
        "largest_radius of species '{}'",
        plant.stem_radius, smallest_stem_radius, species.largest_radius, species.name);
  return "";
}

}  // namespace

std::vector<StartPlant> read_plants_file(const std::filesystem::path& file,
                                         const PopulationParameters& parameters) {
  PHYTOBENCH_EXPECT(!parameters.species.empty());
  std::vector<std::string> words;
  // Without it read_table() says what is missing.
  if (parameters.species.size() > 1 || has_column(file, "species")) words.push_back("species");
  const CsvTable table = read_table(file, {"x", "y", "radius"}, words);
  const std::size_t count = table.numbers[0].size();
  if (count > parameters.most_plants)
    throw InputError(fmt::format("{}: has {} plants; give at most {}", file.string(), count,
                                 parameters.most_plants));
  const SpeciesIndices species(parameters.species);
  std::vector<StartPlant> plants(count);
  for (std::size_t i = 0; i < count; ++i) {
    const auto fail = [&](const std::string& problem) {
      throw InputError(place_of_row(file, i) + ": " + problem);
    };
    StartPlant& plant = plants[i];
    plant.place = {table.numbers[0][i], table.numbers[1][i]};
    plant.stem_radius = table.numbers[2][i];
    if (!words.empty()) {
      const std::string& name = table.words[0][i];
      const auto index = species.of(name);
      if (!index)
        fail(fmt::format("species = '{}' is not in the parameter file{}", in_one_line(name),
                         species.suggestion(name)));
      plant.species = *index;
    }
    if (const std::string problem = problem_with(plant, parameters); !problem.empty())
      fail(problem);
  }
  return plants;
}

}  // namespace phytobench
