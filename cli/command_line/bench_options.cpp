// SPDX-License-Identifier: MIT
// Options of `bench`.
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"

namespace phytobench::cli {

namespace {

constexpr const char* which_benchmarks = "Names or globs; all without it";

void add_bench_list(CLI::App& bench, Commands& commands) {
  BenchListOptions& options = commands.bench_list;
  CLI::App* sub = bench.add_subcommand("list", "What is watched for loss of speed");
  sub->add_option("benchmarks", options.benchmarks, which_benchmarks);
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return bench_list(commands.bench_list); }; });
}

void add_bench_counters(CLI::App& bench, Commands& commands) {
  BenchCountersOptions& options = commands.bench_counters;
  CLI::App* sub =
      bench.add_subcommand("counters", "Work counters against those in the committed file");
  sub->add_option("benchmarks", options.benchmarks, which_benchmarks);
  sub->add_option("--baseline", options.baseline,
                  "File with what is expected (default: benchmarks/baselines/counters.json)");
  sub->add_option("--worker", options.worker,
                  "A phytobench_worker of the preset 'counters' (default: the one beside this "
                  "program or in build/counters)");
  sub->add_flag("--accept", options.accept, "Write the file and say what changed");
  sub->add_option("--out", options.out,
                  "Write what was counted and of which build, for history; nothing if an answer is "
                  "wrong");
  sub->add_option("--junit", options.junit, "Write the result for test runners");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return bench_counters(commands.bench_counters); }; });
}

void add_bench_instructions(CLI::App& bench, Commands& commands) {
  BenchInstructionsOptions& options = commands.bench_instructions;
  CLI::App* sub =
      bench.add_subcommand("instructions", "Instructions counted by Callgrind, base against new");
  sub->add_option("benchmarks", options.benchmarks, which_benchmarks);
  sub->add_option("--base", options.base,
                  "Revision or build folder (default: the commit that this build has changes of, "
                  "or the parent of the one that it is)");
  sub->add_option("--new", options.new_build, "The same (default: this program's build)");
  sub->add_flag("--own-only", options.own_only, "Without what is mostly another library's work");
  sub->add_option("--threads", options.threads,
                  "Runs at a time, which change no count; 0: as many as processors")
      ->capture_default_str()
      ->check(CLI::Range(0, 1024));
  sub->add_flag("--cache", options.simulate_cache,
                "Count misses of a simulated cache, too; takes twice as long");
  sub->add_flag("--allow-no-base", options.allow_no_base,
                "Pass where base is older than comparisons, or there is none");
  sub->add_option("--accepted", options.accepted,
                  "TOML file of increases that are wanted, which must be there (default: "
                  "benchmarks/baselines/accepted_instructions.toml)");
  sub->add_option("--history", options.history,
                  "SQLite file, which must be there: a benchmark whose counts have always moved "
                  "may move");
  sub->add_option("--junit", options.junit, "Write the result for test runners");
  sub->add_option("--markdown", options.markdown, "Write the result for a merge request");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback(
      [&] { commands.chosen = [&] { return bench_instructions(commands.bench_instructions); }; });
}

void add_bench_measure(CLI::App& bench, Commands& commands) {
  BenchMeasureOptions& options = commands.bench_measure;
  CLI::App* sub = bench.add_subcommand(
      "measure", "Times of one build, beside those of a reference kernel, to be kept");
  sub->add_option("benchmarks", options.benchmarks, which_benchmarks);
  sub->add_option("--side", options.side,
                  "Revision, build folder or plugin (default: this program's build)");
  sub->add_option("--processes", options.processes, "Fresh processes; one repetition each")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
  add_sampling(*sub, options.samples, options.sample_ms);
  sub->add_option("--seed", options.seed, "Of the order of benchmarks in each process")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--out", options.out, "Write the result, for compare and history");
  sub->add_flag("--json", options.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return bench_measure(commands.bench_measure); }; });
}

}  // namespace

void add_bench(CLI::App& app, Commands& commands) {
  CLI::App* bench = app.add_subcommand("bench", "What benchmarks cost: work, instructions, time");
  bench->require_subcommand(1);
  add_bench_list(*bench, commands);
  add_bench_counters(*bench, commands);
  add_bench_instructions(*bench, commands);
  add_bench_measure(*bench, commands);
}

}  // namespace phytobench::cli
