// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/git_revision.hpp"

#include <algorithm>
#include <sstream>

#include <fmt/format.h>

#include "benchmarks/comparison/child_process.hpp"
#include "benchmarks/comparison/plain_text.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace fs = std::filesystem;

namespace {

constexpr double git_limit_s = 300.0;

ChildResult run_in(const fs::path& folder, std::vector<std::string> command) {
  return run_child({.command = std::move(command),
                    .folder = folder,
                    .environment = {{"LC_ALL", "C"}},
                    .limit_s = git_limit_s});
}

/// Without the line end.
std::string text_of(const ChildResult& result) {
  return result.out.substr(0, result.out.find_last_not_of("\r\n") + 1);
}

void demand(const ChildResult& result, const std::string& what) {
  if (result.is_ok()) return;
  throw EnvironmentError(
      fmt::format("{} {}: {}", what, ending_of(result, git_limit_s), last_line(result.err)));
}

bool is_whole_commit(const std::string& text) {
  return text.size() >= 40 && std::all_of(text.begin(), text.end(), [](char c) {
           return ('0' <= c && c <= '9') || ('a' <= c && c <= 'f');
         });
}

}  // namespace

std::optional<fs::path> repository_around(const fs::path& folder) {
  const ChildResult result = run_in(folder, {"git", "rev-parse", "--show-toplevel"});
  if (!result.is_ok() || text_of(result).empty()) return std::nullopt;
  return fs::path(text_of(result));
}

std::string repository_problem(const fs::path& folder) {
  return one_line(run_in(folder, {"git", "rev-parse", "--show-toplevel"}).err);
}

std::optional<std::string> commit_named(const std::string& revision, const fs::path& repository) {
  // An option is no revision, and a range or a file of a revision is no commit.
  if (revision.empty() || revision.starts_with("-")) return std::nullopt;
  const ChildResult result =
      run_in(repository, {"git", "rev-parse", "--verify", "--quiet", revision + "^{commit}"});
  if (!result.is_ok() || !is_whole_commit(text_of(result))) return std::nullopt;
  return text_of(result);
}

std::vector<std::string> revision_names(const fs::path& repository) {
  const ChildResult result = run_in(
      repository, {"git", "for-each-ref", "--format=%(refname:short)", "refs/heads", "refs/tags"});
  std::vector<std::string> names;
  std::istringstream lines(result.out);
  for (std::string line; std::getline(lines, line);) names.push_back(line);
  return names;
}

bool is_shallow(const fs::path& repository) {
  return text_of(run_in(repository, {"git", "rev-parse", "--is-shallow-repository"})) == "true";
}

void unpack_commit(const fs::path& repository, const std::string& commit, const fs::path& folder) {
  fs::path archive = folder;
  archive += ".tar";
  demand(run_in(repository,
                {"git", "archive", "--format=tar", "--output=" + archive.string(), commit}),
         "git archive");
  const ChildResult unpacked = run_in(folder, {"tar", "-xf", archive.string(), "--no-same-owner"});
  std::error_code ignored;
  fs::remove(archive, ignored);
  demand(unpacked, "tar");
}

}  // namespace phytobench
