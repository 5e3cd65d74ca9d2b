// SPDX-License-Identifier: MIT
// Sec. 5: how many instances the dandelion and the willow have at each step of their making, built
// from the steps of the text alone.
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

struct Part {
  const char* name;
  std::string keys;  ///< its kind first
};

const std::string horn = "kind = \"horn\"", hydra_of_18 = "kind = \"hydra\"\ncount = 18";

/// Each part below the one before, by links of one kind.
ComponentGraph chain(const std::vector<Part>& parts, const char* link) {
  std::string text = fmt::format("[graph]\nroot = \"{}\"\n", parts.front().name);
  for (const Part& part : parts) text += fmt::format("[component.{}]\n{}\n", part.name, part.keys);
  for (std::size_t i = 1; i < parts.size(); ++i)
    text += fmt::format("[[link]]\nfrom = \"{}\"\nto = \"{}\"\nkind = \"{}\"\n", parts[i - 1].name,
                        parts[i].name, link);
  return graph_of(text);
}

std::int64_t total(const ComponentGraph& graph) {
  return static_cast<std::int64_t>(count_instances(graph));
}

void record_dandelion(ExperimentContext& context) {
  context.record("dandelion/a/instances", total(chain({{"hair", horn}}, "child")));
  const ComponentGraph star = chain({{"star", hydra_of_18}, {"hair", horn}}, "child");
  context.record("dandelion/star/hydras", instances_by_name(star).at("star"));
  context.record("dandelion/star/hairs", instances_by_name(star).at("hair"));
  context.record("dandelion/b/instances",
                 total(chain({{"stalk", horn}, {"star", hydra_of_18}, {"hair", horn}}, "child")));
  for (const int umbrellas : {100, 300, 900}) {
    const ComponentGraph ball =
        chain({{"stem", horn},
               {"ball", fmt::format("kind = \"phiball\"\ncount = {}", umbrellas)},
               {"stalk", horn},
               {"star", hydra_of_18},
               {"hair", horn}},
              "child");
    const std::string name = fmt::format("dandelion/c/umbrellas-{}/", umbrellas);
    context.record(name + "instances", total(ball));
    context.record(name + "hairs", instances_by_name(ball).at("hair"));
  }
}

/// The hairs of a star: each is the first one turned about the axis.
void record_star(ExperimentContext& context) {
  const auto hairs = SingleComponent("hydra", "count = 18\ntilt = 60").children(18);
  double smallest = 360.0, greatest = 0.0;
  for (std::size_t i = 0; i < hairs.size(); ++i) {
    const double step = azimuth_step_deg(hairs[i].y, hairs[(i + 1) % hairs.size()].y);
    smallest = std::fmin(smallest, step);
    greatest = std::fmax(greatest, step);
  }
  context.record("dandelion/star/smallest_step", smallest, "degrees");
  context.record("dandelion/star/greatest_step", greatest, "degrees");
}

std::string tree_of(int branches, const std::string& keys = "") {
  return fmt::format("kind = \"tree\"\nbranches = {}\n{}", branches, keys);
}

void record_willow(ExperimentContext& context) {
  const ComponentGraph initial = chain({{"trunk", tree_of(6)}, {"limb", tree_of(9)}}, "branch");
  context.record("willow/a/instances", total(initial));
  const std::string weight = "gravitropism = 90\nlength = 2.5\nbranch_tilt = 70";
  const ComponentGraph bent =
      chain({{"trunk", tree_of(6, "length = 4")}, {"limb", tree_of(9, weight)}}, "branch");
  context.record("willow/b/instances", total(bent));
  context.record("willow/b/distance_of_vertices",
                 greatest_distance(positions_of(initial), positions_of(bent)), "length");
  const ComponentGraph copied =
      chain({{"trunk", tree_of(6)}, {"limb", tree_of(9, weight)}, {"twig", tree_of(5, weight)}},
            "branch");
  context.record("willow/copy/twigs", instances_by_name(copied).at("twig"));
  const ComponentGraph leafy = chain({{"trunk", tree_of(6)},
                                      {"limb", tree_of(9, weight)},
                                      {"twig", tree_of(5, weight)},
                                      {"blade", "kind = \"leaf\""}},
                                     "branch");
  context.record("willow/c/leaves", instances_by_name(leafy).at("blade"));
  // Figure 9 shows the plant without and with leaves: what was there before stays where it was.
  const std::vector<Vector3> naked = positions_of(copied);
  std::vector<Vector3> same = positions_of(leafy);
  context.record("willow/c/more_vertices_than_naked",
                 static_cast<std::int64_t>(same.size() - naked.size()));
  same.resize(naked.size());
  context.record("willow/c/distance_to_naked", greatest_distance(naked, same), "length");
}

void run(ExperimentContext& context) {
  record_dandelion(context);
  record_star(context);
  record_willow(context);
}

}  // namespace

extern const ExperimentDescriptor example_counts;
constinit const ExperimentDescriptor example_counts{
    .id = "lintermann1997/example-counts",
    .question = "How many instances do dandelion and willow have at each step of their making?",
    .source = "[Lintermann1997] sec. 5.1, 5.2",
    .seconds = {0.02, 0.02, 0.02},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
