// SPDX-License-Identifier: MIT
#include "cli/compete_start.hpp"

#include <algorithm>
#include <filesystem>
#include <limits>
#include <numeric>

#include <fmt/format.h>

#include "cli/compete_folder.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/population/plants_file.hpp"
#include "core/population/population_file.hpp"
#include "reference/stand_presets.hpp"

namespace phytobench::cli {

namespace fs = std::filesystem;

namespace {

/// All that the files of a run depend on, beside the number of steps.
std::vector<Setting> settings_of_run(const CompeteOptions& options, const CompeteStart& start) {
  std::vector<Setting> settings = settings_of(start.parameters);
  std::string plants;
  for (const StartPlant& plant : start.plants)
    plants += fmt::format("{} {} {} {}\n", plant.place.x, plant.place.y, plant.stem_radius,
                          plant.species);
  settings.push_back({"plants to start with",
                      fmt::format("{}, digest {:016x}", start.plants.size(), digest(plants))});
  // Another engine hands over pairs in another order, and sums over them round otherwise.
  settings.push_back({"--engine", options.engine});
  settings.push_back({"--every", fmt::to_string(options.every.value_or(1))});
  settings.push_back({"--frames", fmt::to_string(options.frames)});
  if (options.frames > 0) settings.push_back({"--frame-format", options.frame_format});
  return settings;
}

std::vector<std::uint64_t> plants_by_species(const CompeteStart& start, const fs::path& file) {
  std::vector<std::uint64_t> count;
  for (const Species& species : start.parameters.species)
    count.push_back(static_cast<std::uint64_t>(species.count));
  for (const StartPlant& plant : start.plants) ++count[plant.species];
  if (std::accumulate(count.begin(), count.end(), std::uint64_t{0}) == 0)
    throw InputError(file.string() +
                     ": the stand has no plant to start with, and only plants bear seeds; give a "
                     "species a count in [[species]], or name a CSV file with plants or --plants");
  return count;
}

/// Whether a name leads to a place in the folder that it starts from.
bool stays_inside(const fs::path& name) {
  return name.is_relative() && std::find(name.begin(), name.end(), "..") == name.end();
}

class RunInputs {
 public:
  explicit RunInputs(const std::string& parameter_file)
      : files_{{parameters_name, parameter_file}} {}

  /// A file that parameters.toml names, and so must be found under that name.
  void add_named(const NamedFile& named, const fs::path& parameter_file) {
    const fs::path name = fs::path(named.name).lexically_normal();
    if (!stays_inside(named.name) || !fs::is_regular_file(named.file) || find(name)) return;
    if (is_name_of_run(name))
      throw InputError(fmt::format(
          "{}: names {}, which is also a file that the run writes into --out, where it copies "
          "what it starts from; rename it",
          parameter_file.string(), named.name));
    files_.push_back({name, read(named.file)});
  }

  /// That of --plants. A pipe has been read and cannot be read again.
  void add_plants(const fs::path& file) {
    if (!fs::is_regular_file(file)) return;
    std::string content = read(file);
    fs::path name = file.filename();
    for (const FileContent* same = find(name); is_name_of_run(name) || same; same = find(name)) {
      if (same && same->content == content) return;
      name = "start-" + name.string();
    }
    files_.push_back({name, std::move(content)});
  }

  std::vector<FileContent> taken() { return std::move(files_); }

 private:
  static std::string read(const fs::path& file) {
    return read_text_file(file, std::numeric_limits<std::uintmax_t>::max());
  }

  const FileContent* find(const fs::path& name) const {
    for (const FileContent& file : files_)
      if (file.file == name) return &file;
    return nullptr;
  }

  std::vector<FileContent> files_;
};

}  // namespace

CompeteStart read_start(const CompeteOptions& options) {
  fs::path file = options.config;
  if (!options.preset.empty()) file = stand_preset_file(options.preset);
  const std::string parameter_file = read_text_file(file);
  PopulationFile read = parse_population(parameter_file, file);
  CompeteStart start;
  start.parameters = std::move(read.parameters);
  if (options.steps) start.parameters.steps = *options.steps;
  if (options.seed) start.parameters.seed = *options.seed;
  if (!options.rule.empty()) start.parameters.rule = competition_rule_named(options.rule).name;
  check_parameters(start.parameters);
  if (!options.plants.empty()) read.plants = options.plants;
  if (!read.plants.empty()) start.plants = read_plants_file(read.plants, start.parameters);
  start.count = plants_by_species(start, file);
  start.settings = settings_of_run(options, start);
  if (options.out.empty()) return start;
  RunInputs inputs(parameter_file);
  for (const NamedFile& named : read.files) inputs.add_named(named, file);
  if (!options.plants.empty()) inputs.add_plants(options.plants);
  start.inputs = inputs.taken();
  return start;
}

}  // namespace phytobench::cli
