// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/side.hpp"

#include <cstdlib>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "benchmarks/comparison/found_program.hpp"
#include "benchmarks/comparison/git_revision.hpp"
#include "benchmarks/comparison/program_digest.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/sha256.hpp"
#include "core/contract/suggestion.hpp"
#include "core/contract/text_file.hpp"
#include "reference/data_folder.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

/// Symbolic links are followed, so that one build has one path.
fs::path whole_path(const fs::path& path) {
  std::error_code error;
  const fs::path whole = fs::canonical(path, error);
  return error ? fs::absolute(path) : whole;
}

bool is_file(const fs::path& path) {
  std::error_code ignored;
  return fs::is_regular_file(path, ignored);
}

bool is_folder(const fs::path& path) {
  std::error_code ignored;
  return fs::is_directory(path, ignored);
}

void read_build(const fs::path& file, SideOrigin& origin) {
  if (!is_file(file)) return;
  try {
    const auto json = nlohmann::ordered_json::parse(read_text_file(file));
    origin.commit = json.value("commit", std::string());
    origin.changed = json.value("source_changed", false);
    origin.compiler = json.value("compiler", std::string());
    origin.flags = json.value("flags", std::string());
  } catch (const nlohmann::ordered_json::exception& error) {
    throw InputError(fmt::format("{}: is damaged ({}); build again", file.string(), error.what()));
  }
  if (origin.commit == "unknown") origin.commit.clear();
}

/// Empty if the worker finds its own.
fs::path data_for(const fs::path& worker, const SideContext& context) {
  return data_folder_of_program(worker) ? fs::path() : context.data_folder;
}

Side plugin_side(const fs::path& plugin, const std::string& given, const SideContext& context) {
  const fs::path worker = whole_path(context.program).parent_path() / worker_name;
  if (!found_program(worker.string()))
    throw EnvironmentError(fmt::format("{} is missing, and it runs plugins; build the target {}",
                                       worker.string(), worker_name));
  Side side{.origin = {.given = given, .kind = "plugin"},
            .worker = worker,
            .worker_options = {"--plugin", plugin.string()},
            .data_folder = data_for(worker, context),
            .file = plugin};
  side.origin.program_digest = sha256_hex(program_digest(worker) + program_digest(plugin));
  return side;
}

/// What read_stored_result() reads, as far as names tell.
bool is_result(const fs::path& path) {
  if (is_folder(path)) return is_file(path / "timings.jsonl");
  return is_file(path) && (path.extension() == ".json" || path.extension() == ".jsonl");
}

/// Nothing if no build and no file that could be meant is there.
std::optional<Side> side_of_path(const fs::path& path, const std::string& given,
                                 const SideContext& context) {
  if (is_folder(path)) {
    if (is_file(path / worker_name)) return side_of_build(path, given, context);
    if (is_file(path / "phytobench"))
      throw InputError(
          fmt::format("{}: this build is older than comparisons, or not finished: it "
                      "has no {}; build a newer revision there",
                      given, worker_name));
  }
  if (is_file(path) && path.extension() == ".so")
    return plugin_side(whole_path(path), given, context);
  if (is_result(path))
    return Side{.origin = {.given = given, .kind = "result"}, .file = whole_path(path)};
  return std::nullopt;
}

[[noreturn]] void fail_to_resolve(const std::string& given, const fs::path& folder,
                                  const std::optional<fs::path>& repository) {
  const std::string tried = fmt::format(
      "'{}' is no build folder (one that holds {}), no plugin (.so) and no stored result (.json)",
      given, worker_name);
  if (!repository)
    throw InputError(
        fmt::format("{}; revisions need a repository around the current folder, and "
                    "git says: {}",
                    tried, repository_problem(folder)));
  std::string advice = did_you_mean(given, revision_names(*repository));
  if (is_shallow(*repository))
    advice += "; older commits are not here, get them with git fetch --unshallow";
  if (advice.empty()) advice = "; what is not committed is named by its build folder";
  throw InputError(tried + ", and git knows no such revision" + advice);
}

}  // namespace

SideContext side_context() {
  std::error_code error;
  SideContext context{.folder = fs::current_path(error),
                      .program = fs::read_symlink("/proc/self/exe", error)};
  if (error) throw EnvironmentError("the running program is not found: " + error.message());
  if (const char* given = std::getenv("PHYTOBENCH_DATA"); given != nullptr && *given != '\0')
    context.data_folder = whole_path(given);
  return context;
}

Side side_of_build(const fs::path& folder, const std::string& given, const SideContext& context) {
  const fs::path worker = whole_path(folder) / worker_name;
  if (!found_program(worker.string()))
    throw InputError(worker.string() + ": cannot be run; build again");
  Side side{.origin = {.given = given, .kind = "build"},
            .worker = worker,
            .data_folder = data_for(worker, context)};
  read_build(worker.parent_path() / "worker_build.json", side.origin);
  side.origin.program_digest = program_digest(worker);
  return side;
}

Side resolve_side(const std::string& given, const SideContext& context) {
  if (given.empty())
    throw InputError(
        "a side without a name; give a revision, a build folder, a plugin or a result");
  std::optional<Side> side = side_of_path(context.folder / given, given, context);
  if (side && !found_program("git")) return *side;
  const std::optional<fs::path> repository = repository_around(context.folder);
  const std::optional<std::string> commit =
      repository ? commit_named(given, *repository) : std::nullopt;
  if (side && commit)
    side->note = fmt::format(
        "'{}' is a {} and a revision, too: the {} is compared; give {} for "
        "the revision",
        given, side->origin.kind, side->origin.kind, commit->substr(0, commit_digits));
  if (side) return *side;
  if (!commit) fail_to_resolve(given, context.folder, repository);
  return {
      .origin = {.given = given, .kind = "revision", .commit = commit->substr(0, commit_digits)},
      .repository = *repository,
      .whole_commit = *commit};
}

std::string title_of(const Side& side) {
  if (side.origin.kind != "revision" || side.origin.commit.starts_with(side.origin.given))
    return side.origin.given;
  return fmt::format("{} ({})", side.origin.given, side.origin.commit);
}

}  // namespace phytobench
