// SPDX-License-Identifier: MIT
// Shares of ground on square cells, as grid-based models have them, against the exact ones.
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "core/competition/cell_grid.hpp"
#include "core/overlap/ground_shares.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/power_law.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/alsweis/zone_stand.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// The grid may lie anywhere: so many places of the stand within a cell.
constexpr int places = 24;

/// Errors on the cells of one grid after the other.
class ErrorMeter {
 public:
  explicit ErrorMeter(const ZoneStand& stand)
      : stand_(stand), stems_(stand.stems()), field_(stand.losses("field_of_neighbourhood")) {
    for (std::size_t d = 0; d < exact_.size(); ++d)
      exact_[d] = ground_shares(stand.zones(), {}, {.exponent = divisions[d].exponent});
  }

  void try_grid(double side, double dx, double dy) {
    ZoneStand moved = stand_;
    for (double& x : moved.x) x += dx;
    for (double& y : moved.y) y += dy;
    for (std::size_t d = 0; d < exact_.size(); ++d) {
      const CellShares shares =
          cell_shares(moved.zones(), {}, side, {.exponent = divisions[d].exponent});
      for (std::size_t i = 0; i < stand_.size(); ++i)
        add((shares.won[i] - exact_[d][i]) / stand_.area(i), won[d]);
    }
    const CellField fields = cell_field(moved.zones(), stems_, field_at_rim, {}, side);
    for (std::size_t i = 0; i < stand_.size(); ++i)
      if (fields.cells[i] > 0) add(fields.mean[i] - field_[i], field);
    bare.add(static_cast<double>(std::count(fields.cells.begin(), fields.cells.end(), 0)));
  }

  struct Errors {
    RunningMoments squares;
    double largest = 0.0;

    double typical() const { return std::sqrt(squares.mean()); }
  };
  std::array<Errors, 2> won;  ///< of each division: of what a plant wins, in its own area
  Errors field;               ///< of the mean field over a plant that has a cell
  RunningMoments bare;        ///< plants without a cell

 private:
  static void add(double error, Errors& errors) {
    errors.squares.add(error * error);
    errors.largest = std::max(errors.largest, std::abs(error));
  }
  static constexpr double field_at_rim = CompetitionParameters().field_at_rim;

  const ZoneStand& stand_;
  std::vector<double> stems_, field_;
  std::array<std::vector<double>, 2> exact_;
};

/// iLand has cells of 2 m, pyMANGA up to 0.25 m, siplab 0.2 m unless told otherwise, IBC-grass
/// 1 cm.
std::vector<double> cell_sides(Tier tier) {
  std::vector<double> sides = {2, 1, 0.5, 0.25, 0.2, 0.1, 0.05, 0.02};
  if (tier != Tier::smoke) sides.insert(sides.end(), {0.01, 0.005});
  if (tier == Tier::full) sides.insert(sides.end(), {0.002, 0.001});
  return sides;
}

void record_errors(ExperimentContext& context, const std::string& name,
                   const ErrorMeter::Errors& errors, double side, PlotCurve& curve) {
  context.record({.experiment = {},
                  .measurement = name + "/typical_error",
                  .value = errors.typical(),
                  .sample_size = errors.squares.count(),
                  .seed = context.seed()});
  context.record(name + "/largest_error", errors.largest);
  curve.x.push_back(side);
  curve.y.push_back(errors.typical());
}

/// The power of the side with which errors fall once cells are much narrower than any plant.
void record_exponent(ExperimentContext& context, const std::string& name, const PlotCurve& curve) {
  constexpr double widest = 0.1;
  std::vector<double> x, y;
  for (std::size_t k = 0; k < curve.x.size(); ++k) {
    if (curve.x[k] > widest) continue;
    x.push_back(curve.x[k]);
    y.push_back(curve.y[k]);
  }
  const auto law = fit_power_law(x, y);
  context.record(name + "/exponent", law->exponent.value);
  context.record(name + "/exponent_low", law->exponent.low);
  context.record(name + "/exponent_high", law->exponent.high);
}

void draw(ExperimentContext& context, const std::vector<PlotCurve>& curves) {
  PlotPanel panel{.curves = curves,
                  .caption = "five plants, the grid laid in 24 places",
                  .x_label = "side of a cell in m",
                  .y_label = "typical error",
                  .log_x = true,
                  .log_y = true};
  PlotCurve law{.name = "side^1.5", .x = curves[0].x, .y = {}, .style = PlotStyle::dotted};
  for (const double side : law.x) law.y.push_back(0.1 * std::pow(side, 1.5));
  panel.curves.push_back(law);
  add_plot(context, "cell-errors",
           {.title = "Errors of shares on square cells",
            .description = "Typical error over the side of a cell, both axes logarithmic, beside a "
                           "line of slope 3/2.",
            .panels = {panel}});
}

void run(ExperimentContext& context) {
  const ZoneStand stand = five_plants();
  std::vector<PlotCurve> curves(3);
  curves[0].name = "equal shares, in the plant's area";
  curves[1].name = "all to the largest, the same";
  curves[2].name = "mean field over a plant";
  for (const double side : cell_sides(context.tier())) {
    context.progress(fmt::format("cells of {} m", side));
    ErrorMeter meter(stand);
    CounterStream stream(context.seed(), 0);
    for (int k = 0; k < places; ++k) {
      const double dx = side * stream.next_unit();
      meter.try_grid(side, dx, side * stream.next_unit());
    }
    const std::string name = fmt::format("side-{}", side);
    for (std::size_t d = 0; d < meter.won.size(); ++d)
      record_errors(context, name + "/" + divisions[d].name, meter.won[d], side, curves[d]);
    record_errors(context, name + "/field", meter.field, side, curves[2]);
    context.record(name + "/plants_without_cell", meter.bare.mean(), "plants");
  }
  for (std::size_t c = 0; c < curves.size(); ++c)
    record_exponent(context, c < 2 ? divisions[c].name : "field", curves[c]);
  draw(context, curves);
}

}  // namespace

extern const ExperimentDescriptor shared_ground_cells;
constinit const ExperimentDescriptor shared_ground_cells{
    .id = "alsweis/shared-ground-cells",
    .question = "How wrong are shares of ground that are counted in square cells?",
    .source = "[Alsweis] sec. 1.2; cells as pyMANGA, siplab, IBC-grass and iLand have them",
    .seconds = {1, 2, 40},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
