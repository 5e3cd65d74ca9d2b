// SPDX-License-Identifier: MIT
// phytobench compare: is one build slower than another?
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "benchmarks/comparison/comparison_report.hpp"
#include "benchmarks/comparison/instrument_check.hpp"
#include "benchmarks/comparison/machine_load.hpp"
#include "benchmarks/comparison/measured_result.hpp"
#include "benchmarks/comparison/moved_code.hpp"
#include "benchmarks/comparison/paired_timing.hpp"
#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/revision_build.hpp"
#include "benchmarks/comparison/side.hpp"
#include "benchmarks/comparison/stored_result.hpp"
#include "benchmarks/comparison/unpaired_verdict.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "cli/commands.hpp"
#include "cli/compare_output.hpp"
#include "cli/output_files.hpp"
#include "cli/plugin_sides.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/name_selection.hpp"
#include "core/record/environment.hpp"

namespace phytobench::cli {

namespace {

constexpr SelectionWords benchmark_words = {.kind = "benchmark",
                                            .listing = "phytobench bench list"};

/// Default of --tolerance for times that were not taken in turns, in percent.
constexpr double stored_tolerance_percent = 10.0;
constexpr double paired_tolerance_percent = 3.0;

bool is_stored(const Side& side) {
  return side.origin.kind == "result";
}

double tolerance_of(const CompareOptions& options, double unless_given_percent) {
  const double percent = options.tolerance_percent.value_or(unless_given_percent);
  if (!(std::isfinite(percent) && percent > 0.0))
    throw InputError(fmt::format(
        "a tolerance of {} % finds a change everywhere; give more than 0, such as 3", percent));
  return percent / 100.0;
}

/// Those that both lists hold, then those that only one does.
std::vector<std::string> names_of_either(std::vector<std::string> base,
                                         const std::vector<std::string>& other) {
  for (const std::string& name : other)
    if (std::find(base.begin(), base.end(), name) == base.end()) base.push_back(name);
  return base;
}

std::vector<std::string> names_to_compare(const std::vector<std::string>& names,
                                          const std::vector<std::string>& globs) {
  std::vector<std::string> chosen;
  for (const std::size_t place : selected_names(names, globs, benchmark_words))
    chosen.push_back(names[place]);
  if (chosen.empty()) throw NothingSelected("neither side has a benchmark");
  return chosen;
}

/// Programs that are compared, with the processor they are timed on.
class Comparison {
 public:
  explicit Comparison(const CompareOptions& options)
      : options_(options),
        base_(resolve_side(options.base, context_)),
        other_(resolve_side(options.other, context_)) {}

  ComparisonReport report() {
    ComparisonReport report = tried();
    if (report.failed_trials.empty()) report = timed();
    for (const Side* side : {&base_, &other_})
      if (!side->note.empty()) report.notes.push_back(side->note + ".");
    report.environment_json = environment_json(options_.command_line, options_.seed, 1);
    return report;
  }

 private:
  /// Whether plugins are fit to be timed: found out before this process starts a thread.
  ComparisonReport tried() const {
    ComparisonReport report;
    report.timing.measured.base = base_.origin;
    report.timing.measured.other = other_.origin;
    report.timing.measured.seed = options_.seed;
    for (const auto& [role, side] : {std::pair("base", &base_), std::pair("new", &other_)})
      if (auto failed = trial_of(*side, role, options_.plugin_limit))
        report.failed_trials.push_back(*std::move(failed));
    return report;
  }

  ComparisonReport timed() {
    build(base_);
    build(other_);
    split_ = processor_split(allowed_processors());  // compilers may use all of them
    if (split_) runner_.emplace(split_->runner);
    return is_stored(base_) || is_stored(other_) ? stored() : paired();
  }

  void build(Side& side) const {
    side = built_side(side, context_,
                      {.cache = options_.cache,
                       .show_progress = show_progress,
                       .tell = tell,
                       .is_interrupted = is_interrupted});
  }

  /// Its origin is completed by what the worker says of itself.
  WorkerClient client_of(Side& side) const {
    WorkerClientOptions client_options{.is_interrupted = is_interrupted,
                                       .sample_ms = options_.sample_ms};
    if (split_) client_options.processor = split_->worker;
    if (side.origin.kind == "plugin") client_options.answer_limit_s = options_.plugin_limit;
    const WorkerDescription description = WorkerClient(side, client_options).describe();
    refuse_to_time_counters(description, title_of(side));
    if (side.origin.compiler.empty()) side.origin.compiler = description.compiler;
    if (side.origin.flags.empty()) side.origin.flags = description.flags;
    return WorkerClient(side, client_options);
  }

  bool is_same_program() const {
    return !options_.time_anyway && !base_.origin.program_digest.empty() &&
           base_.origin.program_digest == other_.origin.program_digest;
  }

  TimingSettings timing_settings(std::size_t benchmarks, const VerdictSettings& verdicts) const {
    const int least = std::max({6, options_.least_blocks, blocks_needed(benchmarks, verdicts)});
    return {.seed = options_.seed,
            .budget_s = options_.budget_s,
            .least_blocks = least,
            .most_blocks = std::max(least, options_.most_blocks),
            .samples = options_.samples,
            .sample_ms = options_.sample_ms,
            .tolerance = verdicts.tolerance};
  }

  ComparisonReport paired() {
    const VerdictSettings verdicts{.tolerance = tolerance_of(options_, paired_tolerance_percent)};
    WorkerClient base = client_of(base_), other = client_of(other_);
    const std::vector<std::string> names =
        names_to_compare(names_of_either(names_of(base), names_of(other)), options_.benchmarks);
    StealMeter steal;
    PairRequest request{.base = &base,
                        .other = &other,
                        .base_origin = base_.origin,
                        .other_origin = other_.origin,
                        .names = names,
                        .is_same_program = is_same_program(),
                        .settings = timing_settings(names.size(), verdicts),
                        .show_progress = show_progress,
                        .is_interrupted = is_interrupted,
                        .stolen_share = [&] { return steal.share_since_last(); }};
    ComparisonReport report{.timing = measure_pair(request),
                            .verdict_settings = verdicts,
                            .timing_settings = request.settings};
    report.concluded = conclude(report.timing.measured, verdicts);
    if (report.timing.was_interrupted)
      withdraw_verdicts(report.concluded);
    else
      count_what_changed(report.concluded);
    return report;
  }

  /// A plugin is not counted: callgrind's runs know none.
  void count_what_changed(std::vector<ConcludedBenchmark>& concluded) const {
    const std::vector<std::string> names = names_to_count(concluded);
    if (names.empty() || base_.origin.kind == "plugin" || other_.origin.kind == "plugin") return;
    show_progress("instructions of what changed are counted");
    consider_instructions(concluded, count_pairs({.base = counted_build(base_, names),
                                                  .other = counted_build(other_, names),
                                                  .show_progress = show_progress,
                                                  .is_interrupted = is_interrupted}));
  }

  StoredResult result_of(Side& side) {
    if (is_stored(side)) return read_stored_result(side.file);
    WorkerClient client = client_of(side);
    return measure_result({.side = &client,
                           .origin = side.origin,
                           .machine = this_result_machine(),
                           .names = names_to_compare(names_of(client), options_.benchmarks),
                           .seed = options_.seed,
                           .samples = options_.samples,
                           .sample_ms = options_.sample_ms,
                           .show_progress = show_progress,
                           .is_interrupted = is_interrupted});
  }

  ComparisonReport stored() {
    const double tolerance = tolerance_of(options_, stored_tolerance_percent);
    StoredResult base = result_of(base_), other = result_of(other_);
    choose(base, other);
    ComparisonReport report;
    report.verdict_settings.tolerance = tolerance;
    report.concluded = conclude_stored(base, other, {.tolerance = tolerance});
    report.notes.push_back(
        "The sides were not timed in turns: what the machine did between the two looks like a "
        "change of the program. Compare builds or revisions to find small ones.");
    Measured& measured = report.timing.measured;
    measured.base = base.origin;
    measured.other = other.origin;
    measured.seed = options_.seed;
    if (!is_stored(base_)) report.base_result = std::move(base);
    if (!is_stored(other_)) report.other_result = std::move(other);
    for (const ConcludedBenchmark& concluded : report.concluded)
      measured.benchmarks.push_back({.name = concluded.name});
    return report;
  }

  /// Leaves what --benchmarks names.
  void choose(StoredResult& base, StoredResult& other) const {
    const auto names_in = [](const StoredResult& result) {
      std::vector<std::string> names;
      for (const StoredBenchmark& benchmark : result.benchmarks) names.push_back(benchmark.name);
      return names;
    };
    const std::vector<std::string> chosen =
        names_to_compare(names_of_either(names_in(base), names_in(other)), options_.benchmarks);
    for (StoredResult* result : {&base, &other})
      std::erase_if(result->benchmarks, [&](const StoredBenchmark& benchmark) {
        return std::find(chosen.begin(), chosen.end(), benchmark.name) == chosen.end();
      });
  }

  const CompareOptions& options_;
  SideContext context_ = side_context();
  std::optional<ProcessorSplit> split_;
  std::optional<PinnedThread> runner_;
  Side base_, other_;
};

}  // namespace

int compare(const CompareOptions& options) {
  refuse_unwritable_files({options.out, options.markdown, options.junit});
  tolerance_of(options, paired_tolerance_percent);  // refused before anything is built
  catch_interrupts();
  const ComparisonReport report = Comparison(options).report();
  const int code = show_comparison(report, options);
  if (report.timing.was_interrupted) throw Interrupted("what was measured is shown, not judged");
  return code;
}

}  // namespace phytobench::cli
