// SPDX-License-Identifier: MIT
#include "core/population/population_keys.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/competition/competition_ranges.hpp"

namespace phytobench {

namespace {

namespace ranges = competition_ranges;
using population_key::choice;
using population_key::number;
using Keys = std::vector<PopulationKey>;
using Values = PopulationFileValues;

/// Above it not every whole number is a double.
constexpr double largest_seed = 9007199254740991;

Keys run_and_ground_keys() {
  return {
      {"seed", "-", "0", "start of every random number", "phytobench",
       number(
           {.high = largest_seed}, [](auto& v) -> auto& { return v.parameters.seed; }),
       false, false, true},
      {"steps", "steps", "60", "how long the stand is followed", "[Alsweis] sec. 4.7",
       number(
           {.high = 1e6}, [](auto& v) -> auto& { return v.parameters.steps; })},
      {"plants", "-", "\"\"",
       "CSV file of plants to start with, columns x, y, radius and, with more than one species, "
       "species; besides those that species.count sows",
       "phytobench", PopulationFileName{[](Values & v) -> auto& {return v.plants;
}
}  // namespace
}  // namespace phytobench
,
    {"ground.size",
     "m",
     "[200.0, 200.0]",
     "width and height of the ground",
     "[Alsweis] sec. 4.7",
     PopulationPair{ground_side, [](const Values& v) { return v.ground_size; },
                    [](Values& v, const Point2& p) { v.ground_size = p; }},
     false,
     false,
     true},
    {"ground.corner",
     "m",
     "[0.0, 0.0]",
     "its lower left corner: smallest x, smallest y",
     "phytobench",
     PopulationPair{ground_corner, [](const Values& v) { return v.ground_corner; },
                    [](Values& v, const Point2& p) { v.ground_corner = p; }},
     false,
     false,
     true},
    {"ground.torus", "-", "true",
     "whether opposite sides are joined; if not, plants at the border lack neighbours and seeds "
     "beyond it are lost",
     "phytobench", PopulationSwitch{[](Values & v) -> auto& {return v.parameters.is_torus;
}
}
}
, {"resources.nutrients", "-", "\"\"",
   "PNG over the whole ground that sets root zones: black is poor, white is rich; without one "
   "all of it is rich",
   "[Alsweis] fig. 4.6", PopulationFileName{[](Values & v) -> auto& {return v.nutrients;
}
}
}
, {"resources.light", "-", "\"\"", "the same for crown zones", "[Alsweis] sec. 5.5 E",
   PopulationFileName{[](Values & v) -> auto& {return v.light;
}
}
}
,
}
;
}

Keys competition_keys() {
  return {{"competition.rule", "-", "\"mixture\"", "what neighbours cost a plant",
           "phytobench list rules",
           PopulationText{"a name of phytobench list rules",
                          [](Values & v) -> auto& {return v.parameters.rule;
}
}
}
,
    {"competition.above_share",
     "share",
     "0.5",
     "share p of asymmetric competition, or of that above ground where a rule tells the two apart",
     "[Alsweis] (4.4), (5.5)",
     number(
         ranges::above_share,
         [](auto& v) -> auto& { return v.parameters.competition.above_share; })},
    {"competition.asymmetry_exponent",
     "-",
     "1.0",
     "exponent a: a plant's share of common ground is its area^a over the sum of both, and inf "
     "leaves all to the larger; for rules asymmetry_exponent and exact_shares",
     "influence functions of siplab",
     number(
         ranges::asymmetry_exponent,
         [](auto& v) -> auto& { return v.parameters.competition.asymmetry_exponent; })},
    {"competition.ties",
     "-",
     "\"share\"",
     "who wins where two zones are equally large",
     "[Alsweis] (4.3) leaves it open",
     choice(
         {"share", "lower-id-wins"},
         [](auto& v) -> auto& { return v.parameters.competition.ties; })},
    {"competition.light_constant",
     "-",
     "1.0",
     "weight k of light competition in the innermost ring of a crown; for rules light and combined",
     "[Alsweis] (7.1)",
     number(
         ranges::light_constant,
         [](auto& v) -> auto& { return v.parameters.competition.light_constant; })},
    {"competition.field_at_rim",
     "share",
     "0.1",
     "what is left of a plant's field at the rim of its zone, F_min; for rule "
     "field_of_neighbourhood",
     "Berger and Hildenbrandt 2000",
     number(
         ranges::field_at_rim,
         [](auto& v) -> auto& { return v.parameters.competition.field_at_rim; })},
}
;
}

Keys fate_keys() {
  return {
      {"mortality.rule", "-", "\"none\"",
       "what a plant dies of: its mean growth, growth per size or size over the window is below "
       "the threshold",
       "[Alsweis] sec. 4.5, (4.8): size as printed, growth as in the work it cites",
       choice(
           {"none", "mean-growth", "mean-relative-growth", "mean-size"},
           [](auto& v) -> auto& { return v.parameters.mortality.rule; })},
      {"mortality.window", "steps", "5", "steps n to take the mean over; younger plants live",
       "[Alsweis] (4.8)",
       number(
           {.low = 1, .high = 100},
           [](auto& v) -> auto& { return v.parameters.mortality.window; })},
      {"mortality.threshold", "m per step, 1 per step, or m", "0.0",
       "stem radius per step for mean-growth, its share per step for mean-relative-growth, stem "
       "radius for mean-size",
       "[Alsweis] sec. 4.5",
       number(
           {.high = 1000}, [](auto& v) -> auto& { return v.parameters.mortality.threshold; })},
      {"mortality.grown_up", "share", "0.95",
       "plants beyond this share of their largest radius do not die of slow growth; 1 spares none",
       "phytobench",
       number(
           {.high = 1}, [](auto& v) -> auto& { return v.parameters.mortality.grown_up; })},
      {"illness.duration", "steps", "40",
       "time in which an ill plant's influence below ground falls from full to none",
       "[Alsweis] (7.4), corrected",
       number(
           {.low = 1, .high = 1e6},
           [](auto& v) -> auto& { return v.parameters.illness.duration; })},
      {"illness.is_deadly", "-", "false", "whether it dies then", "phytobench",
       PopulationSwitch{[](Values & v) -> auto& {return v.parameters.illness.is_deadly;
}
}
}
,
    {"seasons.bad_year_share",
     "share",
     "0.0",
     "share of steps, drawn at random, in which no seed becomes a plant",
     "[Alsweis] sec. 4.6",
     number(
         {.high = 1}, [](auto& v) -> auto& { return v.parameters.bad_year_share; })},
}
;
}

}  // namespace

std::span<const PopulationKey> population_keys() {
  static const Keys keys = [] {
    Keys all = run_and_ground_keys();
    for (const Keys& more :
         {competition_keys(), fate_keys(), species_keys(), influence_and_event_keys()})
      all.insert(all.end(), more.begin(), more.end());
    return all;
  }();
  return keys;
}

bool is_list_of_population(std::string_view section) {
  return section == "species" || section == "influence" || section == "event";
}

std::string allowed_values(const PopulationKey& key) {
  return std::visit(
      Overloaded{
          [](const PopulationNumber& kind) { return "a number " + allowed(kind.range); },
          [](const PopulationPair& kind) { return "two numbers " + allowed(kind.range); },
          [](const PopulationChoice& kind) {
            return fmt::format("\"{}\"", fmt::join(kind.words, "\" or \""));
          },
          [](const PopulationSwitch&) { return std::string("true or false"); },
          [](const PopulationText& kind) { return std::string(kind.allowed); },
          [](const PopulationFileName&) { return std::string("a file name, \"\" for none"); },
          [](const PopulationIds&) { return std::string("whole numbers, as in [0, 7]"); }},
      key.kind);
}

PopulationFileValues file_values_of(const PopulationParameters& parameters) {
  PopulationFileValues values;
  values.parameters = parameters;
  const Rectangle& ground = parameters.ground;
  values.ground_size = {ground.width(), ground.height()};
  values.ground_corner = ground.low;
  return values;
}

}  // namespace phytobench
