// SPDX-License-Identifier: MIT
// Figure 46 shows one tree with three seeds, two of which are not published. Every seed's counts
// are written down; only the judge compares them with the printed ones.
#include <map>

#include <fmt/format.h>

#include "core/nearest_node/engine_registry.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/tree/branches.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// The seeds that the 2019 program can draw.
constexpr std::size_t all_seeds = 65'335;

std::size_t seeds_of(Tier tier) {
  return tier == Tier::full ? all_seeds : tier == Tier::quick ? 512 : 32;
}

struct Counts {
  std::size_t vertices, triangles;
};

/// Vertices and triangles without leaves, counted instead of meshed.
Counts counts_of(const Skeleton& tree, const PlantParameters& look) {
  const std::vector<double> radii = branch_radii(tree, look.tip_radius, look.radius_exponent);
  std::size_t duplicates = 0;
  for (std::size_t node = 1; node < tree.node_count(); ++node)
    duplicates += needs_own_ring(radii[node], radii[static_cast<std::size_t>(tree.parents()[node])],
                                 look.branches.duplicate_ratio);
  const auto corners = static_cast<std::size_t>(look.branches.circle_resolution);
  return {(corners + 1) * (tree.node_count() + duplicates), 2 * corners * tree.edge_count()};
}

void count_seeds(TreeParameters parameters, std::size_t first, std::span<Counts> counts) {
  const auto engine = engine_named("node_driven").create();
  for (std::size_t i = 0; i < counts.size(); ++i) {
    parameters.seed = first + i;
    const GrowthResult grown =
        grow_crown(make_seedling(parameters), *engine,
                   {.options = loop_options_named("dn"), .count_work = false});
    counts[i] = counts_of(grown.skeleton, parameters.plant);
  }
}

void run(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-46-left");
  std::vector<Counts> counts(seeds_of(context.tier()));
  constexpr std::size_t batch = 512, chunk = 16;
  for (std::size_t first = 0; first < counts.size(); first += batch) {
    context.progress(fmt::format("seed {} of {}", first, counts.size()));
    const std::size_t end = std::min(first + batch, counts.size());
    for_tasks((end - first + chunk - 1) / chunk, context.untimed_threads(), [&](std::size_t task) {
      const std::size_t begin = first + task * chunk;
      count_seeds(parameters, begin,
                  std::span(counts).subspan(begin, std::min(chunk, end - begin)));
    });
  }
  // A sample must not be taken for the whole: it has another name.
  const char* const name = context.tier() == Tier::full ? "seeds" : "sample";
  std::map<std::pair<std::size_t, std::size_t>, double> multiplicity;
  for (std::size_t seed = 0; seed < counts.size(); ++seed) {
    const auto [vertices, triangles] = counts[seed];
    ++multiplicity[{vertices, triangles}];
    context.record({.experiment = {},
                    .measurement = fmt::format("{}/{:05}", name, seed),
                    .value = fmt::format("{} {}", vertices, triangles),
                    .unit = "vertices triangles",
                    .seed = seed});
  }
  double shared = 0.0;
  for (const auto& [pair, times] : multiplicity) shared += times * (times - 1.0);
  context.record("tried", static_cast<std::int64_t>(counts.size()));
  context.record("different_pairs", static_cast<std::int64_t>(multiplicity.size()));
  // How many other seeds have the counts of a seed: what to expect by accident.
  context.record("accidental_hits", shared / static_cast<double>(counts.size()));
}

}  // namespace

extern const ExperimentDescriptor seed_search;
constinit const ExperimentDescriptor seed_search{
    .id = "brzoska2019/seed-search",
    .question = "Which seeds give the tree of figure 46 which numbers of vertices and triangles?",
    .source = "[Brzoska2019] fig. 46 and appendix table",
    .seconds = {1, 3, 160},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
