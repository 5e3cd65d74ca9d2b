// SPDX-License-Identifier: MIT
// Options of the commands that compare builds.
#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"
#include "cli/command_line/list_options.hpp"
#include "core/contract/errors.hpp"

namespace phytobench::cli {

namespace {

/// Without --most-blocks there are as many as the least asks for.
void refuse_odd_blocks(const CompareOptions& options, bool is_most_given) {
  if (is_most_given && options.most_blocks < options.least_blocks)
    throw InputError(
        fmt::format("--most-blocks {}: is less than --least-blocks {}; give at least "
                    "as many",
                    options.most_blocks, options.least_blocks));
}

}  // namespace

void add_sampling(CLI::App& sub, int& samples, double& sample_ms) {
  sub.add_option("--samples", samples, "Of each benchmark in each process")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  sub.add_option("--sample-ms", sample_ms, "Length of a sample, roughly")
      ->capture_default_str()
      ->check(CLI::Range(0.1, 10000.0));
}

void add_compare(CLI::App& app, Commands& commands) {
  CompareOptions& options = commands.compare;
  CLI::App* sub = app.add_subcommand("compare", "Is one build slower than another?");
  sub->add_option("base", options.base,
                  "A git revision, a build folder, a plugin (.so) or a stored result (.json)")
      ->required();
  sub->add_option("new", options.other, "The same; it is slower or faster than base")->required();
  as_one_list_of_names(
      sub->add_option("--benchmarks", options.benchmarks, "Names or globs; comma-separated"));
  sub->add_option("--tolerance", options.tolerance_percent,
                  "Per cent that do not matter (default: 3; 10 with a stored result)");
  sub->add_option("--budget", options.budget_s, "Seconds of timing, roughly")
      ->capture_default_str()
      ->check(CLI::Range(1e-3, 1e6));
  // Of fewer than 8 nothing is concluded (VerdictSettings); a block is whole, ABBA or BAAB.
  sub->add_option("--least-blocks", options.least_blocks,
                  "Of two processes of each side; more where many benchmarks need it")
      ->capture_default_str()
      ->check(CLI::Range(8, 1000));
  const CLI::Option* most =
      sub->add_option("--most-blocks", options.most_blocks, "Of them; not less than the least")
          ->capture_default_str()
          ->check(CLI::Range(8, 1000));
  add_sampling(*sub, options.samples, options.sample_ms);
  sub->add_option("--seed", options.seed, "Of the order of processes and all that they draw")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--out", options.out, "Write the JSON document, with all samples");
  sub->add_option("--markdown", options.markdown, "Write a comment or step summary");
  sub->add_option("--junit", options.junit, "Write JUnit XML");
  sub->add_option("--cache", options.cache,
                  "Folder for builds of revisions (default: build/compare)");
  sub->add_option("--plugin-limit", options.plugin_limit,
                  "Seconds that a call of a plugin may take in its trial, and an answer later")
      ->capture_default_str()
      ->check(CLI::Range(0.01, 1e6));
  sub->add_flag("--time-anyway", options.time_anyway, "Even if both programs are the same");
  sub->add_flag("--strict", options.strict, "Exit with 5 if a verdict is inconclusive");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&commands, most] {
    refuse_odd_blocks(commands.compare, most->count() > 0);
    commands.chosen = [&commands] { return compare(commands.compare); };
  });
}

void add_selftest(CLI::App& app, Commands& commands) {
  SelftestOptions& options = commands.selftest;
  CLI::App* sub =
      app.add_subcommand("selftest", "Can the verdicts of compare be believed on this machine?");
  sub->add_option(
         "--repetitions", options.repetitions,
         "Comparisons of this build with itself; a quarter as many with a known loss, and a "
         "tenth as compare makes them")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  sub->add_option("--seed", options.seed, "Of the order of processes and all that they draw")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_flag("--strict", options.strict, "Exit with 5 if nothing is proven");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return selftest(commands.selftest); }; });
}

void add_history(CLI::App& app, Commands& commands) {
  HistoryOptions& options = commands.history;
  CLI::App* sub = app.add_subcommand("history", "What was counted and measured of earlier builds");
  sub->add_option("action", options.action,
                  "list, show BENCHMARK, plot BENCHMARK, append RESULT.json..., save NAME, or "
                  "compare NAME [NAME2]")
      ->capture_default_str();
  sub->add_option("names", options.names, "A benchmark, files, or names of baselines");
  sub->add_option("--quantity", options.quantity,
                  "For show, plot and compare: counter:search_evaluations or another counter, "
                  "instructions, or ratio (default: all there are)");
  sub->add_option("--file", options.file, "The SQLite file")->capture_default_str();
  sub->add_option("--out", options.out, "Write a plot as .svg");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return history(commands.history); }; });
}

}  // namespace phytobench::cli
