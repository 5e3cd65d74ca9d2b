// SPDX-License-Identifier: MIT
// Figure 2.6: the trees that the L-system of eq. 2.17 draws in space.
#include <set>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/path_lengths.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int steps = space_tree_steps;

void measure_words(ExperimentContext& context) {
  const LSystem system = space_tree_system(pitch_a_deg);
  for (int n = 0; n <= steps; ++n) {
    const Word word = derived(system, n);
    const std::string name = fmt::format("n-{}/", n);
    context.record(name + "A", letter_count(system, word, "A"));
    context.record(name + "F", letter_count(system, word, "F"));
    context.record(name + "pairs", letter_count(system, word, "["));
    context.record(name + "pitches", letter_count(system, word, "&"));
    context.record(name + "rolls", letter_count(system, word, "/"));
    context.record(name + "modules", static_cast<std::int64_t>(word.size()));
  }
}

double off_oracle(const Drawing& drawing, double pitch_deg) {
  const oracles::ParametricWord word = oracles::liebemann2017::derive(
      oracles::liebemann2017::equation_2_17(pitch_deg, 137.5, space_tree_growth), steps);
  return segments_off(drawing.segments, oracles::turtle_3d(word, {}).segments);
}

void measure_lines(ExperimentContext& context, const LSystem& system, const Word& word) {
  std::set<double> lengths;
  for (const oracles::Module& module : literal_word(system, word))
    if (module.letter == "F") lengths.insert(module.parameters[0]);
  context.record("a/different_line_lengths", static_cast<std::int64_t>(lengths.size()));
  context.record("a/shortest_line", *lengths.begin(), "length");
  context.record("a/longest_line", *lengths.rbegin(), "length");
}

void measure_figure(ExperimentContext& context, const std::string& panel, double pitch_deg) {
  const LSystem system = space_tree_system(pitch_deg);
  const Word word = derived(system, steps);
  const Drawing drawing = draw(system, word);
  const Skeleton skeleton = turtle_tree(system, word).skeleton;
  const std::string name = panel + "/";
  context.record(name + "lines", static_cast<std::int64_t>(drawing.segments.size()));
  context.record(name + "drawn_length", total_length(drawing), "length");
  tip_path_lengths(skeleton).record(context, name + "path_to_tip", "length");
  context.record(name + "different_tips",
                 static_cast<std::int64_t>(distinct_point_count(tip_positions(skeleton), 1e-6)));
  const BoundingBox box = segment_box(drawing);
  context.record(name + "low_x", box.low().x, "length");
  context.record(name + "low_y", box.low().y, "length");
  context.record(name + "low_z", box.low().z, "length");
  context.record(name + "high_x", box.high().x, "length");
  context.record(name + "high_y", box.high().y, "length");
  context.record(name + "high_z", box.high().z, "length");
  context.record(name + "off_oracle", off_oracle(drawing, pitch_deg), "length");
  if (panel == "a") measure_lines(context, system, word);
}

/// Seen from the side with the heading upwards. A page holds six of the eight steps.
void draw_pictures(ExperimentContext& context) {
  for (const auto& [panel, pitch_deg] :
       {std::pair{'a', pitch_a_deg}, std::pair{'b', pitch_b_deg}}) {
    const LSystem system = space_tree_system(pitch_deg, "start: upwards");
    for (const int n : {steps - 2, steps}) {
      if (n == steps && context.tier() != Tier::full) continue;
      context.artifact(
          fmt::format("figure-2.6{}{}.svg", panel, n == steps ? "-full" : ""),
          drawing_svg(draw(system, derived(system, n)),
                      fmt::format("Eq. 2.17 after n = {}, a = {} degrees", n, pitch_deg),
                      {.longer_side = 400.0}));
    }
  }
}

void run(ExperimentContext& context) {
  measure_words(context);
  measure_figure(context, "a", pitch_a_deg);
  measure_figure(context, "b", pitch_b_deg);
  draw_pictures(context);
}

}  // namespace

extern const ExperimentDescriptor space_tree;
constinit const ExperimentDescriptor space_tree{
    .id = "liebemann2017/space-tree",
    .question = "What does the L-system of eq. 2.17 draw in space?",
    .source = "[Liebemann2017] sec. 2.3.3, eq. 2.17, fig. 2.6",
    .seconds = {0.5, 0.5, 0.6},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
