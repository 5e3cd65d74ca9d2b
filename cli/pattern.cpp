// SPDX-License-Identifier: MIT
// phytobench pattern: options and files in, words and numbers out.
#include <algorithm>
#include <cmath>
#include <limits>

#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/pattern_output.hpp"
#include "cli/terminal.hpp"
#include "core/contract/csv_file.hpp"
#include "core/contract/errors.hpp"
#include "core/point_pattern/null_models.hpp"
#include "core/point_pattern/point_grid.hpp"
#include "core/point_pattern/random_patterns.hpp"
#include "core/random/counter_stream.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

namespace phytobench::cli {

namespace {

/// Simulations of different questions draw from different seeds.
enum SeedOffset : std::uint64_t {
  sampling = 1'000'003,
  second_order = 2'000'003,
  labels = 3'000'003
};

/// Envelopes take this many simulated curves, and at most this much work.
constexpr std::size_t most_curves = 199, most_curve_points = 20'000;
constexpr double curve_points_in_all = 4e5;

void checkpoint() {
  if (is_interrupted()) throw Interrupted("nothing was written");
}

void step(const std::string& what) {
  checkpoint();
  show_progress(what);
}

Rectangle bounding_box(const std::vector<Point2>& points) {
  Rectangle box{points[0], points[0]};
  for (const Point2& p : points) {
    box.low = {std::min(box.low.x, p.x), std::min(box.low.y, p.y)};
    box.high = {std::max(box.high.x, p.x), std::max(box.high.y, p.y)};
  }
  return box;
}

std::vector<Point2> joined(const std::vector<std::vector<double>>& columns) {
  std::vector<Point2> points;
  points.reserve(columns[0].size());
  for (std::size_t i = 0; i < columns[0].size(); ++i)
    points.push_back({columns[0][i], columns[1][i]});
  return points;
}

Window chosen_window(const PatternOptions& options, const std::vector<Point2>& points) {
  if (!options.window.empty() && !options.polygon.empty())
    throw InputError("give --window or --polygon, not both");
  if (!options.polygon.empty()) {
    if (options.torus) throw InputError("a polygon has no opposite sides; leave out --torus");
    try {
      const Window polygon =
          Window::polygon(joined(read_number_columns(options.polygon, {"x", "y"})));
      refuse_odd_size(polygon.bounding_box(), options.polygon);
      return polygon;
    } catch (const InputError& error) {
      const std::string what = error.what();
      const bool says_where = what.starts_with(options.polygon);
      throw InputError(says_where ? what : options.polygon + ": " + what);
    }
  }
  if (options.window.empty()) {
    if (options.torus)
      throw InputError("--torus needs --window x0,y0,x1,y1: the sides that are joined");
    const Rectangle box = bounding_box(points);
    if (!(box.width() > 0.0) || !(box.height() > 0.0))
      throw InputError(options.points +
                       ": all points are at one place or in a line along an axis; give --window");
    refuse_odd_size(box, options.points);
    return Window::rectangle(box);
  }
  const Rectangle window = rectangle_from(options.window, "--window");
  return options.torus ? Window::torus(window) : Window::rectangle(window);
}

void refuse_points_outside(const PatternOptions& options, const std::vector<Point2>& points,
                           const Window& window) {
  constexpr double largest = 1e60;
  for (std::size_t i = 0; i < points.size(); ++i) {
    const Point2& p = points[i];
    if (!(std::abs(p.x) <= largest && std::abs(p.y) <= largest))
      throw InputError(fmt::format("{}: ({:g}, {:g}) is beyond 1e60; use a larger unit",
                                   place_of_row(options.points, i), p.x, p.y));
    if (!window.contains(p))
      throw InputError(
          fmt::format("{}: ({:g}, {:g}) lies outside the window; widen it or leave "
                      "the point out",
                      place_of_row(options.points, i), p.x, p.y));
  }
}

std::size_t curves_for(std::size_t points, std::size_t wanted) {
  if (points < 2 || points > most_curve_points) return 0;
  const auto affordable =
      static_cast<std::size_t>(curve_points_in_all / static_cast<double>(points));
  return std::min({wanted, most_curves, std::max<std::size_t>(affordable, 39)});
}

PatternCurve tested(std::vector<double> distances, std::vector<double> observed,
                    std::size_t simulations, const SimulatedCurve& curve, int threads) {
  PatternCurve result;
  result.distances = std::move(distances);
  result.values = observed;
  if (simulations == 0) return result;
  const auto checked = [&curve](std::uint64_t k) {
    checkpoint();
    return curve(k);
  };
  result.test = extreme_rank_length_test(
      curves_with_simulations(std::move(observed), simulations, checked, threads));
  result.simulations = simulations;
  return result;
}

/// Whether pairs nearer than `reach` can be visited within seconds: in lumps there may be nearly as
/// many as of all points.
bool are_few_pairs(const std::vector<Point2>& points, const Window& window, double reach) {
  constexpr double most_pairs = 2e9;
  const PointGrid grid(points, window, 1.0, reach);
  return grid.mean_company() * static_cast<double>(points.size()) < most_pairs;
}

PatternCurve l_curve(const PatternFindings& f, const PatternOptions& options) {
  const std::vector<double> r = default_distances(f.points.size(), f.window, 64);
  if (!are_few_pairs(f.points, f.window, r.back()))
    return {.distances = r, .has_too_many_pairs = true};
  const EdgeCorrection correction = usual_correction(f.window.kind());
  const auto l_of = [&f, r, correction](const std::vector<Point2>& points) {
    return l_from_k(ripley_k(points, f.window, r, correction));
  };
  const std::uint64_t seed = options.seed + second_order;
  return tested(
      r, l_of(f.points), curves_for(f.points.size(), static_cast<std::size_t>(options.simulations)),
      [&, seed](std::uint64_t k) {
        const auto draw = f.window_is_guessed ? box_filling_pattern : random_pattern;
        return l_of(draw(f.window, f.points.size(), seed, k));
      },
      options.threads);
}

PatternCurve mark_curve(const PatternFindings& f, const std::vector<double>& marks,
                        const PatternOptions& options) {
  const std::vector<double> r = default_distances(f.points.size(), f.window, 64);
  if (!are_few_pairs(f.points, f.window, r.back()))
    return {.distances = r, .has_too_many_pairs = true};
  const SmoothingOptions smoothing{.correction = usual_correction(f.window.kind())};
  const auto k_of = [&, r](const std::vector<double>& labels) {
    return mark_correlation(f.points, labels, f.window, r, smoothing);
  };
  const std::uint64_t seed = options.seed + labels;
  return tested(
      r, k_of(marks), curves_for(f.points.size(), static_cast<std::size_t>(options.simulations)),
      [&, seed](std::uint64_t k) { return k_of(relabelled(marks, seed, k)); }, options.threads);
}

SpeciesPair cross_curve(const PatternFindings& f, const std::string& first,
                        const std::string& second, const std::vector<std::string>& species,
                        const PatternOptions& options) {
  TwoSpecies both;
  for (std::size_t i = 0; i < species.size(); ++i) {
    if (species[i] == first) both.first.push_back(f.points[i]);
    if (species[i] == second) both.second.push_back(f.points[i]);
  }
  const std::size_t n = both.first.size() + both.second.size();
  const std::vector<double> r = default_distances(n, f.window, 64);
  if (!are_few_pairs(f.points, f.window, r.back()))
    return {first,
            second,
            both.first.size(),
            both.second.size(),
            {.distances = r, .has_too_many_pairs = true}};
  const EdgeCorrection correction = usual_correction(f.window.kind());
  const auto l_of = [&f, r, correction](const TwoSpecies& s) {
    return l_from_k(cross_ripley_k(s.first, s.second, f.window, r, correction));
  };
  const std::uint64_t seed = options.seed + labels;
  SpeciesPair pair{first, second, both.first.size(), both.second.size(), {}};
  pair.cross_l = tested(
      r, l_of(both), curves_for(n, static_cast<std::size_t>(options.simulations)),
      [&, seed](std::uint64_t k) { return l_of(relabelled(both.first, both.second, seed, k)); },
      options.threads);
  return pair;
}

std::vector<SpeciesPair> species_pairs(const PatternFindings& f,
                                       const std::vector<std::string>& species,
                                       const PatternOptions& options) {
  std::vector<std::string> names(species);
  std::sort(names.begin(), names.end());
  names.erase(std::unique(names.begin(), names.end()), names.end());
  constexpr std::size_t most_species = 20;
  if (names.size() < 2)
    throw InputError(fmt::format("{}: column '{}' names one species only; leave out --species",
                                 options.points, options.species));
  if (names.size() > most_species)
    throw InputError(fmt::format("{}: column '{}' names {} species; at most {}, please",
                                 options.points, options.species, names.size(), most_species));
  std::vector<SpeciesPair> pairs;
  for (std::size_t a = 0; a < names.size(); ++a)
    for (std::size_t b = a + 1; b < names.size(); ++b) {
      step(fmt::format("comparing {} and {}", names[a], names[b]));
      pairs.push_back(cross_curve(f, names[a], names[b], species, options));
    }
  return pairs;
}

void measure_hopkins(PatternFindings& f, const PatternOptions& options) {
  step("integrating over Voronoi cells");
  f.hopkins = hopkins_exact(f.points, f.window, options.threads);
  step("sampling places");
  CounterStream stream(options.seed + sampling, 0);
  f.sampled_hopkins = hopkins_sampled(f.points, f.window, f.points.size(), stream, options.threads);
  f.clark_evans = clark_evans(f.points, f.window, options.threads);
  if (f.window_is_guessed)  // points on every side: not what its law is about
    f.clark_evans.z = f.clark_evans.p_value = std::numeric_limits<double>::quiet_NaN();
  if (f.points.size() < 2) return;
  step(fmt::format("simulating {} random patterns", options.simulations));
  f.null = hopkins_null(f.window, f.points.size(),
                        {.simulations = static_cast<std::size_t>(options.simulations),
                         .seed = options.seed,
                         .threads = options.threads,
                         .fills_box = f.window_is_guessed,
                         .checkpoint = checkpoint});
  if (!std::isnan(f.hopkins.mean_ratio))
    f.p_value = rank_p_value(f.hopkins.mean_ratio, f.null.mean_ratio, Tail::both);
}

PatternFindings examine(const PatternOptions& options) {
  step("reading points");
  std::vector<std::string> numbers{"x", "y"}, words;
  if (!options.mark.empty()) numbers.push_back(options.mark);
  if (!options.species.empty()) words.push_back(options.species);
  CsvTable table = read_table(options.points, numbers, words);
  std::vector<Point2> points = joined(table.numbers);
  const Window window = chosen_window(options, points);
  refuse_points_outside(options, points, window);
  PatternFindings f{.points = std::move(points),
                    .window = window,
                    .window_is_guessed = options.window.empty() && options.polygon.empty()};
  measure_hopkins(f, options);
  if (f.points.size() >= 2) {
    step("counting pairs");
    f.l_function = l_curve(f, options);
    if (!options.mark.empty()) f.marks = mark_curve(f, table.numbers[2], options);
  }
  if (!options.species.empty()) f.species = species_pairs(f, table.words[0], options);
  return f;
}

}  // namespace

int pattern(const PatternOptions& options) {
  catch_interrupts();
  const PatternFindings findings = examine(options);
  clear_progress();
  print(options.json ? pattern_json(findings, options) : pattern_text(findings, options));
  return 0;
}

}  // namespace phytobench::cli
