// SPDX-License-Identifier: MIT
#include "cli/compete_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"
#include "cli/option_values.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

void add_row(ordered_json& row, const Fates& fates, const PlantStatistics& plants) {
  row["start"] = fates.start;
  row["born"] = fates.born;
  row["died"] = fates.died;
  row["alive"] = plants.plants;
  row["resting_seeds"] = fates.resting_seeds;
  row["density"] = plants.density;
  row["mean_radius"] = number_or_null(plants.mean_radius);
  row["largest_radius"] = number_or_null(plants.largest_radius);
  row["basal_area"] = plants.basal_area;
  row["gini"] = number_or_null(plants.gini);
  row["mean_loss"] = number_or_null(plants.mean_loss);
  row["oppressed_share"] = number_or_null(plants.oppressed_share);
}

ordered_json ground_json(const PopulationParameters& parameters) {
  const Rectangle& ground = parameters.ground;
  return {{"corner", {ground.low.x, ground.low.y}},
          {"size", {ground.width(), ground.height()}},
          {"torus", parameters.is_torus},
          {"area", ground.area()}};
}

/// Means over no plants are a dash.
std::string cell(double value, const char* format) {
  return std::isnan(value) ? "-" : fmt::format(fmt::runtime(format), value);
}

std::string table_line(std::size_t width, const std::string& name, const Fates& fates,
                       const PlantStatistics& plants) {
  return fmt::format("{:<{}}  {:>8}  {:>8}  {:>8}  {:>8}  {:>9}  {:>10}  {:>6}  {:>6}\n", name,
                     width, fates.start, fates.born, fates.died, plants.plants,
                     cell(plants.mean_radius, "{:.4f}"), cell(plants.basal_area, "{:.4f}"),
                     cell(plants.gini, "{:.4f}"), cell(plants.mean_loss, "{:.3f}"));
}

std::string table(const CompeteFindings& f) {
  const std::vector<Species>& species = f.population.parameters().species;
  std::size_t width = std::string("species").size();
  for (const Species& one : species) width = std::max(width, one.name.size());
  std::string text =
      fmt::format("{:<{}}  {:>8}  {:>8}  {:>8}  {:>8}  {:>9}  {:>10}  {:>6}  {:>6}\n", "species",
                  width, "start", "born", "died", "alive", "radius m", "basal m^2", "Gini", "loss");
  const std::vector<Fates> fates = fates_of(f.population.state(), f.start);
  for (std::size_t k = 0; k < species.size(); ++k)
    text += table_line(width, species[k].name, fates[k], f.last.statistics.species[k]);
  if (species.size() > 1) text += table_line(width, "all", fates.back(), f.last.statistics.all);
  return text;
}

double pairs_per_step(const CompeteFindings& f) {
  return static_cast<double>(f.pairs) / f.population.state().step;  // NaN without a step
}

std::string name_of_run(const CompeteOptions& options) {
  return options.preset.empty() ? options.config : "preset " + options.preset;
}

}  // namespace

std::string compete_json(const CompeteFindings& f, const CompeteOptions& options) {
  const PopulationParameters& parameters = f.population.parameters();
  ordered_json json{{"schema", "phytobench/compete-1"},
                    {"config", text_or_null(options.config)},
                    {"preset", text_or_null(options.preset)},
                    {"plants", text_or_null(options.plants)},
                    {"seed", parameters.seed},
                    {"rule", parameters.rule},
                    {"engine", options.engine},
                    {"steps", f.population.state().step},
                    {"ground", ground_json(parameters)},
                    {"species", ordered_json::array()}};
  const std::vector<Fates> fates = fates_of(f.population.state(), f.start);
  for (std::size_t k = 0; k < parameters.species.size(); ++k) {
    ordered_json row{{"name", parameters.species[k].name}};
    add_row(row, fates[k], f.last.statistics.species[k]);
    json["species"].push_back(row);
  }
  json["all"] = ordered_json::object();
  add_row(json["all"], fates.back(), f.last.statistics.all);
  json["pattern"] = nullptr;
  if (f.pattern)
    json["pattern"] = {{"clark_evans", number_or_null(f.pattern->clark_evans)},
                       {"hopkins", number_or_null(f.pattern->hopkins)},
                       {"mean_nearest_distance", number_or_null(f.pattern->mean_nearest_distance)}};
  json["pairs"] = f.pairs;
  json["pairs_per_step"] = number_or_null(pairs_per_step(f));
  json["files"] = f.files;
  return json_text(json) + "\n";
}

std::string compete_text(const CompeteFindings& f, const CompeteOptions& options) {
  const PopulationParameters& parameters = f.population.parameters();
  const Rectangle& ground = parameters.ground;
  std::string text =
      fmt::format("{}: {} steps, seed {}, rule {}, {} of {:g} m by {:g} m\n\n",
                  name_of_run(options), f.population.state().step, parameters.seed, parameters.rule,
                  parameters.is_torus ? "torus" : "plot", ground.width(), ground.height());
  text += table(f) + "\n";
  if (f.pattern)
    text += fmt::format(
        "Clark-Evans R = {:.4f}, Hopkins index {:.4f}, nearest neighbour {:.4g} m away on "
        "average\n",
        f.pattern->clark_evans, f.pattern->hopkins, f.pattern->mean_nearest_distance);
  if (f.population.state().step > 0)
    text += fmt::format("{:.1f} overlaps of zones in a step\n", pairs_per_step(f));
  if (!f.files.empty())
    text += fmt::format("wrote to {}: {}\n", options.out, fmt::join(f.files, ", "));
  return text;
}

}  // namespace phytobench::cli
