// SPDX-License-Identifier: MIT
// Builds of committed revisions, each in a folder of its own below a cache:
//
//   <cache>/<12 digits>/source      the files of the commit, and its build/release
//   <cache>/<12 digits>/unpacked    written when all files are there: their commit
//   <cache>/<12 digits>/made_with   compiler and variables that it is built with; build_inputs.hpp
//   <cache>/<12 digits>/build.log   what configuring and compiling said
//   <cache>/<12 digits>/finished    written last: the commit that the build is of
//
// All paths in it are equally long for all revisions, so that none is favoured by its name. Nothing
// is written to the user's repository. A folder can be deleted at any time. A build that was made,
// or begun, with another compiler or other flags than would be taken now is made anew.
#pragma once

#include <filesystem>
#include <functional>
#include <string>

#include "benchmarks/comparison/side.hpp"

namespace phytobench {

struct RevisionBuildOptions {
  std::filesystem::path cache = {};  ///< empty: build/compare in the repository
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  /// Told in a sentence that must stay to be read; may be empty.
  std::function<void(const std::string&)> tell = {};
  std::function<bool()> is_interrupted = {};  ///< may be empty
  double limit_s = 7200.0;                    ///< of each step, compiling everything among them
};

/// The folder of the revision's worker, built as the preset "release" says; `commit` with all its
/// digits. A finished build is used again and one that was interrupted is continued, unless it was
/// made with something else than build_inputs(); a finished one is not replaced without telling
/// why. Throws InputError if the revision has no worker, or if another process is building it;
/// Interrupted; and EnvironmentError, with the log's name, if building fails.
std::filesystem::path build_revision(const std::filesystem::path& repository,
                                     const std::string& commit,
                                     const RevisionBuildOptions& options);

/// A side of kind "revision", built. Sides of other kinds come back as they are.
Side built_side(const Side& side, const SideContext& context, const RevisionBuildOptions& options);

}  // namespace phytobench
