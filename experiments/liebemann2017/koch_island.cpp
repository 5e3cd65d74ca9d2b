// SPDX-License-Identifier: MIT
// Figures 2.3 and 2.4: the island that the L-system of eq. 2.6 draws.
#include <cmath>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "core/lsystem/segment_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/turtle_2d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int panels = 4;      // n = 0 ... 3 in figure 2.4
constexpr int last_steps = 4;  // one more than the figure shows

Drawing island(int n) {
  const LSystem system = koch_system(koch_step(n));
  return draw(system, derived(system, n));
}

/// Segments that the literal turtle on whole numbers draws elsewhere; exact on both sides.
std::int64_t differs_from_oracle(const Drawing& drawing, int n) {
  namespace literal = oracles::liebemann2017;
  const oracles::GridDrawing grid = oracles::turtle_on_grid(
      oracles::modules_of(literal::derive_in_parallel(literal::equation_2_6(), n)), {1, 90});
  if (grid.segments.size() != drawing.segments.size()) return std::int64_t{1} << 40;
  std::int64_t different = 0;
  const auto equal = [&](const Vector3& p, const oracles::GridPoint& q) {
    return p == Vector3{koch_step(n) * static_cast<double>(q.x),
                        koch_step(n) * static_cast<double>(q.y), 0.0};
  };
  for (std::size_t i = 0; i < grid.segments.size(); ++i)
    different += !equal(drawing.segments[i].from, grid.segments[i].from) ||
                 !equal(drawing.segments[i].to, grid.segments[i].to);
  return different;
}

std::int64_t differs_from_stream(const Drawing& drawing, int n) {
  const LSystem system = koch_system(koch_step(n));
  std::int64_t different = 0;
  std::size_t i = 0;
  SegmentStream(system, n).stream(SegmentSink<PlanarSegment>([&](auto block) {
    for (const PlanarSegment& s : block) {
      const TurtleSegment& drawn = drawing.segments[i++];
      different += drawn.from != Vector3{s.from_x, s.from_y, 0.0} ||
                   drawn.to != Vector3{s.to_x, s.to_y, 0.0};
    }
  }));
  return different + static_cast<std::int64_t>(drawing.segments.size() - i);
}

/// Lines of the finer drawing that are not the generator put, at a quarter of its size, where the
/// coarser one has a line.
std::int64_t not_replaced(const Drawing& coarse, const Drawing& fine) {
  const Drawing generator = drawing_of("F+F-F-FF+F+F-F", "angle: 90 step: 0.25");  // up, 1 long
  std::int64_t elsewhere = 0;
  std::size_t i = 0;
  for (const TurtleSegment& line : coarse.segments) {
    const Vector3 ahead = line.to - line.from, aside{-ahead.y, ahead.x, 0.0};
    const auto placed = [&](const Vector3& p) { return line.from + p.y * ahead - p.x * aside; };
    for (const TurtleSegment& part : generator.segments) {
      const TurtleSegment& found = fine.segments[i++];
      elsewhere += found.from != placed(part.from) || found.to != placed(part.to);
    }
  }
  return elsewhere + static_cast<std::int64_t>(fine.segments.size() - i);
}

void measure_figure_2_3(ExperimentContext& context) {
  const Drawing square = island(0), generator = drawing_of("F+F-F-FF+F+F-F", "angle: 90 step: 1");
  std::int64_t right_angles = 0, equal_sides = 0;
  for (std::size_t i = 0; i < square.segments.size(); ++i) {
    const TurtleSegment &a = square.segments[i],
                        &b = square.segments[(i + 1) % square.segments.size()];
    right_angles += dot(a.to - a.from, b.to - b.from) == 0.0;
    equal_sides += norm(a.to - a.from) == koch_step(0);
  }
  context.record("initiator/lines", static_cast<std::int64_t>(square.segments.size()));
  context.record("initiator/right_angles", right_angles);
  context.record("initiator/equal_sides", equal_sides);
  context.record("initiator/closing_gap", closing_gap(square));
  std::int64_t straight_runs = 1;
  for (std::size_t i = 1; i < generator.segments.size(); ++i)
    straight_runs += generator.segments[i].to - generator.segments[i].from !=
                     generator.segments[i - 1].to - generator.segments[i - 1].from;
  context.record("generator/lines", static_cast<std::int64_t>(generator.segments.size()));
  context.record("generator/straight_runs", straight_runs);
  context.record("generator/one_line", std::int64_t{is_one_line(generator)});
  context.record("generator/closing_gap", closing_gap(generator), "lines");
  context.record("generator/ahead", generator.end.y, "lines");
  context.record("generator/aside", generator.end.x, "lines");
  context.artifact(
      "figure-2.3-generator.svg",
      drawing_svg(generator, "Figure 2.3: the generator of eq. 2.6", {.longer_side = 300.0}));
}

void measure_panel(ExperimentContext& context, int n) {
  const LSystem system = koch_system(koch_step(n));
  const Word word = derived(system, n);
  const Drawing drawing = draw(system, word);
  const std::string name = fmt::format("n-{}/", n);
  context.record(name + "step", koch_step(n), "length");
  context.record(name + "letters", static_cast<std::int64_t>(word.size()));
  context.record(name + "plus", letter_count(system, word, "+"));
  context.record(name + "minus", letter_count(system, word, "-"));
  context.record(name + "lines", static_cast<std::int64_t>(drawing.segments.size()));
  context.record(name + "one_line", std::int64_t{is_one_line(drawing)});
  context.record(name + "closing_gap", closing_gap(drawing), "length");
  context.record(name + "drawn_length", total_length(drawing), "length");
  context.record(name + "signed_area", signed_area(drawing), "area");
  const BoundingBox box = segment_box(drawing);
  context.record(name + "low_x", box.low().x, "length");
  context.record(name + "low_y", box.low().y, "length");
  context.record(name + "high_x", box.high().x, "length");
  context.record(name + "high_y", box.high().y, "length");
  const DistinctParts parts = distinct_parts(drawing);
  context.record(name + "most_often_drawn", static_cast<std::int64_t>(parts.most_often));
  context.record(name + "vertices", static_cast<std::int64_t>(parts.vertices));
  context.record(name + "differs_from_oracle", differs_from_oracle(drawing, n));
  context.record(name + "differs_from_stream", differs_from_stream(drawing, n));
  if (n < last_steps) context.record(name + "not_replaced", not_replaced(drawing, island(n + 1)));
  if (n >= panels) return;
  const std::string figure = fmt::format("figure-2.4{}", static_cast<char>('a' + n));
  context.artifact(
      figure + ".svg",
      drawing_svg(drawing, fmt::format("Eq. 2.6 after n = {}, l = {}", n, koch_step(n)),
                  {.longer_side = 300.0}));
}

/// The same with + and - exchanged, as other books print it.
void measure_mirror_image(ExperimentContext& context) {
  const LSystem system = parse_lsystem(
      "axiom: F+F+F+F\np1 : F -> F-F+F+FF-F-F+F\nangle: 90 step: 25\n", "mirror image");
  const Drawing mirrored = draw(system, derived(system, 2)), drawing = island(2);
  std::int64_t different = 0;
  for (std::size_t i = 0; i < drawing.segments.size(); ++i)
    different += mirrored.segments[i].to !=
                 Vector3{0.0 - drawing.segments[i].to.x, drawing.segments[i].to.y, 0.0};
  context.record("mirror_image/signed_area", signed_area(mirrored), "area");
  context.record("mirror_image/lines_elsewhere", different);
}

void run(ExperimentContext& context) {
  measure_figure_2_3(context);
  for (int n = 0; n <= last_steps; ++n) measure_panel(context, n);
  measure_mirror_image(context);
}

}  // namespace

extern const ExperimentDescriptor koch_island;
constinit const ExperimentDescriptor koch_island{
    .id = "liebemann2017/koch-island",
    .question = "What does the L-system of the Koch island draw?",
    .source = "[Liebemann2017] sec. 2.3.1, eq. 2.6, fig. 2.3, 2.4",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
