// SPDX-License-Identifier: MIT
// The gate on instruction counts: base against new, both under Callgrind.
#include <algorithm>
#include <map>
#include <memory>
#include <optional>
#include <string_view>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/comparison_report.hpp"
#include "benchmarks/comparison/gate_junit.hpp"
#include "benchmarks/comparison/git_revision.hpp"
#include "benchmarks/comparison/instruction_report.hpp"
#include "benchmarks/comparison/processor_split.hpp"
#include "benchmarks/comparison/revision_build.hpp"
#include "benchmarks/comparison/worker_client.hpp"
#include "benchmarks/history/history_file.hpp"
#include "cli/commands.hpp"
#include "cli/option_values.hpp"
#include "cli/output_files.hpp"
#include "cli/source_tree.hpp"
#include "cli/terminal.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/name_selection.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench::cli {

namespace {

namespace fs = std::filesystem;

WorkerClient client_of(const Side& side) {
  return WorkerClient(side, {.is_interrupted = is_interrupted});
}

/// Throws InputError for plugins and stored results.
Side resolved(const std::string& given, const SideContext& context) {
  const Side side = resolve_side(given, context);
  if (side.origin.kind != "revision" && side.origin.kind != "build")
    throw InputError(given + ": instructions are counted of revisions and build folders only");
  return side;
}

Side built(const Side& side, const SideContext& context) {
  return built_side(
      side, context,
      {.show_progress = show_progress, .tell = tell, .is_interrupted = is_interrupted});
}

Side new_side(const BenchInstructionsOptions& options, const SideContext& context) {
  if (!options.new_build.empty()) return built(resolved(options.new_build, context), context);
  return side_of_build(context.program.parent_path(), "this build", context);
}

/// What the new build is a change of: its commit, or that commit's first parent.
std::string default_base(const Side& new_build) {
  const SideOrigin& origin = new_build.origin;
  const std::string commit = origin.commit.empty() ? "HEAD" : origin.commit;
  return origin.changed ? commit : commit + "~1";
}

/// Sources from before there was a worker: nobody's mistake.
bool is_too_old(const InputError& error) {
  return std::string_view(error.what()).find("older than comparisons") != std::string_view::npos;
}

/// Whether the sources' history has one commit, and not because the rest was left out.
bool is_first_commit(const SideContext& at_sources) {
  const std::optional<fs::path> repository = repository_around(at_sources.folder);
  return repository && !is_shallow(*repository) && commit_named("HEAD", *repository) &&
         !commit_named("HEAD~1", *repository);
}

/// Nothing, with the reason, where there cannot be a base yet: it is too old, or nobody has named
/// one and the first commit has no parent.
std::optional<Side> base_side(const BenchInstructionsOptions& options, const SideContext& context,
                              const Side& new_build, std::string& reason) {
  const bool is_given = !options.base.empty();
  std::optional<Side> side;
  // Its commit is one of the sources' repository, wherever the user stands.
  SideContext at_sources = context;
  at_sources.folder = source_tree();
  try {
    side =
        is_given ? resolved(options.base, context) : resolved(default_base(new_build), at_sources);
    return built(*side, context);
  } catch (const InputError& error) {
    if (!is_too_old(error) && (is_given || side || !is_first_commit(at_sources))) throw;
    reason = fmt::format("nothing to compare with: {}", error.what());
    return std::nullopt;
  }
}

/// Names of the chosen benchmarks that each side has.
struct Chosen {
  std::vector<std::string> in_base;
  std::vector<std::string> in_new;
};

Chosen chosen(const BenchInstructionsOptions& options, const WorkerDescription& base,
              const WorkerDescription& other) {
  std::vector<std::string> all;
  for (const WorkerDescription* side : {&other, &base})
    for (const WorkerDescription::Benchmark& one : side->benchmarks)
      if ((one.is_own || !options.own_only) &&
          std::find(all.begin(), all.end(), one.name) == all.end())
        all.push_back(one.name);
  Chosen names;
  const auto has = [](const WorkerDescription& side, const std::string& name) {
    return std::any_of(side.benchmarks.begin(), side.benchmarks.end(),
                       [&](const auto& one) { return one.name == name; });
  };
  for (const std::size_t i :
       selected_names(all, options.benchmarks, {"benchmark", "phytobench bench list"})) {
    if (has(base, all[i])) names.in_base.push_back(all[i]);
    if (has(other, all[i])) names.in_new.push_back(all[i]);
  }
  return names;
}

/// What the oracles say of the answers of the new build, by name.
std::map<std::string, VerifiedBenchmark> verified(WorkerClient& client,
                                                  const std::vector<std::string>& names) {
  std::map<std::string, VerifiedBenchmark> found;
  if (names.empty()) return found;  // a worker runs everything then
  show_progress(fmt::format("judging the answers of {} benchmarks", names.size()));
  for (const VerifiedBenchmark& one : client.verify(names)) found[one.name] = one;
  return found;
}

/// Files that judging takes, read before anything is built or counted.
struct Files {
  std::vector<AcceptedIncrease> accepted;
  std::shared_ptr<const HistoryFile> history;  ///< null: none was named
};

/// A file that the user names must be there; that of the sources may be missing.
std::vector<AcceptedIncrease> accepted_increases(const std::string& given) {
  if (given.empty())
    return read_accepted_increases(source_tree() / "benchmarks" / "baselines" /
                                   "accepted_instructions.toml");
  return accepted_increases_from(read_text_file(given), given);
}

Files read_files(const BenchInstructionsOptions& options) {
  Files files{.accepted = accepted_increases(options.accepted), .history = nullptr};
  if (!options.history.empty())
    files.history = std::make_shared<HistoryFile>(options.history, HistoryAccess::read);
  return files;
}

/// Ordinary changes of a benchmark so far; none without a history.
std::function<std::vector<double>(const std::string&)> earlier_changes(const Files& files) {
  if (!files.history) return {};
  return [history = files.history](const std::string& name) {
    return history->changes_of_instructions(name);
  };
}

int all_processors() {
  return std::max(1, static_cast<int>(allowed_processors().size()));
}

InstructionReport counted_report(const BenchInstructionsOptions& options, const Files& files,
                                 const Side& base, const Side& other) {
  WorkerClient base_client = client_of(base), other_client = client_of(other);
  const Chosen names = chosen(options, base_client.describe(), other_client.describe());
  const bool is_same = base.origin.program_digest == other.origin.program_digest;
  const auto answers =
      is_same ? std::map<std::string, VerifiedBenchmark>() : verified(other_client, names.in_new);
  const std::vector<CountedPair> pairs = count_pairs(
      {.base = counted_build(base, names.in_base),
       .other = counted_build(other, names.in_new),
       .is_same_binary = is_same,
       .threads = options.threads > 0 ? options.threads : all_processors(),
       .simulate_cache = options.simulate_cache,
       .objection_to = [&](const std::string& name) { return answers.at(name).objection; },
       .verified_answer_of = [&](const std::string& name) { return answers.at(name).answer; },
       .earlier_changes = earlier_changes(files),
       .show_progress = show_progress,
       .is_interrupted = is_interrupted});
  InstructionReport report{base.origin, other.origin, {}};
  for (const CountedPair& pair : pairs)
    report.judged.push_back(judge_instructions(pair, files.accepted, base.origin.commit));
  return report;
}

void write_files(const BenchInstructionsOptions& options, const std::string& junit,
                 const std::string& markdown) {
  if (!options.junit.empty()) write_file_atomically(options.junit, junit);
  if (!options.markdown.empty()) write_file_atomically(options.markdown, markdown);
}

/// A simulated cache is told of where programs were run; where none was, this says so.
std::string missing_misses(const BenchInstructionsOptions& options,
                           const InstructionReport& report) {
  const bool has_misses =
      std::any_of(report.judged.begin(), report.judged.end(), [](const JudgedInstructions& one) {
        return one.pair.base.totals.misses || one.pair.other.totals.misses;
      });
  if (!options.simulate_cache || has_misses) return "";
  return "--cache: no benchmark was run, so no misses were counted\n";
}

int without_base(const BenchInstructionsOptions& options, const std::string& reason) {
  if (!options.allow_no_base) throw NothingSelected(reason + " (--allow-no-base lets this pass)");
  write_files(options, gate_junit("bench instructions", {{"base", GateOutcome::skipped, reason}}),
              "**phytobench bench instructions:** " + reason + "\n");
  const nlohmann::ordered_json json{{"schema", "phytobench/instructions-1"},
                                    {"base", nullptr},
                                    {"reason", reason},
                                    {"benchmarks", nlohmann::ordered_json::array()}};
  print(options.json ? json_text(json) + "\n" : reason + "\n");
  return 0;
}

}  // namespace

int bench_instructions(const BenchInstructionsOptions& options) {
  catch_interrupts();
  refuse_unwritable_files({options.junit, options.markdown});
  const Files files = read_files(options);
  const SideContext context = side_context();
  const Side other = new_side(options, context);
  std::string reason;
  const std::optional<Side> base = base_side(options, context, other, reason);
  if (!base) return without_base(options, reason);
  const InstructionReport report = counted_report(options, files, *base, other);
  clear_progress();
  write_files(options, instruction_junit(report), instruction_markdown(report));
  std::string text = instruction_table(report) + missing_misses(options, report);
  for (const std::string& note :
       differences_of_sides({.base = base->origin, .other = other.origin}))
    text += note + "\n";
  if (!base->note.empty()) text += base->note + "\n";
  print(options.json ? instruction_json(report) : text);
  return exit_code_of(report.judged);
}

}  // namespace phytobench::cli
