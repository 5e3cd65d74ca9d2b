// SPDX-License-Identifier: MIT
// Figure 2.5: two plants in the plane.
#include <cmath>
#include <span>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "core/lsystem/segment_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "reference/oracles/drawing_measures.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/turtle_2d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

namespace literal = oracles::liebemann2017;

constexpr double same_place = 1e-6;  // far above rounding, far below a line

struct PlaneFigure {
  std::string name;
  LSystem system;
  int steps;
  literal::D0LSystem printed;
};

double off_stream(const Drawing& drawing, const PlaneFigure& figure) {
  std::vector<SpatialSegment> streamed;
  SegmentStream(figure.system, figure.steps)
      .stream(SegmentSink<SpatialSegment>([&](std::span<const SpatialSegment> block) {
        streamed.insert(streamed.end(), block.begin(), block.end());
      }));
  return segments_off(drawing.segments, streamed);
}

oracles::PlaneDrawing literal_drawing(const PlaneFigure& figure) {
  const oracles::ParametricWord word =
      oracles::modules_of(literal::derive_in_parallel(figure.printed, figure.steps));
  const TurtleSettings& turtle = figure.system.turtle;
  return oracles::turtle_2d(word, {turtle.step, turtle.angle_deg});
}

/// Lines that do not begin where the line before ended: where a branch has ended.
std::int64_t gaps(const Drawing& drawing) {
  std::int64_t gaps = 0;
  for (std::size_t i = 1; i < drawing.segments.size(); ++i)
    gaps += drawing.segments[i].from != drawing.segments[i - 1].to;
  return gaps;
}

void measure_words(ExperimentContext& context, const PlaneFigure& figure) {
  for (int n = 0; n <= figure.steps; ++n) {
    const Word word = derived(figure.system, n);
    const std::string name = fmt::format("{}/n-{}/", figure.name, n);
    context.record(name + "F", letter_count(figure.system, word, "F"));
    context.record(name + "letters", static_cast<std::int64_t>(word.size()));
    context.record(name + "pairs", letter_count(figure.system, word, "["));
    context.record(name + "plus", letter_count(figure.system, word, "+"));
    context.record(name + "minus", letter_count(figure.system, word, "-"));
  }
}

void measure_drawing(ExperimentContext& context, const PlaneFigure& figure) {
  const Drawing drawing = draw(figure.system, derived(figure.system, figure.steps));
  const std::string name = figure.name + "/";
  context.record(name + "lines", static_cast<std::int64_t>(drawing.segments.size()));
  context.record(name + "drawn_length", total_length(drawing), "length");
  const BoundingBox box = segment_box(drawing);
  context.record(name + "low_x", box.low().x, "length");
  context.record(name + "low_y", box.low().y, "length");
  context.record(name + "high_x", box.high().x, "length");
  context.record(name + "high_y", box.high().y, "length");
  const DistinctParts parts = distinct_parts(drawing, same_place);
  context.record(name + "different_lines", static_cast<std::int64_t>(parts.segments));
  context.record(name + "different_ends", static_cast<std::int64_t>(parts.vertices));
  context.record(name + "most_often_drawn", static_cast<std::int64_t>(parts.most_often));
  context.record(name + "gaps", gaps(drawing));
  const oracles::PlaneDrawing printed = literal_drawing(figure);
  context.record(name + "off_oracle", segments_off(drawing.segments, printed.segments), "length");
  const std::vector<int> repetitions = oracles::segment_repetitions(printed);
  context.record(name + "different_lines_of_oracle", static_cast<std::int64_t>(repetitions.size()));
  context.record(name + "most_often_drawn_by_oracle",
                 std::int64_t{*std::max_element(repetitions.begin(), repetitions.end())});
  context.record(name + "off_stream", off_stream(drawing, figure), "length");
  context.artifact(fmt::format("figure-2.5{}.svg", figure.name),
                   drawing_svg(drawing,
                               fmt::format("Figure 2.5{}: n = {}, l = {}, d = {} degrees",
                                           figure.name, figure.steps, figure.system.turtle.step,
                                           figure.system.turtle.angle_deg),
                               {.longer_side = 300.0, .widest_line = 0.8}));
}

void run(ExperimentContext& context) {
  const PlaneFigure figures[] = {
      {"a", plant_a_system(), plant_a_steps, literal::figure_2_5a()},
      {"b", plant_b_system(), plant_b_steps, literal::figure_2_5b()},
  };
  for (const PlaneFigure& figure : figures) {
    measure_words(context, figure);
    measure_drawing(context, figure);
  }
}

}  // namespace

extern const ExperimentDescriptor plane_plants;
constinit const ExperimentDescriptor plane_plants{
    .id = "liebemann2017/plane-plants",
    .question = "What do the two branched L-systems of figure 2.5 draw?",
    .source = "[Liebemann2017] sec. 2.3.2, fig. 2.5",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
