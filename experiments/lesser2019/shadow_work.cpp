// SPDX-License-Identifier: MIT
// How the counted work of engines grows with the side of a map: heights that are compared, and
// summaries of many heights that are looked at.
#include <algorithm>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/site_scenes.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

struct Counted {
  const char* engine;
  int largest;  ///< side, in full runs; beyond, counting takes minutes
};
constexpr Counted counted[] = {{"exact_traversal", 2048},
                               {"max_pyramid", 4096},
                               {"bounded_sweep", 4096},
                               {"line_sweep", 8192}};

int largest_side(const Counted& one, Tier tier) {
  return tier == Tier::smoke   ? 256
         : tier == Tier::quick ? std::min(one.largest, 1024)
                               : one.largest;
}

/// Sides from 64 on, doubled; the three smallest under the same names in every run.
void record_engine(ExperimentContext& context, const Counted& one, std::vector<PlotCurve>& curves) {
  // A morning sun, one at 30 degrees, and one in the evening.
  const std::vector<SunDirection> path = thesis_path();
  const std::vector<SunDirection> suns = {path[1], path[2], path[11]};
  const int threads = context.untimed_threads();
  PlotCurve curve{.name = one.engine, .style = PlotStyle::marked};
  for (int side = 64; side <= largest_side(one, context.tier()); side *= 2) {
    context.progress(fmt::format("{}, side {}", one.engine, side));
    const HeightField field =
        fractal_field(side, thesis_cell, side * thesis_cell / 5.0, context.seed() + 10, threads);
    const ShadowWork work = cast_by(one.engine, field, suns, threads).work;
    const std::string name = fmt::format("{}/{}/", one.engine, side);
    context.record(name + "side", std::int64_t{side}, "vertices");
    context.record(name + "work", whole(work.samples + work.blocks));
    curve.x.push_back(side);
    curve.y.push_back(static_cast<double>(work.samples + work.blocks));
  }
  curves.push_back(curve);
}

void run(ExperimentContext& context) {
  std::vector<PlotCurve> curves;
  for (const Counted& one : counted) record_engine(context, one, curves);
  add_plot(context, "work",
           {.title = "Work of shadow engines",
            .description = "What each engine looks at, against the side of the map.",
            .panels = {{.curves = curves,
                        .x_label = "side (vertices)",
                        .y_label = "heights and summaries looked at",
                        .log_x = true,
                        .log_y = true}}});
}

}  // namespace

extern const ExperimentDescriptor shadow_work;
constinit const ExperimentDescriptor shadow_work{
    .id = "lesser2019/shadow-work",
    .question = "How does the work of shadow engines grow with the size of the map?",
    .source = "[Lesser2019] sec. 9.2.2",
    .seconds = {0.2, 2.0, 20.0},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
