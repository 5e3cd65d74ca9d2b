// SPDX-License-Identifier: MIT
// Options of the commands that list, run and report. Only files of this folder and main.cpp include
// the command-line library: its header is the dearest of all.
#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"
#include "cli/command_line/list_options.hpp"

namespace phytobench::cli {

void add_list(CLI::App& app, Commands& commands) {
  CLI::App* sub =
      app.add_subcommand("list", "What there is: papers, claims, experiments, engines, rules");
  sub->add_option(
      "what", commands.list.what,
      "papers, claims, errata, experiments, engines, presets or another kind; all counted without "
      "it");
  sub->add_flag("--json", commands.list.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return list(commands.list); }; });
}

void add_run(CLI::App& app, Commands& commands) {
  RunOptions& options = commands.run;
  CLI::App* sub = app.add_subcommand("run", "Run experiments and keep what they measure");
  sub->add_option("experiments", options.experiments, "Ids or globs; all without it");
  sub->add_option("--tier", options.tier, "smoke (seconds), quick (minutes) or full")
      ->capture_default_str();
  sub->add_option("--seed", options.seed, "Start of the suite's own random numbers")
      ->capture_default_str()
      ->check(whole_number);
  sub->add_option("--threads", options.threads, "Threads of the engines")
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
  sub->add_option("--out", options.out, "Folder for records and artifacts")->capture_default_str();
  sub->add_flag("--resume", options.resume, "Go on with the run in that folder");
  sub->add_flag("--dry-run", options.dry_run, "Only say what would run, and for how long");
  sub->callback([&] { commands.chosen = [&] { return run(commands.run); }; });
}

void add_report(CLI::App& app, Commands& commands) {
  ReportOptions& options = commands.report;
  CLI::App* sub = app.add_subcommand("report", "Judge the records of runs and write the report");
  sub->add_option("folder", options.folders,
                  "Folder of a run; several, of other machines or compilers, are merged")
      ->required();
  sub->add_option("--out", options.out,
                  "Folder for the report, in place of an earlier one there (default: "
                  "<folder>/report; needed for several runs)");
  as_one_list_of_names(
      sub->add_option("--format", options.formats, "html, md, latex, csv, junit; comma-separated"))
      ->capture_default_str();
  sub->add_flag("--without-varying", options.without_varying,
                "Leave out what differs between equal runs: times, machine");
  sub->add_flag("--strict", options.strict, "Exit with 5 if a verdict is inconclusive");
  sub->callback([&] { commands.chosen = [&] { return report(commands.report); }; });
}

void add_doctor(CLI::App& app, Commands& commands) {
  CLI::App* sub =
      app.add_subcommand("doctor", "What is installed, what is missing, is this machine quiet");
  sub->add_flag("--json", commands.doctor.json, "One JSON document");
  sub->callback([&] { commands.chosen = [&] { return doctor(commands.doctor); }; });
}

}  // namespace phytobench::cli
