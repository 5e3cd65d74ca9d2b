// SPDX-License-Identifier: MIT
// Where the shade of a crown lies while the sun passes: figures 5.5 and 5.6, the reason for rings.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/point2.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// The crown is a disc of radius 1 at height 1, the stem at the origin. From here up the sun
/// shines.
constexpr double first_elevation_deg = 10.0;

double radians(double degrees) {
  return degrees * std::numbers::pi / 180.0;
}

/// Centre of the shade when the sun has come `angle` degrees along its way, a half circle from east
/// to west that leans `tilt` degrees from the zenith. The shade's centre moves along a line.
Point2 shade_centre(double angle_deg, double tilt_deg) {
  const double tilt = radians(tilt_deg);
  return {-1.0 / (std::tan(radians(angle_deg)) * std::cos(tilt)), std::tan(tilt)};
}

/// Part of the day for which a place lies in the shade.
double shaded_share(const Point2& place, double tilt_deg = 0.0) {
  constexpr int instants = 4'000;
  int shaded = 0;
  for (int i = 0; i < instants; ++i) {
    const double angle =
        first_elevation_deg + (180.0 - 2.0 * first_elevation_deg) * (i + 0.5) / instants;
    shaded += squared_norm(place - shade_centre(angle, tilt_deg)) <= 1.0;
  }
  return static_cast<double>(shaded) / instants;
}

void record_places(ExperimentContext& context) {
  for (const auto& [name, distance] : {std::pair{"0-0", 0.0}, std::pair{"0-6", 0.6},
                                       std::pair{"1-0", 1.0}, std::pair{"2-0", 2.0}}) {
    context.record(fmt::format("along/distance-{}", name), shaded_share({distance, 0}));
    context.record(fmt::format("across/distance-{}", name), shaded_share({0, distance}));
  }
}

/// Mean over each of the crown's five rings of equal width.
void record_rings(ExperimentContext& context) {
  constexpr int circles = 6, places = 24;
  for (int F = 1; F <= 5; ++F) {
    double sum = 0.0, weight = 0.0;
    for (int k = 0; k < circles; ++k)
      for (int i = 0; i < places; ++i) {
        const double radius = (F - 1 + (k + 0.5) / circles) / 5.0;
        const double angle = radians(360.0 * (i + 0.5) / places);
        sum += radius * shaded_share({radius * std::cos(angle), radius * std::sin(angle)});
        weight += radius;
      }
    context.record(fmt::format("rings/ring-{}/mean", F), sum / weight);
  }
}

/// Where it is shadiest, in crown radii north of the stem, for a sun that passes through the zenith
/// and for one that stays 30 degrees below it.
void record_shadiest(ExperimentContext& context) {
  for (const double tilt : {0.0, 30.0}) {
    double largest = 0.0, off = 0.0, north = 0.0;
    for (int i = -15; i <= 15; ++i)
      for (int j = -15; j <= 15; ++j) {
        const Point2 place{0.1 * i, 0.1 * j};
        const double share = shaded_share(place, tilt);
        if (share > largest) largest = share, off = norm(place), north = place.y;
      }
    const std::string name = fmt::format("shadiest/tilt-{:.0f}", tilt);
    context.record(name + "/share", largest);
    context.record(name + "/distance", off, "crown radii");
    context.record(name + "/north", north, "crown radii");
  }
}

void draw_shares(ExperimentContext& context) {
  PlotCurve along{.name = "along the sun's way", .x = {}, .y = {}, .colour = 1};
  PlotCurve across{.name = "across it", .x = {}, .y = {}, .style = PlotStyle::dashed, .colour = 0};
  for (int i = 0; i <= 100; ++i) {
    const double distance = 0.03 * i;
    for (PlotCurve* curve : {&along, &across}) curve->x.push_back(distance);
    along.y.push_back(shaded_share({distance, 0}));
    across.y.push_back(shaded_share({0, distance}));
  }
  const PlotCurve rim{.name = "rim of ring 3",
                      .x = {0.6, 0.6},
                      .y = {0.0, 0.6},
                      .style = PlotStyle::dotted,
                      .colour = 3};
  add_plot(context, "shade-of-the-day",
           {.title = "Part of the day in the shade of a crown",
            .description = "Part of the day that a place lies in shade, over its distance from the "
                           "stem along the sun's way and across it, and the rim of ring 3.",
            .panels = {{.curves = {along, across, rim},
                        .caption = "Crown of radius 1 at height 1",
                        .x_label = "distance from the stem, crown radii",
                        .y_label = "part of the day in shade"}}});
}

/// The shades of the day, one upon the other, and the core circle.
void draw_shades(ExperimentContext& context) {
  std::string text =
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-4 -1.6 8 3.4\" role=\"img\" "
      "aria-label=\"Shades of a crown through the day\">\n"
      "<title>Shades of a crown through the day, laid upon each other</title>\n"
      "<clipPath id=\"day\"><rect x=\"-4\" y=\"-1.5\" width=\"8\" height=\"3\"/></clipPath>\n"
      "<g clip-path=\"url(#day)\" fill=\"currentColor\" fill-opacity=\".035\">\n";
  for (int i = 0; i <= 40; ++i)
    text += fmt::format("<circle cx=\"{:.3f}\" r=\"1\"/>\n",
                        shade_centre(first_elevation_deg + 4.0 * i, 0.0).x);
  text += "</g>\n<circle r=\".6\" fill=\"none\" stroke=\"#d32f2f\" stroke-width=\".03\"/>\n";
  for (const double radius : {0.2, 0.4, 0.8, 1.0})
    text += fmt::format(
        "<circle r=\"{}\" fill=\"none\" stroke=\"currentColor\" "
        "stroke-width=\".01\" stroke-dasharray=\".05\"/>\n",
        radius);
  text +=
      "<text y=\"1.72\" font-size=\".2\" text-anchor=\"middle\" fill=\"currentColor\" "
      "font-family=\"sans-serif\">41 instants of a day, five rings of the crown, core circle "
      "in red</text>\n</svg>\n";
  context.artifact("shades.svg", text);
}

void run(ExperimentContext& context) {
  record_places(context);
  record_rings(context);
  record_shadiest(context);
  draw_shares(context);
  draw_shades(context);
}

}  // namespace

extern const ExperimentDescriptor shade_of_the_day;
constinit const ExperimentDescriptor shade_of_the_day{
    .id = "alsweis/shade-of-the-day",
    .question = "For how much of the day does a crown shade the ground below it?",
    .source = "[Alsweis] sec. 5.2.2, fig. 5.5, 5.6",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
