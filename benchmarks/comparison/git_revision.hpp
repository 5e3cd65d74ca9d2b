// SPDX-License-Identifier: MIT
// What comparisons ask git. All throw EnvironmentError where git is missing.
#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace phytobench {

/// Topmost folder of the repository around a folder; nothing outside of any.
std::optional<std::filesystem::path> repository_around(const std::filesystem::path& folder);

/// What git says where there is none, in one line.
std::string repository_problem(const std::filesystem::path& folder);

/// All digits of the commit that is meant by "HEAD~2", a branch, a tag or the first digits; nothing
/// if none is.
std::optional<std::string> commit_named(const std::string& revision,
                                        const std::filesystem::path& repository);

/// Branches and tags.
std::vector<std::string> revision_names(const std::filesystem::path& repository);

/// Whether older commits were left out when the repository was cloned.
bool is_shallow(const std::filesystem::path& repository);

/// Writes the files of a commit into a folder that is there and empty, with a .tar file beside it
/// that does not stay. Nothing is registered in the repository. Throws EnvironmentError.
void unpack_commit(const std::filesystem::path& repository, const std::string& commit,
                   const std::filesystem::path& folder);

}  // namespace phytobench
