// SPDX-License-Identifier: MIT
// Plants with and without a seed bank, one by one in space, under mixed competition: who is left
// after a hundred years of which some are bad. A counterpart of [Alsweis] 4.6, whose maps know no
// places, for its fig. 4.10, whose parameters are unpublished.
#include <algorithm>
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/alsweis/paired_runs.hpp"
#include "experiments/alsweis/stand_panels.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t years = 100;
constexpr std::array bad_year_shares = {0.0, 0.1, 0.2, 0.3, 0.4, 0.5};
constexpr SpeciesIndex banker = 0, non_banker = 1;

/// Short-lived plants: from a seedling of 2 cm they bear about eight seeds each year if nobody is
/// near, in two years, then die. Both kinds differ in nothing but the share of seeds that rests.
Species kind_of(const char* name, std::int64_t count, double dormant_share) {
  return {.name = name,
          .count = count,
          .start_radius_low = 0.018,
          .start_radius_high = 0.022,
          .largest_radius = 0.05,
          .growth_rate = 0.05,
          .roots = {.poor_factor = 5.0, .rich_factor = 5.0},
          .largest_age = 3,
          .reproduction = {.threshold = 0.022,
                           .seeds_per_metre = 800.0,
                           .dispersal_distance = 3.0,
                           .seed_mortality = 0.1,
                           .dormant_share = dormant_share,
                           .germination_rate = 0.3,
                           .establishment = 0.5,
                           .seedling_radius = 0.02}};
}

struct Sown {
  std::int64_t bankers, non_bankers;
};

PopulationParameters stand_of(const Sown& sown, double bad_years, std::uint64_t seed) {
  PopulationParameters parameters;
  parameters.seed = seed;
  parameters.rule = "mixture";
  parameters.ground = {{0.0, 0.0}, {20.0, 20.0}};
  parameters.species = {kind_of("with seed bank", sown.bankers, 0.4),
                        kind_of("without seed bank", sown.non_bankers, 0.0)};
  parameters.bad_year_share = bad_years;
  return parameters;
}

/// Numbers of one year.
struct Year {
  std::array<double, 2> plants{};
  double resting = 0.0;

  bool has(SpeciesIndex kind) const {
    return plants[kind] > 0.0 || (kind == banker && resting > 0.0);
  }
};

Year year_of(const Population& population) {
  Year year{.resting = static_cast<double>(population.state().seeds.size())};
  for (const SpeciesIndex kind : population.stand().species) year.plants[kind] += 1.0;
  return year;
}

/// From the start on, one entry more than there are years.
std::vector<Year> course_of(const PopulationParameters& parameters) {
  Population population = population_of(parameters);
  std::vector<Year> course = {year_of(population)};
  for (std::size_t t = 0; t < years; ++t) {
    population.step();
    course.push_back(year_of(population));
  }
  return course;
}

double years_with(const std::vector<Year>& course, SpeciesIndex kind) {
  const auto gone = std::find_if(course.begin() + 1, course.end(),
                                 [&](const Year& year) { return !year.has(kind); });
  return static_cast<double>(gone - course.begin() - 1);
}

std::size_t runs_of(Tier tier) {
  return tier == Tier::full ? 100 : tier == Tier::quick ? 20 : 6;
}

/// In how many runs either kind is left, and how many years more the banking one has.
struct Persistence {
  std::vector<double> banker_years, non_banker_years;

  static double share_left(const std::vector<double>& some) {
    return static_cast<double>(std::count(some.begin(), some.end(), static_cast<double>(years))) /
           static_cast<double>(some.size());
  }
};

void record_persistence(ExperimentContext& context, const std::string& group,
                        const Persistence& persistence) {
  const auto size = static_cast<std::int64_t>(persistence.banker_years.size());
  const auto record = [&](const char* name, const std::vector<double>& some) {
    context.record({.experiment = {},
                    .measurement = group + name,
                    .value = Persistence::share_left(some),
                    .sample_size = size,
                    .seed = context.seed()});
  };
  record("/banker_persists", persistence.banker_years);
  record("/non_banker_persists", persistence.non_banker_years);
  record_paired(context, group + "/banker_over_non_banker", persistence.banker_years,
                persistence.non_banker_years, "years");
}

/// Each kind in a stand of its own, with the same bad years.
Persistence alone(ExperimentContext& context, double bad_years) {
  const std::size_t runs = runs_of(context.tier());
  Persistence result{std::vector<double>(runs), std::vector<double>(runs)};
  for_runs(context, fmt::format("bad years {}, alone", bad_years), runs, [&](std::size_t s) {
    const std::uint64_t seed = seed_of_run(context, Question::seed_bank, s);
    result.banker_years[s] = years_with(course_of(stand_of({120, 0}, bad_years, seed)), banker);
    result.non_banker_years[s] =
        years_with(course_of(stand_of({0, 120}, bad_years, seed)), non_banker);
  });
  return result;
}

/// Both kinds in one stand.
Persistence together(ExperimentContext& context, double bad_years) {
  const std::size_t runs = runs_of(context.tier());
  Persistence result{std::vector<double>(runs), std::vector<double>(runs)};
  for_runs(context, fmt::format("bad years {}, together", bad_years), runs, [&](std::size_t s) {
    const auto course =
        course_of(stand_of({60, 60}, bad_years, seed_of_run(context, Question::seed_bank, s)));
    result.banker_years[s] = years_with(course, banker);
    result.non_banker_years[s] = years_with(course, non_banker);
  });
  return result;
}

struct PersistenceCurves {
  PlotCurve bankers{.name = "with seed bank", .x = {}, .y = {}, .colour = 0};
  PlotCurve others{.name = "without seed bank", .x = {}, .y = {}, .colour = 1};

  void add(double bad_years, const Persistence& persistence) {
    bankers.x.push_back(bad_years);
    bankers.y.push_back(Persistence::share_left(persistence.banker_years));
    others.x.push_back(bad_years);
    others.y.push_back(Persistence::share_left(persistence.non_banker_years));
  }

  PlotPanel panel(const char* caption) const {
    return {.curves = {bankers, others},
            .caption = caption,
            .x_label = "share of bad years",
            .y_label = "share of runs",
            .y_range = AxisRange{0.0, 1.0}};
  }
};

PlotPanel course_panel(ExperimentContext& context) {
  const auto course =
      course_of(stand_of({60, 60}, 0.2, seed_of_run(context, Question::seed_bank, 0)));
  PlotCurve bankers{.name = "plants with seed bank", .colour = 0},
      others{.name = "plants without seed bank", .colour = 1},
      resting{.name = "resting seeds", .style = PlotStyle::dotted, .colour = 2};
  for (std::size_t t = 0; t < course.size(); ++t) {
    for (PlotCurve* curve : {&bankers, &others, &resting})
      curve->x.push_back(static_cast<double>(t));
    bankers.y.push_back(course[t].plants[banker]);
    others.y.push_back(course[t].plants[non_banker]);
    resting.y.push_back(course[t].resting);
  }
  return {.curves = {bankers, others, resting},
          .caption = "together, one year of five is bad",
          .x_label = "years",
          .y_label = "number on 400 m²"};
}

/// Figure 4.10: one stand at three moments.
void draw_stand(ExperimentContext& context) {
  Population population =
      population_of(stand_of({60, 60}, 0.2, seed_of_run(context, Question::seed_bank, 0)));
  std::vector<StandPanel> panels;
  for (const int moment : {0, 10, 40}) {
    while (population.state().step < moment) population.step();
    StandLayer resting{.name = "resting seed", .places = {}, .radii = {}};
    for (const DormantSeed& seed : population.state().seeds) {
      resting.places.push_back(seed.place);
      resting.radii.push_back(0.0);
    }
    panels.push_back({.layers = {resting, stems_of(population, banker, 6.0),
                                 stems_of(population, non_banker, 6.0)},
                      .caption = fmt::format("year {}", moment)});
  }
  context.artifact("figure-4.10.svg",
                   stand_panels_svg({.ground = population.parameters().ground, .is_torus = true},
                                    panels, "Figure 4.10: plants with and without a seed bank"));
}

void run(ExperimentContext& context) {
  PersistenceCurves apart, mixed;
  for (const double bad_years : bad_year_shares) {
    const Persistence own = alone(context, bad_years), both = together(context, bad_years);
    record_persistence(context, fmt::format("alone/bad-{}", bad_years), own);
    record_persistence(context, fmt::format("together/bad-{}", bad_years), both);
    apart.add(bad_years, own);
    mixed.add(bad_years, both);
  }
  add_plot(
      context, "seed-bank-course",
      {.title = "A hundred years of plants with and without a seed bank",
       .description = "Plants of both kinds on one stand, and the seeds that rest in its soil, "
                      "over the years; one year of five is bad.",
       .panels = {course_panel(context)}});
  add_plot(context, "seed-bank-persistence",
           {.title = "Who is left of plants with and without a seed bank",
            .description = "Share of runs in which a kind still lives after a hundred years, over "
                           "the share of bad years, for both kinds together and each alone.",
            .panels = {mixed.panel("together"), apart.panel("each kind alone")}});
  draw_stand(context);
}

}  // namespace

extern const ExperimentDescriptor seed_bank_stand;
constinit const ExperimentDescriptor seed_bank_stand{
    .id = "alsweis/seed-bank-stand",
    .question = "Does a seed bank save plants that compete one by one from bad years?",
    .source = "[Alsweis] sec. 4.6, 4.7, figure 4.10",
    .seconds = {1, 4, 20},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
