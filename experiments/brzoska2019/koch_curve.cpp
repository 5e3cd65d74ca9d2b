// SPDX-License-Identifier: MIT
// The Koch curve of eq. 5: its counts, its size, and how each stage comes from the one before.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr int most_steps = 8;

void record_stage(ExperimentContext& context, const LSystem& system, int n, const Word& word,
                  const Drawing& curve) {
  const std::string stage = fmt::format("n-{}/", n);
  context.record(stage + "segments", whole(curve.segments.size()), "segments");
  context.record(stage + "letters", whole(word.size()), "letters");
  context.record(stage + "end_distance", norm(curve.end), "d");
  context.record(stage + "drawn_length", total_length(curve), "d");
  context.record(stage + "is_one_line", std::int64_t{is_one_line(curve)});
  const Vector3 start = curve.segments.front().to - curve.segments.front().from;
  context.record(stage + "heading_against_start", norm(curve.end_frame.heading - start));
  context.record(stage + "end_beside_first_heading", norm(cross(start, curve.end)), "d");
  const std::uint64_t F = symbol_counts(system, word)[*find_symbol(system, "F", 0)];
  context.record(
      stage + "differs_from_closed_forms",
      std::int64_t{F != oracles::equation_5_F(n) || word.size() != oracles::equation_5_letters(n)});
}

/// Every segment becomes four: how far the ends of these are from the old ends, and the place in
/// their middle from the old segment, both in steps of the new stage.
void record_refinement(ExperimentContext& context, int n, const Drawing& before,
                       const Drawing& after) {
  double moved = 0.0, off = 0.0;
  for (std::size_t i = 0; i < before.segments.size(); ++i) {
    const Vector3 from = 3.0 * before.segments[i].from, to = 3.0 * before.segments[i].to;
    moved = std::max(
        {moved, norm(after.segments[4 * i].from - from), norm(after.segments[4 * i + 3].to - to)});
    off = std::max(off, norm(cross(after.segments[4 * i + 1].to - from, to - from)) / 3.0);
  }
  const std::string name = fmt::format("refinement/n-{}/", n);
  context.record(name + "moved", moved, "d");
  context.record(name + "off_the_curve", off, "d");
  context.record(name + "off_the_curve_of_width", off / norm(after.end));
}

/// The word of a stage is made of four words of the stage before.
std::int64_t stages_not_self_similar(const std::vector<std::string>& words) {
  std::int64_t others = 0;
  for (std::size_t n = 1; n < words.size(); ++n) {
    const std::string& w = words[n - 1];
    others += words[n] != w + "+" + w + "--" + w + "+" + w;
  }
  return others;
}

/// Stages side by side, each as wide as the others, lying as the figure has them.
void append_stage(Drawing& figure, const Drawing& curve, double column) {
  const double width = norm(curve.end);
  const auto placed = [&](const Vector3& p) {
    return Vector3{p.y / width + 1.25 * column, -p.x / width, 0.0};
  };
  for (TurtleSegment segment : curve.segments) {
    segment.from = placed(segment.from);
    segment.to = placed(segment.to);
    figure.segments.push_back(segment);
  }
}

void run(ExperimentContext& context) {
  const LSystem system = thesis_l_system(equation_5_text);
  Drawing figure, before;
  figure.planar = true;
  std::vector<std::string> words;
  for (int n = 0; n <= most_steps; ++n) {
    const Word word = derived(system, n);
    words.push_back(text_of(system, word));
    Drawing curve = draw(system, word);
    record_stage(context, system, n, word, curve);
    if (n > 0) record_refinement(context, n, before, curve);
    if (n <= 4) append_stage(figure, curve, n);
    before = std::move(curve);
  }
  context.record("stages_not_self_similar", stages_not_self_similar(words));
  DrawingSvgOptions options;
  options.longer_side = 1500.0;
  context.artifact("figure-13.svg",
                   drawing_svg(figure, "Koch curve after 0 to 4 steps, eq. 5", options));
}

}  // namespace

extern const ExperimentDescriptor koch_curve;
constinit const ExperimentDescriptor koch_curve{
    .id = "brzoska2019/koch-curve",
    .question = "Does eq. 5 draw the Koch curve?",
    .source = "[Brzoska2019] eq. 5, fig. 13",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
