// SPDX-License-Identifier: MIT
// The bush of eq. 7 after seven steps: its branching, how thick and how coloured it is from the
// root to the tips, and its leaves.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/brzoska2019/drawn_plant_picture.hpp"
#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr int steps = 7;
constexpr double nearly_equal = 1e-6;  ///< d; places nearer than this are one

void record_shape(ExperimentContext& context, const LSystem& system, const Word& word,
                  const Drawing& plant) {
  const Skeleton tree = turtle_tree(system, word).skeleton;
  context.record("shape/nodes", whole(tree.node_count()), "nodes");
  context.record("shape/segments", whole(plant.segments.size()), "segments");
  const DistinctParts parts = distinct_parts(plant, nearly_equal);
  context.record("shape/different_segments", whole(parts.segments), "segments");
  const BoundingBox box = segment_box(plant);
  context.record("shape/extent_x", box.extent().x, "d");
  context.record("shape/extent_y", box.extent().y, "d");
  context.record("shape/extent_z", box.extent().z, "d");
  double largest = 0.0;
  const auto literal =
      oracles::turtle_3d(oracles::modules_of(text_of(system, word)),
                         {.length = 1.0, .angle_deg = 22.5}, oracles::start_upwards);
  for (std::size_t i = 0; i < plant.segments.size(); ++i) {
    const auto& to = literal.segments.at(i).to;
    largest = std::max(largest, norm(plant.segments[i].to - Vector3{to.x, to.y, to.z}));
  }
  context.record("shape/differs_from_oracle", largest, "d");
}

/// Segments and corners that lie elsewhere with three primes in p4.
void record_primes(ExperimentContext& context, const Drawing& plant) {
  const LSystem other_system = thesis_l_system(equation_7_text(3));
  const Drawing other = draw(other_system, derived(other_system, steps));
  std::int64_t elsewhere = plant.segments.size() != other.segments.size() ||
                           plant.corners.size() != other.corners.size();
  for (std::size_t i = 0; elsewhere == 0 && i < plant.segments.size(); ++i)
    elsewhere = plant.segments[i].to != other.segments[i].to;
  for (std::size_t i = 0; elsewhere == 0 && i < plant.corners.size(); ++i)
    elsewhere = plant.corners[i] != other.corners[i];
  context.record("primes/shapes_differ", elsewhere);
  std::int64_t one_more = 0;
  for (std::size_t i = 0; i < plant.polygons.size(); ++i)
    one_more += other.polygons.at(i).colour == plant.polygons[i].colour + 1;
  context.record("primes/leaves_of_the_next_colour", one_more, "leaves");
}

/// Pens at the apices: the same turtle that draws a line at each A, too.
void record_apices(ExperimentContext& context, LSystem system, int n) {
  system.turtle.draws = "A";
  system.turtle.width_factor = 0.5;  // exact
  const Drawing apices = draw(system, derived(system, n));
  std::int64_t other_width = 0, without_prime = 0;
  double colours = 0.0;
  for (const TurtleSegment& apex : apices.segments) {
    other_width += static_cast<double>(apex.width) != std::pow(0.5, n);
    without_prime += apex.colour == 0;
    colours += apex.colour;
  }
  const std::string name = fmt::format("apices/n-{}/", n);
  context.record(name + "number", whole(apices.segments.size()), "apices");
  context.record(name + "other_width", other_width, "apices");
  context.record(name + "mean_colour", colours / static_cast<double>(apices.segments.size()));
  context.record(name + "of_the_first_colour", without_prime, "apices");
}

/// From the root up: segments that are thicker, or nearer to the first colour, than the one below.
void record_pens(ExperimentContext& context, const LSystem& system, const Word& word) {
  const TurtleTree tree = turtle_tree(system, word);
  std::int64_t thicker = 0, back = 0, thinner = 0;
  for (std::size_t node = 1; node < tree.widths.size(); ++node) {
    const std::int32_t parent = tree.skeleton.parents()[node];
    if (parent == 0) continue;
    const auto below = static_cast<std::size_t>(parent);
    thicker += tree.widths[node] > tree.widths[below];
    thinner += tree.widths[node] < tree.widths[below];
    back += tree.colours[node] < tree.colours[below];
  }
  context.record("pens/thicker_than_below", thicker, "segments");
  context.record("pens/thinner_than_below", thinner, "segments");
  context.record("pens/colour_before_that_below", back, "segments");
}

void record_leaves(ExperimentContext& context, const Drawing& plant) {
  double gap = 0.0, area_off = 0.0;
  std::int64_t least_colour = 1000, other_corners = 0;
  const double area = 2.0 * std::sin(std::acos(-1.0) / 8) * (1.0 + std::cos(std::acos(-1.0) / 8));
  for (const TurtlePolygon& leaf : plant.polygons) {
    const auto corners = corners_of(plant, leaf);
    gap = std::max(gap, norm(corners.back() - corners.front()));
    other_corners += corners.size() != 7;
    area_off = std::max(area_off, std::abs(norm(vector_area(corners)) - area));
    least_colour = std::min<std::int64_t>(least_colour, leaf.colour);
  }
  context.record("leaves/number", whole(plant.polygons.size()), "leaves");
  context.record("leaves/largest_gap", gap, "d");
  context.record("leaves/of_other_corners", other_corners, "leaves");
  context.record("leaves/area_off", area_off, "d^2");
  context.record("leaves/least_colour", least_colour);
}

void add_picture(ExperimentContext& context, const LSystem& system, const Word& word) {
  DrawingPlantOptions options;
  // From brown to green, by the primes that a twig has met at most, and two of its leaves.
  options.colours = {"#6b4a2b", "#684d2b", "#65512b", "#62542b", "#5f582a", "#5c5b2a",
                     "#595f2a", "#56622a", "#53662a", "#506929", "#4d6d29", "#4a7029",
                     "#477429", "#457729", "#457a29", "#457d29", "#457d29"};
  add_plant_picture(context, "figure-16", make_drawing_plant(system, word, options), options, {},
                    true);
}

void run(ExperimentContext& context) {
  const LSystem system = thesis_l_system(equation_7_text());
  const Word word = derived(system, steps);
  const Drawing plant = draw(system, word);
  record_shape(context, system, word, plant);
  record_primes(context, plant);
  for (const int n : {1, 3, 7}) record_apices(context, system, n);
  record_pens(context, system, word);
  record_leaves(context, plant);
  add_picture(context, system, word);
}

}  // namespace

extern const ExperimentDescriptor figure_16;
constinit const ExperimentDescriptor figure_16{
    .id = "brzoska2019/figure-16",
    .question = "How thick, how coloured and how branched is the bush of eq. 7 after seven steps?",
    .source = "[Brzoska2019] eq. 7, fig. 16",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
