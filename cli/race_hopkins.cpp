// SPDX-License-Identifier: MIT
#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/point_pattern/hopkins_race.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/race_document.hpp"
#include "cli/race_numbers.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/point_pattern/cluster_patterns.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/order_statistics.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

constexpr Rectangle plot{{0.0, 0.0}, {1.0, 1.0}};

std::vector<Point2> chosen_points(const HopkinsRaceOptions& options) {
  const Window window = Window::rectangle(plot);
  CounterStream stream(options.seed, 99);
  const auto count = static_cast<std::size_t>(std::llround(options.size));
  if (options.pattern == "random") return uniform_points(window, count, stream);
  if (options.pattern != "clustered")
    throw InputError("unknown pattern '" + options.pattern + "'; use random or clustered");
  // A hundred points in each cluster, clusters a tenth as wide as they are apart.
  ThomasOptions thomas;
  thomas.numbers = {.parents = std::max(1.0, options.size / 100.0), .offspring = 100.0};
  thomas.sigma = 0.1 / std::sqrt(thomas.numbers.parents);
  std::vector<Point2> points = thomas_points(window, thomas, stream);
  while (points.size() < 2) points.push_back(window.random_point(stream));
  return points;
}

const HopkinsWay* fastest_of(const std::vector<HopkinsWay>& ways) {
  const HopkinsWay* fastest = nullptr;
  for (const HopkinsWay& way : ways)
    if (!way.seconds.empty() &&
        (fastest == nullptr || median(way.seconds) < median(fastest->seconds)))
      fastest = &way;
  return fastest;
}

ordered_json document(const std::vector<HopkinsWay>& ways, std::size_t points,
                      const HopkinsRaceOptions& options) {
  ordered_json json = race_document({{"name", options.pattern + " points in a square"},
                                     {"points", points},
                                     {"sampled_places", points},
                                     {"seed", options.seed}});
  const HopkinsWay* const fastest = fastest_of(ways);
  for (const HopkinsWay& way : ways) {
    ordered_json entry{{"name", way.name},
                       {"built", way.missing.empty()},
                       {"exact", way.missing.empty() ? ordered_json(way.objection.empty())
                                                     : ordered_json(nullptr)},
                       {"median_s", nullptr},
                       {"ci95_s", nullptr}};
    if (!way.objection.empty()) entry["disagreement"] = way.objection;
    if (!way.missing.empty()) entry["missing_package"] = way.missing;
    if (!way.seconds.empty()) {
      put_seconds(entry, median_of_rounds(way.seconds));
      entry["mean_ratio"] = way.index.mean_ratio;
    }
    json["engines"].push_back(entry);
    if (way.seconds.empty() || &way == fastest) continue;
    json["ratios"].push_back(
        ratio_json(way.name, fastest->name, ratio_of_rounds(way.seconds, fastest->seconds)));
  }
  put_environment(json, options.command_line, options.seed, std::array{options.threads});
  return json;
}

std::string table(const std::vector<HopkinsWay>& ways, std::size_t points,
                  const HopkinsRaceOptions& options) {
  const HopkinsWay* const fastest = fastest_of(ways);
  const EndsInWords ends = ends_in_words(fastest ? fastest->seconds.size() : 0);
  std::string text = fmt::format(
      "{} {} points in a square; sampled ways ask at as many random places\n\n{:<22} "
      "{:>10} {:>10}  {:>10} - {:>10}  {:>8} {}\n",
      points, options.pattern, "Hopkins index", "value", "median", ends.from, "to", "fastest",
      ends.ratio);
  for (const HopkinsWay& way : ways) {
    if (!way.missing.empty()) {
      text += fmt::format("{:<22} not built: {} was not found\n", way.name, way.missing);
      continue;
    }
    if (!way.objection.empty()) {
      text += fmt::format("{:<22} WRONG, no time: {}\n", way.name, way.objection);
      continue;
    }
    const MedianOfRounds s = median_of_rounds(way.seconds);
    const MedianOfRounds ratio = ratio_of_rounds(way.seconds, fastest->seconds);
    text += fmt::format("{:<22} {:>10.6f} {:>10}  {:>10} - {:>10}  {:>7.2f}x [{:.2f}, {:.2f}]\n",
                        way.name, way.index.mean_ratio, with_unit(s.value), with_unit(s.low),
                        with_unit(s.high), ratio.value, ratio.low, ratio.high);
  }
  return text + ends.note;
}

}  // namespace

int race_hopkins(const HopkinsRaceOptions& options) {
  keep_freed_memory();
  const std::vector<Point2> points = chosen_points(options);
  catch_interrupts();
  const auto ways = phytobench::race_hopkins({.points = points,
                                              .window = plot,
                                              .threads = options.threads,
                                              .rounds = options.rounds,
                                              .seed = options.seed,
                                              .show_progress = show_progress,
                                              .is_interrupted = is_interrupted});
  print(options.json ? document(ways, points.size(), options).dump(2) + "\n"
                     : table(ways, points.size(), options));
  return std::any_of(ways.begin(), ways.end(),
                     [](const HopkinsWay& way) { return !way.objection.empty(); })
             ? 1
             : 0;
}

}  // namespace phytobench::cli
