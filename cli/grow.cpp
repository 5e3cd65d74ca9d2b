// SPDX-License-Identifier: MIT
#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "cli/commands.hpp"
#include "cli/terminal.hpp"
#include "core/colonization/tree_parameters_file.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/skeleton_svg.hpp"

namespace phytobench::cli {

namespace {

using nlohmann::ordered_json;

ordered_json summary(const GrowOptions& options, const TreeParameters& parameters,
                     const Seedling& seedling, const GrowthResult& result) {
  const Skeleton& tree = result.skeleton;
  ordered_json json;
  json["schema"] = "phytobench/grow-1";
  json["config"] = options.config;
  json["seed"] = parameters.seed;
  json["random"] = name_of(parameters.random);
  json["engine"] = options.engine;
  json["option"] = options.option;
  json["attraction_points"] = seedling.attraction_points.size();
  json["live_points"] = result.live_points;
  json["iterations"] = result.passes.size();
  json["stop_reason"] = name_of(result.stop_reason);
  json["nodes"] = tree.node_count();
  json["edges"] = tree.edge_count();
  json["tips"] = tip_count(tree);
  json["edge_depth"] = edge_depth(tree);
  json["highest_y"] = highest_y(tree);
  json["tree_hash"] = tree_hash(tree);
  json["work"] = {{"search_evaluations", result.work.search_evaluations},
                  {"kill_evaluations", result.work.kill_evaluations},
                  {"queries", result.work.queries},
                  {"cells_visited", result.work.cells_visited},
                  {"index_updates", result.work.index_updates}};
  return json;
}

std::string plain_summary(const ordered_json& json) {
  std::string text;
  for (const char* key : {"attraction_points", "live_points", "iterations", "stop_reason", "nodes",
                          "edges", "tips", "edge_depth", "highest_y", "tree_hash"})
    text += fmt::format("{:<18} {}\n", key,
                        json[key].is_string() ? json[key].get<std::string>() : json[key].dump());
  return text;
}

bool report_iteration(const PassStatistics& pass) {
  show_progress(fmt::format("iteration {}: {} nodes, {} live points", pass.iteration + 1,
                            pass.searchable_nodes + pass.new_nodes, pass.live_points));
  return !is_interrupted();
}

}  // namespace

int grow(const GrowOptions& options) {
  if (options.example) {
    print(example_tree_file());
    return 0;
  }
  if (options.config.empty())
    throw InputError(
        "grow needs a parameter file; phytobench grow --example prints one to start from");
  if (options.picture == options.config)
    throw InputError("--picture " + options.picture +
                     " would overwrite the parameter file; name another");
  const TreeParameters parameters = read_tree_parameters(options.config);
  const LoopOptions loop = loop_options_named(options.option);
  const auto engine = engine_named(options.engine).create();
  const Seedling seedling = make_seedling(parameters);
  catch_interrupts();  // from here on there are iterations to stop between
  const GrowthResult result =
      grow_crown(seedling, *engine,
                 {.options = loop, .threads = options.threads, .observer = report_iteration});
  if (result.stop_reason == StopReason::interrupted) throw Interrupted();
  if (result.skeleton.node_count() == seedling.skeleton.node_count())
    throw InputError(options.config + ": " + why_growth_cannot_start(seedling));
  if (!options.picture.empty())
    write_file_atomically(options.picture,
                          skeleton_svg(result.skeleton, "Tree grown from " + options.config));
  const ordered_json json = summary(options, parameters, seedling, result);
  print(options.json ? json.dump(2) + "\n" : plain_summary(json));
  return 0;
}

}  // namespace phytobench::cli
