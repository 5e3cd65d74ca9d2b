// SPDX-License-Identifier: MIT
#include "cli/pattern_output.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/json_values.hpp"
#include "cli/option_values.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

constexpr double level = 0.05;

ordered_json numbers(const std::vector<double>& values) {
  ordered_json list = ordered_json::array();
  for (const double value : values) list.push_back(number_or_null(value));
  return list;
}

/// In one word.
std::string kind_of(const PatternFindings& f) {
  if (f.points.size() < 2) return "undecided";
  if (std::isinf(f.hopkins.mean_ratio)) return "clustered";
  if (!f.p_value) return "undecided";
  if (*f.p_value > level) return "random";
  return f.hopkins.mean_ratio > 1.0 ? "clustered" : "regular";
}

std::string verdict_of(const PatternFindings& f) {
  const std::string kind = kind_of(f);
  if (f.points.size() < 2) return "undecided: it takes at least two points";
  if (kind == "undecided") return "undecided: the index has no value here";
  if (std::isinf(f.hopkins.mean_ratio)) return "clustered: every point has a twin at its own place";
  if (kind == "random")
    return "random: nothing speaks against points that know nothing of each other";
  return kind == "clustered" ? "clustered: points are nearer to each other than to random places"
                             : "regular: points keep away from each other";
}

const char* null_method(const PatternFindings& f) {
  return f.null.points_per_pattern < f.points.size()
             ? "Monte Carlo rank, spread scaled from smaller random patterns"
             : "Monte Carlo rank among random patterns of as many points";
}

const char* edges_of(const PatternFindings& f) {
  return f.window.kind() == WindowKind::torus ? "joined" : "open, not corrected in the index";
}

ordered_json ratio_json(double exact, double sampled, const std::vector<double>& null) {
  ordered_json json{
      {"exact", number_or_null(exact)}, {"sampled", number_or_null(sampled)}, {"csr95", nullptr}};
  if (!null.empty()) {
    const auto band = central_95(null);
    json["csr95"] = {number_or_null(band[0]), number_or_null(band[1])};
  }
  return json;
}

bool is_undefined(const PatternCurve& curve) {
  return std::none_of(curve.values.begin(), curve.values.end(),
                      [](double value) { return std::isfinite(value); });
}

ordered_json curve_json(const PatternCurve& curve, const char* name) {
  ordered_json json{{"r", numbers(curve.distances)}, {name, numbers(curve.values)}};
  json["simulations"] = curve.simulations;
  const bool is_tested = curve.simulations > 0 && !is_undefined(curve);
  json["p_value"] = is_tested ? ordered_json(curve.test.p_value) : nullptr;
  if (curve.simulations > 0) {
    json["low"] = numbers(curve.test.low);
    json["high"] = numbers(curve.test.high);
  }
  return json;
}

ordered_json window_json(const Window& window) {
  const Rectangle& box = window.bounding_box();
  ordered_json json{{"kind", name_of(window.kind())},
                    {"box", {box.low.x, box.low.y, box.high.x, box.high.y}},
                    {"area", window.area()},
                    {"perimeter", window.perimeter()}};
  if (window.kind() != WindowKind::polygon) return json;
  json["corners"] = ordered_json::array();
  for (const Point2& corner : window.corners()) json["corners"].push_back({corner.x, corner.y});
  return json;
}

ordered_json clark_evans_json(const ClarkEvansIndex& index) {
  return {{"ratio", number_or_null(index.ratio)},
          {"naive_ratio", number_or_null(index.naive_ratio)},
          {"mean_distance", number_or_null(index.mean_distance)},
          {"expected_distance", number_or_null(index.expected_distance)},
          {"z", number_or_null(index.z)},
          {"p_value", number_or_null(index.p_value)}};
}

/// "0.2 to 3.4, 5" for the distances at which a curve is above (side 1) or below (-1) its envelope.
std::string ranges_beyond(const PatternCurve& curve, int side) {
  const auto is_beyond = [&](std::size_t k) {
    return side > 0 ? curve.values[k] > curve.test.high[k] : curve.values[k] < curve.test.low[k];
  };
  std::string text;
  for (std::size_t k = 0; k < curve.values.size(); ++k) {
    if (!is_beyond(k)) continue;
    const double first = curve.distances[k];
    while (k + 1 < curve.values.size() && is_beyond(k + 1)) ++k;
    text += fmt::format("{}{:.4g}", text.empty() ? "" : ", ", first);
    if (curve.distances[k] > first) text += fmt::format(" to {:.4g}", curve.distances[k]);
  }
  return text;
}

std::string departures(const PatternCurve& curve, const char* above, const char* below) {
  const std::string high = ranges_beyond(curve, 1), low = ranges_beyond(curve, -1);
  std::string text;
  if (!high.empty()) text = fmt::format("{} for r = {}", above, high);
  if (!low.empty()) text += fmt::format("{}{} for r = {}", text.empty() ? "" : "; ", below, low);
  return text.empty() ? "within its envelope at every distance" : text;
}

std::string curve_line(const std::string& name, const PatternCurve& curve, const char* above,
                       const char* below) {
  if (curve.has_too_many_pairs)
    return fmt::format("{}: not computed, too many pairs: the points stand in tight lumps\n", name);
  if (is_undefined(curve)) return fmt::format("{}: undefined at every distance\n", name);
  if (curve.simulations == 0) return fmt::format("{}: not tested for so many points\n", name);
  return fmt::format("{}: p = {:.3g} ({} simulations); {}\n", name, curve.test.p_value,
                     curve.simulations, departures(curve, above, below));
}

std::string window_text(const PatternFindings& f) {
  const Rectangle& box = f.window.bounding_box();
  std::string text = fmt::format("{} {:g},{:g} to {:g},{:g}", name_of(f.window.kind()), box.low.x,
                                 box.low.y, box.high.x, box.high.y);
  if (f.window_is_guessed)
    text += " (the points' bounding box, for want of --window or --polygon: a little too small)";
  return text;
}

std::string ratio_line(const char* name, double exact, double sampled,
                       const std::vector<double>& null) {
  std::string band = "-";
  if (!null.empty()) {
    const auto ends = central_95(null);
    band = fmt::format("{:.4f} to {:.4f}", ends[0], ends[1]);
  }
  return fmt::format("{:<22} {:>10.6g} {:>10.6g}   {}\n", name, exact, sampled, band);
}

std::string clark_evans_test(const PatternFindings& f) {
  if (f.window_is_guessed) return "no p-value in a guessed window";
  const ClarkEvansIndex& c = f.clark_evans;
  if (std::isnan(c.z)) return "no p-value: window too thin or points too few for its law";
  return fmt::format("z = {:.2f}, p = {:.3g}", c.z, c.p_value);
}

}  // namespace

std::string pattern_json(const PatternFindings& f, const PatternOptions& options) {
  ordered_json json{{"schema", "phytobench/pattern-1"},
                    {"points", options.points},
                    {"n", f.points.size()},
                    {"density", static_cast<double>(f.points.size()) / f.window.area()},
                    {"window", window_json(f.window)},
                    {"window_is_guessed", f.window_is_guessed},
                    {"edge", edges_of(f)}};
  json["hopkins"] = {
      {"orientation",
       "distance from places over distance between points: 1 random, above clustered"},
      {"sampled_places", f.points.size()},
      {"mean_ratio",
       ratio_json(f.hopkins.mean_ratio, f.sampled_hopkins.mean_ratio, f.null.mean_ratio)},
      {"squared_ratio",
       ratio_json(f.hopkins.squared_ratio, f.sampled_hopkins.squared_ratio, f.null.squared_ratio)}};
  json["clark_evans"] = clark_evans_json(f.clark_evans);
  json["l_function"] = curve_json(f.l_function, "l");
  if (f.marks) json["mark_correlation"] = curve_json(*f.marks, "k_mm");
  if (!f.species.empty()) {
    json["species"] = ordered_json::array();
    for (const SpeciesPair& pair : f.species)
      json["species"].push_back({{"first", pair.first},
                                 {"second", pair.second},
                                 {"n", {pair.first_count, pair.second_count}},
                                 {"cross_l", curve_json(pair.cross_l, "l")}});
  }
  json["simulations"] = f.null.mean_ratio.size();
  json["simulated_points"] = f.null.points_per_pattern;
  json["method"] = null_method(f);
  json["seed"] = options.seed;
  json["p_value"] = f.p_value ? ordered_json(*f.p_value) : nullptr;
  json["kind"] = kind_of(f);
  json["verdict"] = verdict_of(f);
  return json_text(json) + "\n";
}

std::string pattern_text(const PatternFindings& f, const PatternOptions& options) {
  std::string text =
      fmt::format("{}: {} points, {}\n\n", options.points, f.points.size(), window_text(f));
  text += fmt::format("verdict: {}\n", verdict_of(f));
  if (f.p_value)
    text += fmt::format("         p = {:.3g} ({} simulations: {})\n", *f.p_value,
                        f.null.mean_ratio.size(), null_method(f));
  if (f.points.size() < 2) return text;
  text += fmt::format("\n{:<22} {:>10} {:>10}   {}\n", "Hopkins index", "exact", "sampled",
                      "95 % of random patterns");
  text += ratio_line("  <|x-p|> / <|p-q|>", f.hopkins.mean_ratio, f.sampled_hopkins.mean_ratio,
                     f.null.mean_ratio);
  text += ratio_line("  <|x-p|^2> / <|p-q|^2>", f.hopkins.squared_ratio,
                     f.sampled_hopkins.squared_ratio, f.null.squared_ratio);
  text += "  1 random, above clustered, below regular; spatstat prints the second's reciprocal\n\n";
  const ClarkEvansIndex& c = f.clark_evans;
  text += fmt::format(
      "Clark-Evans R = {:.4f} with edges allowed for ({:.4f} without), {}\n"
      "mean distance to the nearest neighbour {:.6g}; {:.6g} for random patterns\n",
      c.ratio, c.naive_ratio, clark_evans_test(f), c.mean_distance, c.expected_distance);
  text += curve_line("Besag's L", f.l_function, "more neighbours than by chance",
                     "fewer neighbours than by chance");
  if (f.marks)
    text += curve_line("mark correlation of " + options.mark, *f.marks,
                       "larger marks near each other", "smaller marks near each other");
  for (const SpeciesPair& pair : f.species)
    text += curve_line(fmt::format("{} ({}) and {} ({})", pair.first, pair.first_count, pair.second,
                                   pair.second_count),
                       pair.cross_l, "attracted", "apart");
  return text;
}

}  // namespace phytobench::cli
