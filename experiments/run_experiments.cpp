// SPDX-License-Identifier: MIT
#include "experiments/run_experiments.hpp"

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/record/environment.hpp"

namespace phytobench {

double expected_seconds(const std::vector<const ExperimentDescriptor*>& experiments, Tier tier) {
  double seconds = 0.0;
  for (const ExperimentDescriptor* experiment : experiments)
    seconds += experiment->seconds[static_cast<std::size_t>(tier)];
  return seconds;
}

namespace {

/// One run must not mix what two programs, machines or thread counts measured.
void refuse_other_origin(const std::filesystem::path& folder, const std::string& environment) {
  const std::string difference = difference_of_origin(read_environment(folder), environment);
  if (!difference.empty())
    throw InputError(folder.string() + ": was begun otherwise (" + difference +
                     "); resume with the same, or use another --out");
}

}  // namespace

void run_experiments(const RunRequest& request) {
  const std::string environment =
      environment_json(request.command_line, request.header.seed, request.threads);
  if (request.mode == RunMode::resume) refuse_other_origin(request.folder, environment);
  RunWriter writer(request.folder, request.header, request.mode);
  std::vector<const ExperimentDescriptor*> open;
  for (const ExperimentDescriptor* experiment : request.experiments)
    if (!writer.is_complete(std::string(experiment->id))) open.push_back(experiment);
  if (!open.empty()) writer.write_environment(environment);

  for (std::size_t i = 0; i < open.size(); ++i) {
    const ExperimentDescriptor& experiment = *open[i];
    const std::vector<const ExperimentDescriptor*> left(
        open.begin() + static_cast<std::ptrdiff_t>(i), open.end());
    const std::string place =
        fmt::format("[{}/{}, about {:.0f} s left] {}", i + 1, open.size(),
                    expected_seconds(left, request.header.tier), experiment.id);
    ExperimentContext context(std::string(experiment.id), request.header.tier, request.header.seed,
                              request.threads);
    if (request.show_progress)
      context.show_progress = [&](const std::string& what) {
        request.show_progress(place + ": " + what);
      };
    context.is_interrupted = request.is_interrupted;
    context.progress("starting");
    experiment.run(context);
    for (const ExperimentContext::Artifact& artifact : context.artifacts())
      writer.write_artifact(std::string(experiment.id), artifact.name, artifact.content);
    writer.append(std::string(experiment.id), context.records(), context.timings());
  }
}

}  // namespace phytobench
