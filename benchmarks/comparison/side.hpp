// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "benchmarks/comparison/comparison.hpp"

namespace phytobench {

/// The program that speaks the protocol of worker_protocol.hpp, in the folder of a build.
inline constexpr const char* worker_name = "phytobench_worker";

/// One side of a comparison: what the user named, and how it is run.
struct Side {
  SideOrigin origin;  ///< a revision's lacks compiler, flags and digest until it is built
  std::filesystem::path worker;  ///< absolute; empty for results and for revisions not yet built
  std::vector<std::string> worker_options;  ///< that each call of the worker gets
  std::filesystem::path data_folder;  ///< for PHYTOBENCH_DATA; empty: the worker finds its own
  std::filesystem::path file;         ///< absolute; the plugin or the stored result
  std::filesystem::path repository;   ///< of a revision: its topmost folder
  std::string whole_commit;           ///< of a revision: all its digits
  std::string note;                   ///< a sentence the user must be told; empty if none
};

/// What the meaning of names depends on.
struct SideContext {
  std::filesystem::path folder;       ///< that paths start from, in the repository that is meant
  std::filesystem::path program;      ///< the running one: the worker beside it runs plugins
  std::filesystem::path data_folder;  ///< for workers without a share folder; empty: none is known
};

/// Of the current folder, the running program and PHYTOBENCH_DATA.
SideContext side_context();

/// Finds out what is meant, in this order: a folder that holds a worker is a build, a file that
/// ends in .so a plugin, what read_stored_result() reads (.json, .jsonl, a run's folder) a result;
/// everything else is a revision of the repository around the folder. A name that means both is
/// taken for the file, and the note says so. Throws InputError if it is none of these, if a build
/// is older than comparisons or its files are damaged; EnvironmentError if the program's own worker
/// is missing.
Side resolve_side(const std::string& given, const SideContext& context);

/// The build in that folder. Its commit, compiler and flags are those of worker_build.json, and
/// stay empty where a build has no such file. Throws InputError if a file is damaged.
Side side_of_build(const std::filesystem::path& folder, const std::string& given,
                   const SideContext& context);

/// How the side is called in messages: as given, and a revision's commit.
std::string title_of(const Side& side);

/// Digits of a commit that name it for people and in folders.
inline constexpr std::size_t commit_digits = 12;

}  // namespace phytobench
