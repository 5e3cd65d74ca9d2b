// SPDX-License-Identifier: MIT
#include "cli/compete_csv.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/picture/curve_svg.hpp"
#include "core/population/mortality.hpp"

namespace phytobench::cli {

namespace {

/// As short as it can be read back. A minus before NaN depends on the machine.
std::string csv(double value) {
  return std::isnan(value) ? "NaN" : fmt::to_string(value);
}

/// The comma-separated fields of a line, without copies.
std::vector<std::string_view> fields_of(std::string_view line) {
  std::vector<std::string_view> fields;
  for (std::size_t begin = 0; begin <= line.size();) {
    const std::size_t end = std::min(line.find(',', begin), line.size());
    fields.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return fields;
}

double number_in(std::string_view field) {
  double value = 0.0;
  const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
  PHYTOBENCH_EXPECT(error == std::errc() && end == field.data() + field.size());
  return value;
}

}  // namespace

std::string steps_header() {
  return "step,species,alive,born,died,resting_seeds,mean_radius,basal_area,gini,mean_loss,"
         "density\n";
}

std::string steps_rows(const Population& population, const StandStatistics& statistics,
                       const std::vector<std::uint64_t>& start) {
  const PopulationState& state = population.state();
  const std::vector<Species>& species = population.parameters().species;
  const std::vector<Fates> fates = fates_of(state, start);
  std::string text;
  for (std::size_t k = 0; k <= species.size(); ++k) {
    const bool is_all = k == species.size();
    const PlantStatistics& plants = is_all ? statistics.all : statistics.species[k];
    text +=
        fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", state.step,
                    is_all ? "all" : species[k].name, plants.plants, fates[k].born, fates[k].died,
                    fates[k].resting_seeds, csv(plants.mean_radius), csv(plants.basal_area),
                    csv(plants.gini), csv(plants.mean_loss), csv(plants.density));
  }
  return text;
}

std::string curves_of(std::string_view steps_csv, const std::vector<std::string>& species) {
  constexpr std::size_t alive = 2, gini = 8;
  // Of one species alone "all" says nothing more.
  const std::size_t shown = species.size() > 1 ? species.size() + 1 : 1;
  CurvePanel plants{
      .curves = {}, .caption = "Plants", .x_label = "step", .y_label = "plants alive"};
  CurvePanel inequality{
      .curves = {}, .caption = "Inequality", .x_label = "step", .y_label = "Gini coefficient"};
  for (std::size_t k = 0; k < shown; ++k)
    for (CurvePanel* panel : {&plants, &inequality})
      panel->curves.push_back({k < species.size() ? species[k] : "all", {}, {}});
  bool has_gini = false;
  std::size_t row = 0;
  for (std::size_t at = steps_csv.find('\n') + 1; at < steps_csv.size(); ++row) {
    const std::size_t end = steps_csv.find('\n', at);
    const std::vector<std::string_view> fields = fields_of(steps_csv.substr(at, end - at));
    at = end + 1;
    const std::size_t k = row % (species.size() + 1);
    if (k >= shown) continue;
    const double step = number_in(fields.at(0)), inequality_now = number_in(fields.at(gini));
    has_gini = has_gini || !std::isnan(inequality_now);
    for (CurvePanel* panel : {&plants, &inequality}) panel->curves[k].x.push_back(step);
    plants.curves[k].y.push_back(number_in(fields.at(alive)));
    inequality.curves[k].y.push_back(inequality_now);
  }
  std::vector<CurvePanel> panels{std::move(plants)};
  if (has_gini) panels.push_back(std::move(inequality));
  return curve_svg(panels, "Plants and the inequality of their basal areas over the steps");
}

std::string plants_csv(const CompeteFindings& f) {
  const PopulationState& state = f.population.state();
  const Stand& stand = state.stand;
  std::string text;
  const auto out = std::back_inserter(text);
  fmt::format_to(out,
                 "id,species,x,y,radius,age,ill_since,root_radius,crown_radius,loss,"
                 "recent_growth\n");
  for (const std::size_t i : order_of_ids(stand))
    fmt::format_to(out, "{},{},{},{},{},{},{},{},{},{},{}\n", stand.id[i],
                   f.population.parameters().species[stand.species[i]].name, stand.x[i], stand.y[i],
                   stand.stem_radius[i], stand.age[i], stand.ill_since[i], f.last.root_radius[i],
                   f.last.crown_radius[i], f.last.loss[i], mean_recent_growth(state, i));
  return text;
}

}  // namespace phytobench::cli
