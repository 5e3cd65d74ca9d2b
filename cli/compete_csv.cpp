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
#include "core/population/stand_look.hpp"

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

/// Curves of some columns of steps.csv: solid by species, in their colours; dashed, in the text's,
/// for all.
class StandCurves {
 public:
  explicit StandCurves(const std::vector<std::string>& species) {
    // Of one species alone "all" says nothing more.
    const bool has_all = species.size() > 1;
    const char* captions[] = {"Plants", "Inequality of basal area", "Mean stem radius"};
    const char* labels[] = {"plants alive", "Gini coefficient", "radius, m"};
    for (std::size_t p = 0; p < std::size(columns); ++p) {
      CurvePanel panel{
          .curves = {}, .caption = captions[p], .x_label = "step", .y_label = labels[p]};
      for (std::size_t k = 0; k < species.size(); ++k)
        panel.curves.push_back({.name = species[k],
                                .x = {},
                                .y = {},
                                .style = k < species_hues ? CurveStyle::solid : CurveStyle::dotted,
                                .colour = curve_colour(k)});
      if (has_all && p != radius) {
        panel.curves.push_back({.name = "", .x = {}, .y = {}, .style = CurveStyle::dashed});
        panel.caption += " (dashed: all)";
      }
      panels_.push_back(std::move(panel));
    }
  }

  /// One line of steps.csv; `k` is the species, or their number for all.
  void add(std::size_t k, const std::vector<std::string_view>& fields) {
    for (std::size_t p = 0; p < std::size(columns); ++p) {
      if (k >= panels_[p].curves.size()) continue;
      const double value = number_in(fields.at(columns[p]));
      panels_[p].curves[k].x.push_back(number_in(fields.at(0)));
      panels_[p].curves[k].y.push_back(value);
      if (!std::isnan(value)) highest_[p] = std::max(highest_[p], value);
    }
  }

  std::string drawn() && {
    constexpr double fewest = 4.0;  // where ticks are whole numbers still
    panels_[plants].y_range =
        rounded_outwards({0.0, std::max(fewest, highest_[plants])}, AxisScale::linear);
    std::vector<CurvePanel> shown;
    for (std::size_t p = 0; p < std::size(columns); ++p) {
      if (highest_[p] < 0.0) continue;  // no value at all
      if (p == radius) panels_[p].y_range = rounded_outwards({0.0, highest_[p]}, AxisScale::linear);
      shown.push_back(std::move(panels_[p]));
    }
    return curve_svg(
        shown,
        "Plants, the inequality of their basal areas and their mean stem radius over the steps");
  }

 private:
  enum : std::size_t { plants, inequality, radius };
  static constexpr std::size_t columns[] = {2, 8, 6};  ///< of steps.csv

  std::vector<CurvePanel> panels_;
  double highest_[std::size(columns)] = {-1.0, -1.0, -1.0};
};

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
  StandCurves curves(species);
  std::size_t row = 0;
  for (std::size_t at = steps_csv.find('\n') + 1; at < steps_csv.size(); ++row) {
    const std::size_t end = steps_csv.find('\n', at);
    curves.add(row % (species.size() + 1), fields_of(steps_csv.substr(at, end - at)));
    at = end + 1;
  }
  return std::move(curves).drawn();
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
