// SPDX-License-Identifier: MIT
// Sec. 6: parameters given at some times and interpolated between them.
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

/// A stem that grows, stands and shrinks while it bears more and more hairs.
ComponentGraph growing(double time) {
  ComponentGraph graph = graph_of(
      "[graph]\nroot = \"stem\"\n[component.stem]\nkind = \"horn\"\n"
      "length = { frames = [{ time = 1, value = 0.5 }, { time = 5, value = 2.5 }, "
      "{ time = 9, value = 0.1 }] }\n[component.fan]\nkind = \"hydra\"\n"
      "count = { frames = [{ time = 1, value = 0 }, { time = 9, value = 8 }] }\n"
      "[component.hair]\nkind = \"horn\"\n[[link]]\nfrom = \"stem\"\nto = \"fan\"\n"
      "[[link]]\nfrom = \"fan\"\nto = \"hair\"\n");
  graph.time = time;
  return graph;
}

double stem_length(double time) {
  ComponentGraph graph = growing(time);
  graph.links.clear();
  double highest = 0.0;
  for (const Vector3& place : positions_of(graph)) highest = std::fmax(highest, place.y);
  return highest;
}

void run(ExperimentContext& context) {
  for (const double time : {0.0, 1.0, 2.0, 3.0, 5.0, 6.0, 9.0, 20.0}) {
    const std::string name = fmt::format("time-{:.0f}/", time);
    context.record(name + "length", stem_length(time), "length");
    context.record(name + "hairs", instances_by_name(growing(time)).at("hair"));
  }
}

}  // namespace

extern const ExperimentDescriptor key_frames;
constinit const ExperimentDescriptor key_frames{
    .id = "lintermann1997/key-frames",
    .question = "What are parameters between the times at which they are given?",
    .source = "[Lintermann1997] sec. 6",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
