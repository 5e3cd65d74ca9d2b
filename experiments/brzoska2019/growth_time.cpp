// SPDX-License-Identifier: MIT
// How the time to grow a tree rises with its number of nodes, over the trees of the appendix table,
// and whether a tree's mesh takes longer than its growth. Both engines must grow the same trees
// before anything is timed; then all trees are grown in turn, in a new random order every round.
#include <chrono>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/random/counter_stream.hpp"
#include "core/tree/branches.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// A tree and the engine to grow it with.
struct Task {
  std::string name;  ///< "figure-51/voxel_grid.dn"
  const EngineDescriptor* engine;
  LoopOptions options;
  Seedling seedling;
};

std::vector<Task> tasks_of(const TomlTable& table) {
  std::vector<Task> tasks;
  for (const std::string& row : table.texts("rows"))
    for (const TomlTable& how : table.tables("engine")) {
      const std::string option = how.text("option");
      tasks.push_back({.name = fmt::format("{}/{}.{}", row, how.text("name"), option),
                       .engine = &engine_named(how.text("name")),
                       .options = loop_options_named(option),
                       .seedling = make_seedling(thesis_tree(row))});
    }
  return tasks;
}

GrowthResult grow(const Task& task) {
  return grow_crown(task.seedling, *task.engine->create(),
                    {.options = task.options, .count_work = false});
}

void record_trees(ExperimentContext& context, const std::vector<Task>& tasks) {
  for (const Task& task : tasks) {
    context.progress("growing " + task.name);
    const GrowthResult result = grow(task);
    context.record(task.name + "/nodes", whole(result.skeleton.node_count()));
    context.record(task.name + "/points", whole(task.seedling.attraction_points.size()));
    context.record(task.name + "/tree_hash", tree_hash(result.skeleton));
  }
}

template <class Work>
double seconds_of(const Work& work) {
  const auto begin = std::chrono::steady_clock::now();
  work();
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - begin).count();
}

void time_growth(ExperimentContext& context, const std::vector<Task>& tasks, int rounds) {
  CounterStream stream(context.seed(), 0);
  for (int round = 0; round < rounds; ++round) {
    context.progress(fmt::format("round {} of {}", round + 1, rounds));
    std::int64_t position = 0;
    for (const std::size_t i : random_order(tasks.size(), stream)) {  // never after the same one
      grow(tasks[i]);  // once untimed: the tree before has filled caches and memory with its own
      context.timing(tasks[i].name + "/seconds", round, position++, grow(tasks[i]).seconds.total);
    }
  }
}

/// Everything from a grown skeleton to triangles, beside the growth of the same tree.
void time_meshes(ExperimentContext& context, const std::string& row, int rounds) {
  const TreeParameters parameters = thesis_tree(row);
  const Task task{.name = "mesh/" + row,
                  .engine = &engine_named("node_driven"),
                  .options = loop_options_named("dn"),
                  .seedling = make_seedling(parameters)};
  const Skeleton skeleton = grow(task).skeleton;
  const auto mesh = [&] { return make_plant(skeleton, parameters.plant).vertex_count(); };
  const std::size_t expected = mesh();
  context.record(task.name + "/vertices", whole(expected));
  for (int round = 0; round < rounds; ++round) {
    context.progress(fmt::format("{}: round {} of {}", task.name, round + 1, rounds));
    grow(task);  // each once untimed: the other has left its own in caches and memory
    context.timing(task.name + "/growth_seconds", round, 0, grow(task).seconds.total);
    mesh();
    std::size_t vertices = 0;
    context.timing(task.name + "/seconds", round, 1, seconds_of([&] { vertices = mesh(); }));
    PHYTOBENCH_EXPECT(vertices == expected);
  }
}

void run(ExperimentContext& context) {
  const TomlTable table = thesis_parameters().table("growth-time");
  const std::vector<Task> tasks = tasks_of(table);
  record_trees(context, tasks);
  const int rounds = context.tier() == Tier::smoke ? 0 : context.tier() == Tier::quick ? 9 : 25;
  time_growth(context, tasks, rounds);
  time_meshes(context, table.text("mesh"), 3 * rounds);
}

}  // namespace

extern const ExperimentDescriptor growth_time;
constinit const ExperimentDescriptor growth_time{
    .id = "brzoska2019/growth-time",
    .question = "How does the time to grow and to mesh a tree rise with its nodes?",
    .source = "[Brzoska2019] appendix table, sec. 6.1.2",
    .seconds = {3, 15, 120},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
