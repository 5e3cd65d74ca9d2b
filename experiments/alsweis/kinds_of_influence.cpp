// SPDX-License-Identifier: MIT
// Neighbours that harm, help or do nothing, above and below ground: table 5.1, and what is left of
// growth.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/competition/competition_parameters.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/few_plants.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_stand.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::array all_influences = {Influence::harms, Influence::none, Influence::helps};

CompetitionParameters with_signs(double p, Influence above, Influence below) {
  CompetitionParameters parameters = with_share(p);
  parameters.influence_above = {above};
  parameters.influence_below = {below};
  return parameters;
}

/// Of table 5.1.
char letter_of_loss(double loss) {
  return loss > 0.0 ? 'N' : loss < 0.0 ? 'P' : 'T';
}

/// The small plant of a pair of which roots only, crowns only, or both meet.
double loss_where(bool roots_meet, bool crowns_meet, const CompetitionParameters& parameters) {
  FewPlants plants;
  plants.add(0.0, roots_meet ? 2.0 : 0.4, crowns_meet ? 2.0 : 0.4);
  plants.add(3.0, roots_meet ? 3.0 : 0.5, crowns_meet ? 2.5 : 0.5);
  return plants.losses("influence_signs", parameters)[0];
}

std::string lower_case(std::string text) {
  for (char& c : text) c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
  return text;
}

/// Every cell by what is measured below and above ground; and how many differ where both meet.
void record_table(ExperimentContext& context) {
  const char letter[] = {'P', 'T', 'N'};
  std::set<double> losses;
  std::set<std::string> cells;
  for (const Influence below : all_influences)
    for (const Influence above : all_influences) {
      const CompetitionParameters parameters = with_signs(0.4, above, below);
      const std::string cell = {letter[static_cast<int>(below) + 1],
                                letter[static_cast<int>(above) + 1]};
      const std::string measured = {letter_of_loss(loss_where(true, false, parameters)),
                                    letter_of_loss(loss_where(false, true, parameters))};
      const double both = loss_where(true, true, parameters);
      context.record("table-5.1/" + lower_case(cell) + "/influence", measured);
      context.record("table-5.1/" + lower_case(cell) + "/loss", both);
      losses.insert(both);
      cells.insert(measured);
    }
  context.record("table-5.1/different_influences", static_cast<std::int64_t>(cells.size()),
                 "states");
  context.record("table-5.1/different_losses", static_cast<std::int64_t>(losses.size()), "states");
}

/// One species helps another, or both leave each other alone.
void record_one_sided(ExperimentContext& context) {
  FewPlants plants;
  plants.add(0.0, 2.0, 2.0, 0);
  plants.add(1.0, 1.0, 1.0, 1);
  CompetitionParameters parameters = with_share(0.5);
  parameters.species.resize(2);
  parameters.influence_above.assign(4, Influence::none);
  parameters.influence_below.assign(4, Influence::none);
  const auto apart = plants.losses("influence_signs", parameters);
  context.record("one_sided/indifferent/first", apart[0]);
  context.record("one_sided/indifferent/second", apart[1]);
  parameters.influence_below[2] = Influence::helps;  // of the first on the second
  const auto helped = plants.losses("influence_signs", parameters);
  context.record("one_sided/helper/loss", helped[0]);
  context.record("one_sided/helped/loss", helped[1]);
}

/// What becomes of a seedling beside a tree while both grow: their roots meet before their crowns.
std::string course_of_influence(Influence above, Influence below) {
  PopulationParameters parameters;
  parameters.ground = {{0, 0}, {100, 100}};
  parameters.is_torus = false;
  parameters.rule = "influence_signs";
  parameters.species.resize(2);
  for (Species& species : parameters.species) species.roots = {15, 15, 0.5};
  for (Species& species : parameters.species) species.crown = {10, 10, 0.5};
  parameters.species[0].name = "tree";
  parameters.species[1].name = "seedling";
  parameters.species[1].largest_radius = 0.1;
  parameters.species[1].growth_rate = 0.01;
  parameters.competition.influence_above.assign(4, Influence::none);
  parameters.competition.influence_below.assign(4, Influence::none);
  parameters.competition.influence_above[2] = above;  // of the tree on the seedling
  parameters.competition.influence_below[2] = below;
  const std::array start{StartPlant{{50, 50}, 0.05, 0}, StartPlant{{54.5, 50}, 0.005, 1}};
  Population population(parameters, sow(parameters, start), overlap_engine_named("all_pairs"));
  std::string course;
  for (int t = 0; t < 80; ++t) {
    const std::size_t seedling = population.stand().species[0] == 1 ? 0 : 1;
    const double loss = population.losses()[seedling];
    const char* now = loss > 0 ? "harmed" : loss < 0 ? "helped" : "";
    if (*now != '\0' && !course.ends_with(now))
      course += (course.empty() ? "" : ", then ") + std::string(now);
    population.step();
  }
  return course.empty() ? "none" : course;
}

void record_courses(ExperimentContext& context) {
  const char letter[] = {'p', 't', 'n'};
  for (const Influence below : all_influences)
    for (const Influence above : all_influences)
      context.record(fmt::format("courses/{}{}", letter[static_cast<int>(below) + 1],
                                 letter[static_cast<int>(above) + 1]),
                     course_of_influence(above, below));
}

/// (5.5) and (5.6) for random pairs: both terms apart and mixed.
void record_mixtures(ExperimentContext& context) {
  CounterStream stream(context.seed(), 0);
  double outside = 0.0, of_harm = 0.0, of_all = 0.0, of_none = 0.0;
  for (int i = 0; i < 2'000; ++i) {
    FewPlants plants;
    plants.add(0.0, stream.next_between(0.5, 2), stream.next_between(0.5, 2));
    plants.add(stream.next_unit(), stream.next_between(0.5, 2), stream.next_between(0.5, 2));
    const double p = stream.next_unit();
    const double alpha = plants.losses("above_below", with_share(1))[0],
                 sigma = plants.losses("above_below", with_share(0))[0],
                 phi = plants.losses("above_below", with_share(p))[0];
    outside = std::max({outside, std::min(alpha, sigma) - phi, phi - std::max(alpha, sigma)});
    for (const Influence above : all_influences)
      for (const Influence below : all_influences) {
        const double s1 = static_cast<double>(above), s2 = static_cast<double>(below);
        const double own = plants.losses("influence_signs", with_signs(p, above, below))[0];
        of_all = std::max(of_all, std::abs(own - (s1 * p * alpha + s2 * (1 - p) * sigma)));
        if (s1 == 1 && s2 == 1) of_harm = std::max(of_harm, std::abs(own - phi));
        if (s1 == 0 && s2 == 0) of_none = std::max(of_none, std::abs(own));
      }
  }
  context.record("mixture/largest_step_outside", outside);
  context.record("signs/all_harm/largest_difference", of_harm);
  context.record("signs/none/largest_loss", of_none);
  context.record("signs/largest_difference_from_print", of_all);
}

/// What is left of growth (5.7).
void record_factor(ExperimentContext& context) {
  for (const auto& [name, loss] : {std::pair{"000", 0.0}, std::pair{"025", 0.25},
                                   std::pair{"050", 0.5}, std::pair{"075", 0.75}})
    context.record(fmt::format("factor/loss-{}", name), growth_factor(loss));
  context.record("factor/jump_at_half",
                 growth_factor(std::nextafter(0.5, 0)) - growth_factor(std::nextafter(0.5, 1)));
  context.record("factor/unit_circles",
                 growth_factor(two_plants_apart(1, 1, 1).losses("above_below", with_share(0))[0]));
  for (const auto& [name, above] :
       {std::pair{"harmed", Influence::harms}, std::pair{"unaffected", Influence::none},
        std::pair{"helped", Influence::helps}})
    context.record(
        fmt::format("factor/by_crown/{}", name),
        growth_factor(loss_where(false, true, with_signs(0.4, above, Influence::harms))));
}

/// A seedling that one larger plant covers altogether.
void record_covered(ExperimentContext& context) {
  const FewPlants covered = two_plants_apart(0, 1, 3);
  for (const int percent : {0, 25, 50, 100}) {
    const double loss = covered.losses("above_below", with_share(percent / 100.0))[0];
    context.record(fmt::format("covered/p-{:03}/loss", percent), loss);
    context.record(fmt::format("covered/p-{:03}/factor", percent), growth_factor(loss));
  }
  for (const std::size_t nurses : {1u, 2u, 4u}) {
    FewPlants plants;
    plants.add(0.0, 1.0, 1.0);
    for (std::size_t i = 0; i < nurses; ++i)
      plants.add(0.0, 3.0 + 0.1 * static_cast<double>(i), 0.5);
    context.record(fmt::format("nurses-{}/factor", nurses),
                   growth_factor(plants.losses(
                       "influence_signs", with_signs(0, Influence::none, Influence::helps))[0]));
  }
}

/// The largest size that a plant reaches which grows too fast for its steps: (5.9) as printed, and
/// in the suite.
void record_overshoot(ExperimentContext& context) {
  namespace print = phytobench::oracles::alsweis::competition;
  std::vector<print::LiteralPlant> plants{{0, 0, 0.05}};
  for (int i = 0; i < 4; ++i) plants.push_back({0, 0, 0.5});
  print::LiteralStand stand(
      {.species = {{.MGR = 0.2}}, .zones = print::Zones::two, .p = 0.0, .s2 = {-1}}, plants);
  PopulationParameters parameters;
  parameters.ground = {{0, 0}, {100, 100}};
  parameters.is_torus = false;
  parameters.rule = "influence_signs";
  parameters.species.resize(1);
  parameters.species[0].name = "plant";
  parameters.species[0].growth_rate = 0.2;
  parameters.competition = with_signs(0.0, Influence::harms, Influence::helps);
  std::vector<StartPlant> start;
  for (const auto& plant : plants) start.push_back({{50, 50}, plant.R, 0});
  Population population(parameters, sow(parameters, start), overlap_engine_named("all_pairs"));
  double printed = 0.0, suite = 0.0;
  for (int t = 0; t < 30; ++t) {
    stand.step();
    population.step();
    printed = std::max(printed, stand.plants()[0].R / 0.5);
    for (const double radius : population.stand().stem_radius)
      suite = std::max(suite, radius / 0.5);
  }
  context.record("nurses-4/printed/largest_size", printed, "largest sizes");
  context.record("nurses-4/suite/largest_size", suite, "largest sizes");
}

/// What the roots and the crown of a tree cost a shrub that they cover, at p = 1/2, by ring; and
/// the share above ground at which both are equal.
void record_cause(ExperimentContext& context) {
  for (int F = 1; F <= 5; ++F) {
    FewPlants plants;
    plants.add(F - 0.5 + 0.2, 0.2, 0.2);
    plants.add(0.0, 8.0, 5.0);
    const double roots = plants.losses("above_below", with_share(0))[0],
                 crown = plants.losses("above_below", with_share(1))[0];
    context.record(fmt::format("cause/ring-{}/roots", F), 0.5 * roots);
    context.record(fmt::format("cause/ring-{}/crown", F), 0.5 * crown);
    context.record(fmt::format("cause/ring-{}/equal_at", F), roots / (roots + crown));
  }
  // On average over the ground that the tree's roots reach, zones as 12 to 10.
  double roots = 0.0, crown = 0.0, ground = 0.0;
  for (int i = 0; i < 2'000; ++i) {
    const double distance = 6.0 * (i + 0.5) / 2'000;
    FewPlants plants;
    plants.add(0.0, 0.2, 0.15);
    plants.add(distance, 6.0, 5.0);
    roots += distance * 0.5 * plants.losses("above_below", with_share(0))[0];
    crown += distance * 0.5 * plants.losses("above_below", with_share(1))[0];
    ground += distance;
  }
  context.record("cause/mean/roots", roots / ground);
  context.record("cause/mean/crown", crown / ground);
}

void run(ExperimentContext& context) {
  record_table(context);
  record_one_sided(context);
  record_courses(context);
  record_mixtures(context);
  record_factor(context);
  record_covered(context);
  record_overshoot(context);
  record_cause(context);
}

}  // namespace

extern const ExperimentDescriptor kinds_of_influence;
constinit const ExperimentDescriptor kinds_of_influence{
    .id = "alsweis/kinds-of-influence",
    .question = "What do neighbours do to a plant that harm, help or leave it alone?",
    .source = "[Alsweis] sec. 5.3, eq. 5.5-5.7, table 5.1",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
