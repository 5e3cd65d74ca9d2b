// SPDX-License-Identifier: MIT
// The thesis' test tree at other sizes, grown with every engine: how time, work and memory grow
// with the number of attraction points, and how far each engine is from the pairs that any exact
// method must look at. Every answer is judged before anything is timed.
#include <algorithm>

#include <fmt/format.h>

#include "benchmarks/nearest_node/race.hpp"
#include "core/contract/errors.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

RecordValue whole(std::uint64_t count) {
  return static_cast<std::int64_t>(count);
}

/// Which engine is grown at which size.
class Field {
 public:
  explicit Field(const TomlTable& table)
      : table_(table), most_points_(table.table("most_points")) {}

  std::vector<Contestant> at(double points) const {
    std::vector<Contestant> field;
    for (const EngineDescriptor* engine : all_engines())
      if (engine->built() && points <= most_points(std::string(engine->name)))
        field.push_back({.engine = engine, .option = table_.text("option")});
    for (const TomlTable& extra : table_.tables("extra")) {
      const Contestant contestant{.engine = &engine_named(extra.text("engine")),
                                  .option = extra.text("option"),
                                  .threads = static_cast<int>(extra.number("threads"))};
      if (extra.number("points") == points && contestant.engine->built())
        field.push_back(contestant);
    }
    return field;
  }

 private:
  double most_points(const std::string& engine) const {
    return most_points_.number(most_points_.has(engine) ? engine : "others");
  }

  TomlTable table_;
  TomlTable most_points_;
};

/// "25298/voxel_grid.dn", and "1000000/node_driven.dn.2-threads".
std::string path_of(double points, const Contestant& contestant) {
  std::string path =
      fmt::format("{:.0f}/{}.{}", points, contestant.engine->name, contestant.option);
  if (contestant.threads > 1) path += fmt::format(".{}-threads", contestant.threads);
  return path;
}

void record_workload(ExperimentContext& context, double points, const Workload& workload,
                     const RaceResult& result) {
  const auto record = [&](const char* name, std::uint64_t value) {
    context.record(fmt::format("{:.0f}/{}", points, name), whole(value));
  };
  record("points", workload.seedling.attraction_points.size());
  record("nodes", result.nodes);
  record("iterations", result.iterations);
  record("floor/association_pairs", result.floor.association);
  record("floor/removal_pairs", result.floor.removal);
}

void record_entry(ExperimentContext& context, const std::string& path, const RaceEntry& entry) {
  const bool exact = entry.disagreement.empty();
  context.record(path + "/exact", whole(exact));
  if (!exact) {
    context.record(path + "/disagreement", entry.disagreement, "text");
    return;
  }
  context.record(path + "/tree_hash", entry.tree_hash);
  context.record(path + "/search_evaluations", whole(entry.work.search_evaluations));
  context.record(path + "/kill_evaluations", whole(entry.work.kill_evaluations));
  context.record(path + "/evaluations",
                 whole(entry.work.search_evaluations + entry.work.kill_evaluations));
  context.record(path + "/cells_visited", whole(entry.work.cells_visited));
  context.record(path + "/index_updates", whole(entry.work.index_updates));
}

/// What is not the same in every run.
void time_entry(ExperimentContext& context, const std::string& path, const RaceEntry& entry,
                double points) {
  const auto sample = [&](const char* name, std::size_t round, double value) {
    if (value > 0.0)
      context.timing({.experiment = {},
                      .measurement = path + "/" + name,
                      .round = static_cast<std::int64_t>(round),
                      .value = value,
                      .threads = entry.threads});
  };
  for (std::size_t round = 0; round < entry.rounds.size(); ++round) {
    const PhaseSeconds& seconds = entry.rounds[round];
    sample("seconds", round, seconds.total);
    sample("build_seconds", round, reset_seconds(seconds));
    sample("association_seconds", round, seconds.association);
    sample("kill_seconds", round, seconds.kill);
    sample("growth_seconds", round, seconds.growth);
  }
  if (entry.bytes_per_point > 0.0)
    context.timing({.experiment = {},
                    .measurement = path + "/bytes",
                    .value = entry.bytes_per_point * points,
                    .threads = entry.threads,
                    .unit = "B"});
}

/// With fewer than six rounds an interval of a median says nothing at 95 %.
int least_rounds(const TomlTable& table, double points) {
  const std::vector<double> decided = table.numbers("decided");
  return std::ranges::find(decided, points) == decided.end() ? 3 : 6;
}

void measure(ExperimentContext& context, double points, std::vector<Contestant> contestants,
             int rounds) {
  const Workload workload = scaled_test_tree({.points = points});
  const bool timed = context.tier() != Tier::smoke;
  const RaceResult result = race({
      .workload = &workload,
      .contestants = std::move(contestants),
      .budget_s = std::numeric_limits<double>::infinity(),
      .measure_time = timed,
      .timing_s = context.tier() == Tier::full ? 60.0 : 5.0,
      .least_rounds = rounds,
      .order_seed = context.seed(),
      .replay_s = timed ? 60.0 : 0.0,
      .show_progress =
          [&](const std::string& what) {
            context.progress(fmt::format("{:.0f} points: {}", points, what));
          },
  });
  record_workload(context, points, workload, result);
  for (const RaceEntry& entry : result.entries) {
    const std::string path = path_of(points, entry);
    record_entry(context, path, entry);
    time_entry(context, path, entry,
               static_cast<double>(workload.seedling.attraction_points.size()));
  }
}

void run(ExperimentContext& context) {
  const TomlTable table = thesis_parameters().table("scaling");
  const Field field(table);
  for (const double points : table.numbers(std::string(name_of(context.tier()))))
    measure(context, points, field.at(points), least_rounds(table, points));
}

}  // namespace

extern const ExperimentDescriptor scaling;
constinit const ExperimentDescriptor scaling{
    .id = "brzoska2019/scaling",
    .question =
        "How do time, work and memory of every engine grow with the number of attraction points?",
    .source = "[Brzoska2019] figure 51, scaled; sec. 5.2.2",
    .seconds = {1, 25, 1900},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
