// SPDX-License-Identifier: MIT
// phytobench derive: an L-system in, its word counted and checked, a drawing out.
#include <algorithm>
#include <cmath>
#include <filesystem>

#include <fmt/format.h>

#include "cli/commands.hpp"
#include "cli/derive_findings.hpp"
#include "cli/drawing_files.hpp"
#include "cli/output_files.hpp"
#include "cli/plant_files.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/unused_productions.hpp"
#include "core/memory/keep_freed_memory.hpp"
#include "reference/lsystem_presets.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;

void print_example(const std::string& name) {
  if (name != "list") {
    print(read_text_file(lsystem_preset_file(name)));
    return;
  }
  std::string text;
  std::size_t width = 0;
  const std::vector<LSystemPreset> presets = lsystem_presets();
  for (const LSystemPreset& preset : presets) width = std::max(width, preset.name.size());
  for (const LSystemPreset& preset : presets)
    text += fmt::format("{:<{}}  {}\n", preset.name, width, preset.summary);
  print(text);
}

bool prints_word_alone(const LSystemDeriveOptions& options) {
  return options.print && !options.json;
}

void check_options(const LSystemDeriveOptions& options) {
  if (!options.preset.empty() && !options.system.empty())
    throw InputError("give a file of an L-system or --preset, not both");
  if (options.preset.empty() && options.system.empty())
    throw InputError(
        "derive needs a file of an L-system or a --preset; phytobench derive --example explained "
        "prints a file to start from, phytobench list lsystems lists the presets");
  if (!std::isfinite(options.most_modules))  // the command line lets "nan" pass
    throw InputError(fmt::format("--most-modules {}: give a number", options.most_modules));
  if (prints_word_alone(options) && !options.out.empty())
    throw InputError("--print prints the word alone; leave out --out, or give --json");
  refuse_odd_view(view_of(options, options.threads));
  refuse_other_drawings(options.out);
  refuse_idle_camera(options, camera_use(options.out), "--out");
  refuse_idle_split(options.split, options.out);
}

/// Before minutes are spent on them.
void refuse_wrong_files(const LSystemDeriveOptions& options) {
  for (const std::string& name : options.out) {
    std::error_code ignored;
    if (fs::equivalent(name, options.system, ignored))
      throw InputError(name + ": would overwrite the L-system; name another");
  }
  refuse_unwritable_files(options.out);
}

LSystem system_of(const LSystemDeriveOptions& options) {
  LSystem system = read_lsystem(options.system);
  if (options.steps) system.steps = *options.steps;
  if (options.seed) system.seed = *options.seed;
  return system;
}

/// What no step asks for is a slip more often than not.
void warn_of_unused_productions(const LSystem& system) {
  constexpr std::size_t most_lines = 10;
  const std::vector<std::string> lines = unused_productions(system);
  for (std::size_t i = 0; i < std::min(lines.size(), most_lines); ++i) tell("warning: " + lines[i]);
  if (lines.size() > most_lines)
    tell(fmt::format("warning: {}: {} productions more are never used", system.source,
                     lines.size() - most_lines));
}

Word derived(const LSystem& system, const LSystemDeriveOptions& options) {
  phytobench::DeriveOptions derivation;
  derivation.steps = system.steps;
  derivation.threads = options.threads;
  derivation.seed = system.seed;
  derivation.most_modules = static_cast<std::uint64_t>(options.most_modules);
  derivation.most_parameters = most_parameters(options);
  derivation.go_on = [&](int step) {
    show_progress(fmt::format("step {} of {}", step, system.steps));
    return !is_interrupted();
  };
  return phytobench::derive(system, derivation);
}

void refuse_word_not_made(const DeriveFindings& findings, const LSystem& system,
                          const LSystemDeriveOptions& options) {
  if (options.out.empty() && !options.print) return;
  throw InputError(
      fmt::format("{}: the word at step {} has {} modules and is not made, so that {} has nothing "
                  "to show; take "
                  "--steps {}, or raise --most-modules",
                  system.source, system.steps,
                  findings.predicted ? findings.predicted->modules.digits : "too many",
                  options.print ? "--print" : "--out", std::max(*findings.longest_made, 0)));
}

void write(DeriveFindings& findings, const std::vector<FileContent>& files) {
  if (is_interrupted()) throw Interrupted("nothing is written");
  write_new_files(files);
  for (const FileContent& file : files) findings.files.push_back(file.file.string());
}

DeriveFindings findings_of(const LSystem& system, const LSystemDeriveOptions& options) {
  DeriveFindings findings = forecast_findings(system, options);
  if (is_too_long(findings)) {
    refuse_word_not_made(findings, system, options);
    add_streamed_drawing(findings, system);
    return findings;
  }
  const Word word = derived(system, options);
  add_word(findings, system, word);
  if (options.print) findings.word = beginning_of(system, word, *options.print);
  if (prints_word_alone(options)) return findings;
  add_drawing(findings, system, word);
  const std::optional<TurtleTree> tree = add_tree(findings, system, word);
  write(findings, drawing_files(system, word, tree, options));
  return findings;
}

}  // namespace

int derive(const LSystemDeriveOptions& given) {
  if (!given.example.empty()) {
    print_example(given.example);
    return 0;
  }
  LSystemDeriveOptions options = given;
  check_options(options);
  if (!options.preset.empty()) options.system = lsystem_preset_file(options.preset).string();
  const LSystem system = system_of(options);
  refuse_wrong_files(options);
  warn_of_unused_productions(system);
  keep_freed_memory();
  catch_interrupts();  // from here on there are steps to stop between
  const DeriveFindings findings = findings_of(system, options);
  if (prints_word_alone(options))
    print(*findings.word + "\n");
  else
    print(options.json ? derive_json(system, findings, options)
                       : derive_text(system, findings, options));
  return 0;
}

}  // namespace phytobench::cli
