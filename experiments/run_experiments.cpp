// SPDX-License-Identifier: MIT
#include "experiments/run_experiments.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/record/environment.hpp"

namespace phytobench {

namespace {

double seconds_since(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// One run must not mix what two programs, machines or thread counts measured.
void refuse_other_origin(const std::filesystem::path& folder, const std::string& environment) {
  const std::string difference = difference_of_origin(read_environment(folder), environment);
  if (!difference.empty())
    throw InputError(folder.string() + ": was begun otherwise (" + difference +
                     "); resume with the same, or use another --out");
}

/// Runs what is open, one after the other.
class Runner {
 public:
  Runner(const RunRequest& request, RunWriter& writer, RunPlan plan)
      : request_(request), writer_(writer), plan_(std::move(plan)) {}

  RunSummary run() {
    summary_.skipped = plan_.complete.size();
    while (summary_.finished.size() < plan_.open.size()) run_next();
    summary_.seconds = seconds_since(start_);
    return std::move(summary_);
  }

 private:
  std::size_t done() const { return summary_.skipped + summary_.finished.size(); }
  std::size_t all() const { return plan_.complete.size() + plan_.open.size(); }

  void run_next() {
    const ExperimentDescriptor& experiment = *plan_.open[summary_.finished.size()];
    const std::string id(experiment.id);
    ExperimentContext context(id, request_.header.tier, request_.header.seed, request_.threads);
    start_of_running_ = std::chrono::steady_clock::now();
    if (request_.show_progress)
      context.show_progress = [&](const std::string& what) {
        request_.show_progress(place_of(experiment) + ": " + what);
      };
    context.is_interrupted = request_.is_interrupted;
    const ExperimentCost cost = measure(experiment, context);
    for (const ExperimentContext::Artifact& artifact : context.artifacts())
      writer_.write_artifact(id, artifact.name, artifact.content);
    writer_.append(id, context.records(), context.timings());
    plan_.estimate.learn(experiment, cost.seconds);
    summary_.finished.push_back({&experiment, cost});
  }

  ExperimentCost measure(const ExperimentDescriptor& experiment, ExperimentContext& context) {
    const CostMeter meter;
    try {
      context.progress("starting");
      experiment.run(context);
    } catch (const Interrupted&) {
      throw Interrupted(
          fmt::format("{} of {} experiments are finished and kept, go on with the same command "
                      "and --resume",
                      done(), all()));
    }
    const ExperimentCost cost = meter.cost();
    context.timing("cost/seconds", 0, 0, cost.seconds);
    if (cost.peak_memory_mib)
      context.timing({.experiment = {},
                      .measurement = "cost/peak_memory",
                      .value = *cost.peak_memory_mib,
                      .threads = request_.threads,
                      .unit = "MiB"});
    return cost;
  }

  /// "[3/57] 65 s elapsed, about 12 min left: brzoska2019/table-1".
  std::string place_of(const ExperimentDescriptor& experiment) const {
    const auto after = static_cast<std::ptrdiff_t>(summary_.finished.size() + 1);
    const std::vector<const ExperimentDescriptor*> rest(plan_.open.begin() + after,
                                                        plan_.open.end());
    double left =
        plan_.estimate.seconds_of(rest) +
        std::max(0.0, plan_.estimate.seconds_of(experiment) - seconds_since(start_of_running_));
    if (left > 100.0) left = 60.0 * std::ceil(left / 60.0);  // nobody knows the seconds
    return fmt::format("[{}/{}] {} elapsed, about {} left: {}", done() + 1, all(),
                       shown_duration(std::floor(seconds_since(start_))),
                       shown_duration(std::ceil(left)), experiment.id);
  }

  const RunRequest& request_;
  RunWriter& writer_;
  RunPlan plan_;
  RunSummary summary_;
  std::chrono::steady_clock::time_point start_ = std::chrono::steady_clock::now();
  std::chrono::steady_clock::time_point start_of_running_ = start_;
};

}  // namespace

RunSummary run_experiments(const RunRequest& request) {
  const std::string environment =
      environment_json(request.command_line, request.header.seed, request.threads);
  if (request.mode == RunMode::resume) refuse_other_origin(request.folder, environment);
  RunWriter writer(request.folder, request.header, request.mode);
  RunPlan plan = plan_run_in(request.folder, request.experiments, request.header);
  if (request.announce) request.announce(plan);
  if (!plan.open.empty()) writer.write_environment(environment);
  return Runner(request, writer, std::move(plan)).run();
}

}  // namespace phytobench
