// SPDX-License-Identifier: MIT
#include "reports/report_input.hpp"

#include <set>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "reports/run_labels.hpp"

namespace phytobench {

namespace {

namespace fs = std::filesystem;

/// A run's folder and its sealed artifacts.
struct RunArtifacts {
  const fs::path& run_folder;
  const std::set<std::string>& names;
};

/// Adds artifacts with that extension, by their path below artifacts/; those that are there stay.
void add_artifacts(std::map<std::string, Picture>& pictures, const RunArtifacts& run,
                   std::string_view extension) {
  for (const std::string& name : run.names) {
    const fs::path file = run.run_folder / "artifacts" / name;
    if (file.extension() == extension && !is_full_size(file) && !pictures.contains(name))
      pictures[name] = {file, read_text_file(file)};
  }
}

/// All that a run left to be shown; plots that it left as data are drawn.
void add_pictures(ReportInput& input, const RunArtifacts& run) {
  add_artifacts(input.drawings, run, ".svg");
  add_artifacts(input.photographs, run, ".jpg");
  for (auto& [name, plot] : artifact_plots(run.run_folder, run.names)) {
    input.captions.try_emplace(name, std::move(plot.caption));
    if (!plot.svg.empty()) input.drawings.try_emplace(name, Picture{{}, std::move(plot.svg)});
    input.plot_data.try_emplace(plot.data_name, Picture{plot.data_file, std::move(plot.data)});
  }
}

/// The same run counted twice would seem to confirm itself. Equal records are no sign of it, since
/// they are the same on every machine; an equal environment is, as it holds date and load.
void refuse_same_run(const ReportInput& input) {
  for (std::size_t i = 0; i < input.run_folders.size(); ++i)
    for (std::size_t j = 0; j < i; ++j) {
      const fs::path &first = input.run_folders[j], &second = input.run_folders[i];
      const bool same_folder = fs::equivalent(first, second);
      const bool copied =
          input.environments[i] != "{}" && input.environments[i] == input.environments[j];
      if (!same_folder && !copied) continue;
      throw InputError(second.string() + ": is the same run as " + first.string() +
                       (same_folder ? "" : ", copied (equal environment.json)") +
                       "; name each run once");
    }
}

std::vector<std::string> labels_of(const ReportInput& input, bool without_varying) {
  std::vector<RunOrigin> origins;
  for (std::size_t i = 0; i < input.run_folders.size(); ++i)
    origins.push_back({input.environments[i], input.run_folders[i].string()});
  std::vector<std::string> labels = run_labels(origins);
  for (std::size_t i = 0; without_varying && i < labels.size(); ++i)
    labels[i] = "run " + std::to_string(i + 1);
  return labels;
}

/// The experiments that break off in one of the runs, the last run's first.
std::vector<std::string> unfinished_in(const std::vector<LabelledRun>& runs) {
  std::vector<std::string> unfinished;
  for (auto run = runs.rbegin(); run != runs.rend(); ++run)
    if (run->judged.run.unfinished) unfinished.push_back(*run->judged.run.unfinished);
  return unfinished;
}

}  // namespace

ReportInput read_report_input(const std::vector<fs::path>& run_folders,
                              const ReportInputOptions& options) {
  PHYTOBENCH_EXPECT(!run_folders.empty());
  ReportInput input;
  input.run_folders = run_folders;
  std::vector<RunContents> contents;
  for (const fs::path& folder : run_folders) {
    contents.push_back(read_run(folder));
    input.environments.push_back(read_environment(folder));
    if (options.pictures) add_pictures(input, {folder, contents.back().artifacts});
  }
  if (run_folders.size() == 1) {
    input.judged = judge_run(std::move(contents.front()));
    return input;
  }
  refuse_same_run(input);
  const std::vector<std::string> labels = labels_of(input, options.without_varying);
  std::vector<LabelledRun> runs;
  for (std::size_t i = 0; i < contents.size(); ++i)
    runs.push_back({labels[i], judge_run(std::move(contents[i])), input.run_folders[i].string()});
  const std::vector<std::string> unfinished = unfinished_in(runs);
  MergedRuns merged = merge_runs(std::move(runs));
  for (const std::string& experiment : unfinished)
    if (!merged.judged.run.complete_experiments.contains(experiment))
      merged.judged.run.unfinished = experiment;
  input.judged = std::move(merged.judged);
  input.comparison = std::move(merged.comparison);
  return input;
}

}  // namespace phytobench
