// SPDX-License-Identifier: MIT
// Cells whose plants migrate to their neighbours: what (2.12) to (2.14) conserve, for which
// migration they settle, and what clipping negative counts costs.
#include <algorithm>
#include <cmath>
#include <functional>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "core/population/cell_map_svg.hpp"
#include "core/population/cell_population.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/cell_fields.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"
#include "reference/oracles/alsweis_population.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace oracles = phytobench::oracles::alsweis::population;

/// alpha = 0.3 is the largest fertility that the text allows; K = 1.
LogisticMap map_of(double fertility = 0.3) {
  return LogisticMap::of_rate(1.0 + fertility, 1.0);
}

/// The counts of random_field(), between 0 and 1.
oracles::CellCounts literal_field(const ExperimentContext& context, std::size_t width,
                                  std::size_t height) {
  oracles::CellCounts N(width, std::vector<double>(height));
  for (std::size_t x = 0; x < width; ++x)
    for (std::size_t y = 0; y < height; ++y) N[x][y] = random_unit(context.seed(), y, x);
  return N;
}

/// (2.12), literally, in the middle of fields whose second differences are known.
void record_operator(ExperimentContext& context) {
  constexpr std::size_t side = 7;
  const auto middle = [](const std::function<double(double, double)>& field) {
    oracles::CellCounts N(side, std::vector<double>(side));
    for (std::size_t x = 0; x < side; ++x)
      for (std::size_t y = 0; y < side; ++y)
        N[x][y] = field(static_cast<double>(x), static_cast<double>(y));
    return oracles::equation_2_12(N, side / 2, side / 2);
  };
  context.record("operator/constant", middle([](double, double) { return 7.0; }), "plants");
  context.record("operator/linear", middle([](double x, double y) { return 2.0 * x - 5.0 * y; }),
                 "plants");
  context.record("operator/squares", middle([](double x, double y) { return x * x + y * y; }),
                 "plants");
  const oracles::CellCounts N = literal_field(context, side, side);
  double sum = 0.0;
  for (std::size_t x = 0; x < side; ++x)
    for (std::size_t y = 0; y < side; ++y) sum += oracles::equation_2_12(N, x, y);
  context.record("operator/sum_over_torus", std::abs(sum), "plants");
}

/// The suite's cells beside the literal equation (2.14), at a migration that clips now and then.
void record_agreement(ExperimentContext& context) {
  constexpr std::size_t width = 12, height = 8;
  CellPopulation ours({width, height}, {0.24, CellStep::positive_part, CellBorder::torus},
                      map_of());
  fill(ours, random_field(context.seed(), 0.0, 1.0));
  oracles::CellCounts literal = literal_field(context, width, height);
  double largest = 0.0;
  for (int t = 0; t < 100; ++t) {
    ours.step();
    literal = oracles::equation_2_14(literal, 0.3, -1.3, 0.24);
    for (std::size_t x = 0; x < width; ++x)
      for (std::size_t y = 0; y < height; ++y)
        largest = std::max(largest, std::abs(ours.count_at(x, y) - literal[x][y]));
  }
  context.record("agreement/largest_difference", largest, "plants");
}

void record_uniform(ExperimentContext& context) {
  for (const double fertility : {0.3, 2.2}) {
    CellPopulation cells({16, 16}, {0.2, CellStep::unclipped, CellBorder::torus},
                         map_of(fertility));
    fill(cells, [](auto, auto) { return 0.1; });
    double off = 0.0;
    for (const double expected : orbit(map_of(fertility), 0.1, 1000)) {
      off = std::max(
          {off, std::abs(largest_of(cells) - expected), std::abs(least_of(cells) - expected)});
      cells.step();
    }
    context.record(fmt::format("uniform/alpha-{}/difference_from_map", fertility), off, "plants");
    const double equilibrium = map_of(fertility).equilibrium();
    fill(cells, [=](auto, auto) { return equilibrium; });
    run_years(cells, 10);
    context.record(fmt::format("uniform/alpha-{}/move_of_equilibrium", fertility),
                   std::max(largest_of(cells) - equilibrium, equilibrium - least_of(cells)),
                   "plants");
  }
}

/// Migration alone for 10,000 years.
void record_conservation(ExperimentContext& context) {
  for (const CellBorder border :
       {CellBorder::torus, CellBorder::reflecting, CellBorder::absorbing}) {
    CellPopulation cells({17, 13}, {0.2, CellStep::unclipped, border}, LogisticMap{});
    fill(cells, random_field(context.seed(), 0.0, 10.0));
    const double before = cells.total();
    run_years(cells, 10'000);
    context.record(fmt::format("conservation/{}/relative_change", name_of(border)),
                   cells.total() / before - 1.0);
  }
}

/// Random deviations up to 1 % of the capacity from the uniform equilibrium, 5000 years later.
double spread_of(const ExperimentContext& context, double migration, CellStep step) {
  CellPopulation cells({16, 16}, {migration, step, CellBorder::torus}, map_of());
  const double equilibrium = map_of().equilibrium();
  fill(cells, random_field(context.seed(), equilibrium - 0.01, equilibrium + 0.01));
  run_years(cells, 5000);
  return largest_of(cells) - least_of(cells);
}

/// By what a checkerboard of a billionth is multiplied in one year.
double checkerboard_factor(double fertility, double migration) {
  constexpr double size = 1e-9;
  CellPopulation cells({4, 4}, {migration, CellStep::unclipped, CellBorder::torus},
                       map_of(fertility));
  const double equilibrium = map_of(fertility).equilibrium();
  fill(cells, checkerboard(equilibrium + size, equilibrium - size));
  const double before = cells.count_at(0, 0) - cells.count_at(1, 0);
  cells.step();
  return (cells.count_at(0, 0) - cells.count_at(1, 0)) / before;
}

void record_stability(ExperimentContext& context) {
  for (const double migration : {0.1, 0.2, 0.21, 0.215, 0.22, 0.24}) {
    context.progress(fmt::format("stability, migration {}", migration));
    const std::string name = fmt::format("stability/gamma-{}", migration);
    context.record(name + "/spread", spread_of(context, migration, CellStep::positive_part),
                   "plants");
    context.record(name + "/checkerboard_factor", checkerboard_factor(0.3, migration));
  }
  for (const double migration : {0.22, 0.25, 0.9})
    context.record(fmt::format("stability/conserving/gamma-{}/spread", migration),
                   spread_of(context, migration, CellStep::conserving), "plants");
  for (const double fertility : {0.1, 0.3, 1.0, 1.8}) {
    double low = 0.0, high = 1.0;  // the factor falls with migration
    while (high - low > 1e-9) {
      const double middle = 0.5 * (low + high);
      (checkerboard_factor(fertility, middle) > -1.0 ? low : high) = middle;
    }
    context.record(fmt::format("stability/alpha-{}/largest_migration", fertility), low);
  }
}

/// One occupied cell, migration alone.
void record_spike(ExperimentContext& context) {
  for (const CellStep step : {CellStep::unclipped, CellStep::positive_part, CellStep::conserving}) {
    CellPopulation cells({5, 5}, {0.3, step, CellBorder::torus}, LogisticMap{});
    cells.counts()[12] = 1.0;
    cells.step();
    const std::string name = step == CellStep::positive_part
                                 ? "spike/positive-part"
                                 : "spike/" + std::string(name_of(step));
    context.record(name + "/centre", cells.count_at(2, 2), "plants");
    context.record(name + "/total", cells.total(), "plants");
  }
  context.record("operator-h/of_2", oracles::positive_part(2.0));
  context.record("operator-h/of_minus_1", oracles::positive_part(-1.0));
  context.record("operator-h/step_of_2", oracles::heaviside_step(2.0));
}

/// The largest count of each year, from a checkerboard of 0 and `size`.
std::vector<double> board_years(double size, double migration, CellStep step, int years) {
  CellPopulation cells({8, 8}, {migration, step, CellBorder::torus}, map_of());
  fill(cells, checkerboard(0.0, size));
  std::vector<double> largest{largest_of(cells)};
  for (int t = 0; t < years; ++t) {
    cells.step();
    largest.push_back(largest_of(cells));
  }
  return largest;
}

void record_divergence(ExperimentContext& context) {
  const std::vector<double> board = board_years(0.1, 0.3, CellStep::positive_part, 100);
  double off = 0.0;
  for (std::size_t t = 0; t < board.size(); ++t)
    off = std::max(off, std::abs(board[t] / (0.1 * std::pow(1.2, static_cast<double>(t))) - 1.0));
  context.record("divergence/gamma-0.3/largest_after_10_years", board[10], "plants");
  context.record("divergence/gamma-0.3/largest_after_100_years", board[100], "plants");
  context.record("divergence/gamma-0.3/off_from_power", off);
  for (const double migration : {0.26, 0.5, 0.9}) {
    const auto years = board_years(0.3, migration, CellStep::positive_part, 100);
    context.record(fmt::format("divergence/gamma-{}/yearly_factor", migration),
                   std::pow(years[100] / years[0], 0.01));
  }
  for (const double migration : {0.1, 0.2, 0.24}) {
    CellPopulation cells({16, 16}, {migration, CellStep::positive_part, CellBorder::torus},
                         map_of());
    fill(cells, random_field(context.seed(), 0.0, 100.0));
    run_years(cells, 2000);
    double largest = 0.0;
    for (int t = 0; t < 100; ++t) {
      cells.step();
      largest = std::max(largest, largest_of(cells));
    }
    context.record(fmt::format("bound/gamma-{}/share_of_bound", migration),
                   largest / count_bound(map_of(), migration));
  }
}

void draw_boards(ExperimentContext& context) {
  const auto curve = [](const char* name, double migration, CellStep step, PlotStyle style) {
    PlotCurve years{.name = name, .style = style};
    years.y = board_years(0.1, migration, step, 60);
    for (std::size_t t = 0; t < years.y.size(); ++t) years.x.push_back(static_cast<double>(t));
    return years;
  };
  const PlotPanel panel{
      .curves = {curve("(2.14), γ = 0.3", 0.3, CellStep::positive_part, PlotStyle::solid),
                 curve("(2.14), γ = 0.2", 0.2, CellStep::positive_part, PlotStyle::dashed),
                 curve("growth, then at most γ = 1/4", 0.3, CellStep::conserving,
                       PlotStyle::dotted)},
      .caption = "checkerboard of 0 and 0.1, α = 0.3, K = 1",
      .x_label = "years",
      .y_label = "largest count",
      .log_y = true};
  add_plot(
      context, "checkerboard",
      {.title = "Clipped cells grow without bound where γ exceeds 1/4",
       .description = "Largest count of a checkerboard over the years, on a logarithmic axis: "
                      "with γ = 0.3 it grows for ever, with γ = 0.2 and with at most a quarter "
                      "of the plants leaving per side it settles at 0.23, where (2.11) rests.",
       .panels = {panel}});
}

/// From one cell in the middle, 100 plants being the capacity of good land.
CellMapPanel landscape(const std::vector<LogisticMap>& habitats, int years, std::string caption) {
  constexpr CellGrid grid{51, 51};
  CellPopulation cells(grid, {0.2, CellStep::conserving, CellBorder::reflecting}, habitats);
  cells.counts()[grid.size() / 2] = 10.0;
  run_years(cells, years);
  return {grid, {cells.counts().begin(), cells.counts().end()}, std::move(caption)};
}

void draw_landscapes(ExperimentContext& context) {
  const std::vector<LogisticMap> good(51 * 51, LogisticMap::of_rate(1.3, 100.0));
  std::vector<LogisticMap> mixed = good;
  for (std::size_t i = 0; i < mixed.size(); ++i) {
    const auto x = static_cast<double>(i % 51), y = static_cast<double>(i / 51);
    if (std::abs(x - 14.0 - 5.0 * std::sin(0.15 * y)) < 3.0)
      mixed[i] = LogisticMap::of_rate(0.5, 100.0);
    if (x > 32.0) mixed[i] = LogisticMap::of_rate(1.3, 40.0);
  }
  context.artifact("spreading-cells.svg",
                   cell_map_svg({landscape(good, 20, "20 years"), landscape(good, 50, "50 years"),
                                 landscape(mixed, 90, "90 years, with a river and poor land")},
                                24.0, "A population that spreads from one cell"));
}

void run(ExperimentContext& context) {
  record_operator(context);
  record_agreement(context);
  record_uniform(context);
  record_conservation(context);
  record_stability(context);
  record_spike(context);
  record_divergence(context);
  draw_boards(context);
  draw_landscapes(context);
}

}  // namespace

extern const ExperimentDescriptor migration;
constinit const ExperimentDescriptor migration{
    .id = "alsweis/migration",
    .question = "For which migration do cells with logistic growth settle, and who is created?",
    .source = "[Alsweis] (2.12) to (2.14)",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
