// SPDX-License-Identifier: MIT
// phytobench compete: options and files in, a population step by step, tables and pictures out.
#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/compete_csv.hpp"
#include "cli/compete_findings.hpp"
#include "cli/compete_folder.hpp"
#include "cli/compete_output.hpp"
#include "cli/compete_start.hpp"
#include "cli/terminal.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/contract/errors.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/population_file.hpp"
#include "core/population/stand_picture.hpp"

namespace phytobench::cli {

namespace {

constexpr int picture_side = 1000;  // pixels
constexpr std::int32_t usual_checkpoint = 100;
constexpr std::size_t most_plants_with_pattern = 20'000;  // unless asked for: it takes time
constexpr std::size_t fewest_plants_with_pattern = 10;    // of fewer, indices are chance

void check_options(const CompeteOptions& options) {
  if (options.config.empty() == options.preset.empty())
    throw InputError(
        options.config.empty()
            ? "compete needs a parameter file or a --preset; phytobench compete --example prints a "
              "file to start from, phytobench list stands lists the presets"
            : "give a parameter file or --preset, not both");
  const std::pair<bool, const char*> needs_folder[] = {
      {options.resume, "--resume"},
      {options.every.has_value(), "--every"},
      {options.frames > 0, "--frames"},
      {options.checkpoint.has_value(), "--checkpoint"}};
  for (const auto& [is_given, option] : needs_folder)
    if (is_given && options.out.empty())
      throw InputError(fmt::format("{} needs --out DIR, the folder of the run", option));
  if (options.frame_format != "png" && options.frame_format != "svg")
    throw InputError("--frame-format " + options.frame_format + ": give png or svg");
}

class CompeteRun {
 public:
  CompeteRun(const CompeteOptions& options, const CompeteStart& start)
      : options_(options), start_(start), reads_above_(reads_crowns(start.parameters)) {
    if (!options.out.empty())
      folder_.emplace(options.out, start.settings, FrameFiles{options.frames, options.frame_format},
                      start.inputs);
    CompeteProgress progress = begun();
    pairs_ = progress.pairs;
    population_.emplace(start.parameters, std::move(progress.state),
                        overlap_engine_named(options.engine), options.threads);
  }

  CompeteFindings finished() {
    // At every turn the files hold what happened before this step.
    for (bool is_first = true;; is_first = false) {
      if (is_interrupted()) stop();
      if (folder_ && !is_first && is_checkpoint_due()) save();
      record();
      if (is_at_end()) break;
      show_progress(fmt::format("step {} of {}: {} plants", state().step, start_.parameters.steps,
                                state().stand.size()));
      const std::uint64_t before = population_->pairs_found();
      population_->step();
      pairs_ += population_->pairs_found() - before;  // those of pictures and tables do not count
    }
    return findings();
  }

  void write(CompeteFindings& findings) {
    if (!folder_) return;
    const bool keeps_checkpoint = options_.checkpoint.has_value();
    std::vector<FileContent> files;
    files.push_back({"plants.csv", plants_csv(findings)});
    if (state().stand.size() <= most_plants_in_svg)
      files.push_back({"stand.svg", picture("svg", findings.last)});
    files.push_back({"stand.png", picture("png", findings.last)});
    std::vector<std::string> names;
    for (const Species& species : start_.parameters.species) names.push_back(species.name);
    files.push_back({"curves.svg", curves_of(folder_->finished_steps(), names)});
    for (const FileContent& file : start_.inputs) findings.files.push_back(file.file.string());
    findings.files.push_back("steps.csv");
    for (const FileContent& file : files) findings.files.push_back(file.file.string());
    findings.files.push_back("summary.json");
    if (options_.frames > 0) findings.files.push_back("frames/");
    if (keeps_checkpoint) findings.files.push_back("checkpoint.bin");
    files.push_back({"summary.json", compete_json(findings, options_)});
    folder_->finish(std::move(files), keeps_checkpoint);
  }

 private:
  static bool reads_crowns(const PopulationParameters& parameters) {
    return competition_rule_named(parameters.rule).uses_above;
  }

  const PopulationState& state() const { return population_->state(); }
  bool is_at_end() const { return state().step >= start_.parameters.steps; }

  CompeteProgress begun() {
    if (options_.resume) return folder_->resume(start_.parameters.steps);
    CompeteProgress progress{.state = sow(start_.parameters, start_.plants)};
    if (folder_) folder_->begin(progress);
    return progress;
  }

  bool is_checkpoint_due() const {
    return state().step % options_.checkpoint.value_or(usual_checkpoint) == 0 ||
           (is_at_end() && options_.checkpoint.has_value());
  }

  void save() { folder_->save(state(), pairs_); }

  [[noreturn]] void stop() {
    if (!folder_) throw Interrupted("nothing was written");
    save();
    throw Interrupted(fmt::format("step {} is kept in {}, go on with the same command and --resume",
                                  state().step, folder_->checkpoint_file().string()));
  }

  /// What is to be told of this step.
  void record() {
    if (!folder_) return;
    const std::int32_t step = state().step;
    const bool has_rows = step % options_.every.value_or(1) == 0;
    const bool has_frame = options_.frames > 0 && step % options_.frames == 0;
    if (!has_rows && !has_frame) return;
    snapshot_ = snapshot_of(*population_);
    if (has_rows) {
      if (step == 0) folder_->add_rows(steps_header());
      folder_->add_rows(steps_rows(*population_, snapshot_->statistics, start_.count));
    }
    if (has_frame) folder_->write_frame(step, picture(options_.frame_format, *snapshot_));
    if (!is_at_end()) snapshot_.reset();
  }

  CompeteFindings findings() {
    if (!snapshot_) snapshot_ = snapshot_of(*population_);
    CompeteFindings findings{.population = *population_,
                             .last = std::move(*snapshot_),
                             .start = start_.count,
                             .pattern = {},
                             .pairs = pairs_,
                             .files = {}};
    const std::size_t plants = state().stand.size();
    if (plants < fewest_plants_with_pattern) return findings;
    if (!options_.statistics && plants > most_plants_with_pattern) return findings;
    show_progress("finding the pattern of the stand");
    findings.pattern = stand_pattern(state().stand, start_.parameters.ground,
                                     start_.parameters.is_torus, options_.threads);
    return findings;
  }

  std::string picture(const std::string& format, const StandSnapshot& snapshot) const {
    const Stand& stand = state().stand;
    const StandView view{
        .parameters = start_.parameters,
        .stand = stand,
        .loss = snapshot.loss,
        .root_radius = snapshot.root_radius,
        .crown_radius = reads_above_ ? snapshot.crown_radius : std::span<const double>()};
    if (format == "png") return stand_png(view, picture_side);
    if (stand.size() > most_plants_in_svg)
      throw InputError(fmt::format(
          "step {} has {} plants, more than the {} of an SVG; start again, into another --out, "
          "with --frame-format png",
          state().step, stand.size(), most_plants_in_svg));
    return stand_svg(view, fmt::format("Step {}: {} plants", state().step, stand.size()));
  }

  const CompeteOptions& options_;
  const CompeteStart& start_;
  bool reads_above_;
  std::optional<CompeteFolder> folder_;
  std::optional<Population> population_;
  std::optional<StandSnapshot> snapshot_;  ///< of the last step
  std::uint64_t pairs_ = 0;
};

}  // namespace

int compete(const CompeteOptions& options) {
  if (options.example) {
    print(example_population_file());
    return 0;
  }
  keep_freed_memory();
  check_options(options);
  const CompeteStart start = read_start(options);
  overlap_engine_named(options.engine);  // a wrong name before any file
  catch_interrupts();                    // from here on there are steps to stop between
  CompeteRun run(options, start);
  CompeteFindings findings = run.finished();
  run.write(findings);
  clear_progress();
  print(options.json ? compete_json(findings, options) : compete_text(findings, options));
  return 0;
}

}  // namespace phytobench::cli
