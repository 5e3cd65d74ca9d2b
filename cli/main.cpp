// SPDX-License-Identifier: MIT
// Reads the command line and turns whatever happens into one line and an exit code.
#include <algorithm>
#include <csignal>
#include <cstdio>
#include <exception>

#include <fmt/format.h>
#include <CLI/CLI.hpp>

#include "build_information.hpp"
#include "cli/command_line/command_line.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench::cli {

namespace {

enum ExitCode {
  ok = 0,
  difference = 1,
  bad_input = 2,
  environment = 3,
  nothing_selected = 4,
  interrupted = 130
};

std::string joined(int argc, char** argv) {
  std::string text = "phytobench";
  for (int i = 1; i < argc; ++i) text += std::string(" ") + argv[i];
  return text;
}

/// The library would only say that some subcommand is required.
void refuse_unknown_command(const CLI::App& app, int argc, char** argv) {
  std::vector<std::string> names;
  for (const CLI::App* sub : app.get_subcommands([](const CLI::App*) { return true; }))
    names.push_back(sub->get_name());
  const std::string known =
      fmt::format("; commands: {} (phytobench --help)", fmt::join(names, ", "));
  if (argc < 2) throw InputError("no command given" + known);
  const std::string first = argv[1];
  const std::vector<std::string> options = {"--help", "-h", "--version"};
  if (first.starts_with("-") && std::find(options.begin(), options.end(), first) == options.end())
    throw InputError("unknown option '" + first + "'" + known);
  if (first.starts_with("-") || std::find(names.begin(), names.end(), first) != names.end()) return;
  throw InputError("unknown command '" + first + "'" + did_you_mean(first, names) + known);
}

/// The last of a chain such as race, shadow.
const CLI::App& chosen_command(const CLI::App& app) {
  const auto chosen = app.get_subcommands();
  return chosen.empty() ? app : chosen_command(*chosen.front());
}

/// What the library has to say, what may have been meant, and whose help says more.
std::string wrong_usage(const CLI::App& app, const CLI::ParseError& error) {
  const CLI::App& command = chosen_command(app);
  std::string text = error.what();
  std::vector<std::string> options;
  for (const CLI::Option* option : command.get_options()) options.push_back(option->get_name());
  const std::vector<std::string> extras = command.remaining();
  const auto unknown = std::find_if(extras.begin(), extras.end(),
                                    [](const std::string& word) { return word.starts_with("--"); });
  if (unknown != extras.end())
    text += did_you_mean(unknown->substr(0, unknown->find('=')), options);
  std::string name = command.get_name();
  for (const CLI::App* above = command.get_parent(); above != nullptr; above = above->get_parent())
    name = above->get_name() + " " + name;
  return fmt::format("{} ({} --help)", text, name);
}

/// Help of the subcommand that was asked for it, or of the program.
std::string help_of(const CLI::App& app) {
  return chosen_command(app).help();
}

int run_command_line(int argc, char** argv) {
  CLI::App app("phytobench: validation and benchmarks for computational plant models",
               "phytobench");
  app.set_version_flag("--version", fmt::format("phytobench {} ({})", build_information::version,
                                                build_information::commit));
  app.require_subcommand(1);
  Commands commands;
  commands.run.command_line = commands.nearest_node_race.command_line =
      commands.overlap_race.command_line = commands.hopkins_race.command_line =
          commands.competition_race.command_line = commands.lsystem_race.command_line =
              commands.shadow_race.command_line = commands.compare.command_line =
                  commands.selftest.command_line = commands.history.command_line =
                      joined(argc, argv);
  add_list(app, commands);
  add_run(app, commands);
  add_report(app, commands);
  add_grow(app, commands);
  add_race(app, commands);
  add_build(app, commands);
  add_derive(app, commands);
  add_overlap(app, commands);
  add_pattern(app, commands);
  add_compete(app, commands);
  add_terrain(app, commands);
  add_doctor(app, commands);
  add_bench(app, commands);
  add_compare(app, commands);
  add_selftest(app, commands);
  add_history(app, commands);
  refuse_unknown_command(app, argc, argv);
  refuse_unknown_race(argc, argv);
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    if (error.get_exit_code() == 0) {
      const bool version = dynamic_cast<const CLI::CallForVersion*>(&error) != nullptr;
      print(version ? std::string(error.what()) + "\n" : help_of(app));
      return ok;
    }
    throw InputError(wrong_usage(app, error));
  }
  return commands.chosen();
}

int fail(ExitCode code, const std::exception& error) {
  clear_progress();
  std::string line = error.what();
  for (char& c : line)  // what the user typed may stand in it
    if (static_cast<unsigned char>(c) < ' ') c = ' ';
  std::fprintf(stderr, "phytobench: %s\n", line.c_str());
  return code;
}

}  // namespace

}  // namespace phytobench::cli

int main(int argc, char** argv) {
  using namespace phytobench;
  using namespace phytobench::cli;
  std::signal(SIGXFSZ, SIG_IGN);  // a file beyond the limit is a failed write, told like others
  try {
    const int code = run_command_line(argc, argv);
    clear_progress();
    return code;
  } catch (const InputError& error) {
    return fail(bad_input, error);
  } catch (const NothingSelected& error) {
    return fail(nothing_selected, error);
  } catch (const Interrupted& error) {
    return fail(interrupted, error);
  } catch (const std::bad_alloc&) {
    return fail(environment,
                EnvironmentError("out of memory; ask for fewer points or plants, or free some"));
  } catch (const std::exception& error) {
    return fail(environment, error);
  }
}
