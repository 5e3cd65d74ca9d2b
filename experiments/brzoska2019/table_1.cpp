// SPDX-License-Identifier: MIT
// [Brzoska2019] Table 1: the thesis' test tree grown with four ways to find the nearest node, each
// with the loop options S, D, N and D&N. Work is counted and compared with the literal oracle
// first; only then are the sixteen cells timed, in a new random order every round.
#include <set>

#include <fmt/format.h>

#include "benchmarks/nearest_node/checked_growth.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"
#include "core/tree/skeleton_svg.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct Cell {
  std::string name;  ///< "euclid.s"
  const EngineDescriptor* engine;
  GrowthRun run;
};

std::vector<Cell> table_cells(int threads) {
  const TomlTable table = thesis_parameters().table("table-1");
  const std::vector<std::string> rows = table.texts("rows");
  const std::vector<std::string> engines = table.texts("engines");
  std::vector<Cell> cells;
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (const std::string& column : table.texts("columns"))
      cells.push_back({rows[row] + "." + column,
                       &engine_named(engines.at(row)),
                       {.options = loop_options_named(column), .threads = threads}});
  return cells;
}

RecordValue whole(std::uint64_t count) {
  return static_cast<std::int64_t>(count);
}

void record_work(ExperimentContext& context, const Cell& cell, const GrowthResult& result) {
  const auto name = [&](const char* quantity) { return cell.name + "/" + quantity; };
  const WorkCounters& work = result.work;
  context.record(name("edges"), whole(result.skeleton.edge_count()));
  context.record(name("iterations"), whole(result.passes.size()));
  context.record(name("tree_hash"), tree_hash(result.skeleton));
  context.record(name("search_evaluations"), whole(work.search_evaluations));
  context.record(name("kill_evaluations"), whole(work.kill_evaluations));
  context.record(name("evaluations"), whole(work.search_evaluations + work.kill_evaluations));
  context.record(name("queries"), whole(work.queries));
  context.record(name("cells_visited"), whole(work.cells_visited));
  context.record(name("index_updates"), whole(work.index_updates));
  if (counts_inner_loop) context.record(name("angle_tests"), whole(work.angle_tests));
}

/// One line per iteration and loop option of the plain scan: the sums of the report, pass by pass.
std::string passes_csv(const std::vector<std::pair<std::string, GrowthResult>>& scans) {
  std::string csv =
      "option,iteration,live_points,searchable_nodes,queried_points,associated_points,new_nodes,"
      "suppressed_repeats,removed_points,search_evaluations,kill_evaluations\n";
  for (const auto& [name, result] : scans)
    for (const PassStatistics& pass : result.passes)
      csv += fmt::format("{},{},{},{},{},{},{},{},{},{},{}\n", name, pass.iteration,
                         pass.live_points, pass.searchable_nodes, pass.queried_points,
                         pass.associated_points, pass.new_nodes, pass.suppressed_repeats,
                         pass.removed_points, pass.search_evaluations, pass.kill_evaluations);
  return csv;
}

/// A cell that agrees with the oracle, and so may be timed.
struct VerifiedCell {
  std::string name;
  VerifiedRun run;
};

/// Compares every cell with the oracle and records its work. Returns the cells that agree.
std::vector<VerifiedCell> check_cells(ExperimentContext& context, const Seedling& seedling,
                                      const GrowthOracle& oracle) {
  std::vector<VerifiedCell> verified;
  std::vector<std::pair<std::string, GrowthResult>> scans;
  std::set<std::string> trees;
  for (const Cell& cell : table_cells(context.threads())) {
    context.progress("checking " + cell.name);
    const CheckedGrowth checked = grow_checked(*cell.engine, seedling, oracle, cell.run);
    context.record(cell.name + "/exact", whole(checked.verified ? 1 : 0));
    if (!checked.verified) {
      context.record(cell.name + "/disagreement", checked.disagreement, "text");
      continue;
    }
    record_work(context, cell, checked.result);
    trees.insert(tree_hash(checked.result.skeleton));
    if (cell.name.starts_with("squared.")) scans.emplace_back(cell.name, checked.result);
    verified.push_back({cell.name, *checked.verified});
  }
  context.record("distinct_trees", whole(trees.size()));
  context.artifact("passes.csv", passes_csv(scans));
  return verified;
}

int timing_rounds(Tier tier) {
  switch (tier) {
    case Tier::smoke:
      return 0;
    case Tier::quick:
      return 9;
    case Tier::full:
      return 25;
  }
  return 0;
}

void time_cells(ExperimentContext& context, const std::vector<VerifiedCell>& cells) {
  const int rounds = timing_rounds(context.tier());
  for (int round = 0; round < rounds; ++round) {
    CounterStream stream(context.seed(), static_cast<std::uint64_t>(round));
    const std::vector<std::size_t> order = random_order(cells.size(), stream);
    for (std::size_t position = 0; position < order.size(); ++position) {
      const VerifiedCell& cell = cells[order[position]];
      context.progress(fmt::format("round {}/{}: timing {}", round + 1, rounds, cell.name));
      const PhaseSeconds seconds = cell.run.grow().seconds;
      const auto place = static_cast<std::int64_t>(position);
      context.timing(cell.name + "/seconds", round, place, seconds.total);
      context.timing(cell.name + "/association_seconds", round, place, seconds.association);
      context.timing(cell.name + "/kill_seconds", round, place, seconds.kill);
      context.timing(cell.name + "/growth_seconds", round, place, seconds.growth);
    }
  }
}

void run(ExperimentContext& context) {
  context.progress("growing the literal oracle's tree");
  const TreeParameters parameters = thesis_tree("figure-51");
  const Seedling seedling = make_seedling(parameters);
  const GrowthOracle oracle(seedling);
  context.record({.experiment = {},
                  .measurement = "points",
                  .value = whole(seedling.attraction_points.size()),
                  .seed = parameters.seed});
  context.record("tropism_weight", seedling.growth.tropism.y);
  context.record("oracle/tree_hash", oracle.hash());

  const std::vector<VerifiedCell> verified = check_cells(context, seedling, oracle);
  const auto engine = engine_named("voxel_grid").create();
  const GrowthResult tree = grow_crown(seedling, *engine);
  context.record("nodes", whole(tree.skeleton.node_count()));
  context.record("tips", whole(tip_count(tree.skeleton)));
  std::size_t repeats = 0;
  for (const PassStatistics& pass : tree.passes) repeats += pass.suppressed_repeats;
  context.record("suppressed_repeats", whole(repeats));
  context.artifact("tree.svg",
                   skeleton_svg(tree.skeleton, "Test tree of Table 1 (figure 51), bare skeleton"));

  time_cells(context, verified);
}

}  // namespace

extern const ExperimentDescriptor table_1;
constinit const ExperimentDescriptor table_1{
    .id = "brzoska2019/table-1",
    .question =
        "Which way to find the nearest node, with which loop option, grows the test tree fastest?",
    .source = "[Brzoska2019] sec. 5.2.2, Table 1",
    .seconds = {10, 80, 200},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
