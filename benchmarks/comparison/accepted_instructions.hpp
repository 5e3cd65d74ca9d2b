// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// An increase that somebody wanted, with the reason: of benchmarks whose names match, by at most
/// so much, against one commit. Once another commit is the base, it is over.
struct AcceptedIncrease {
  std::string benchmark;  ///< glob with '*' and '?'
  double percent = 0.0;   ///< > 0
  std::string base;       ///< the commit: its first 12 hexadecimal digits or more
  std::string reason;

  bool applies_to(std::string_view name, std::string_view base_commit) const;
};

/// [[accepted]] tables of a TOML file. Throws InputError with file:line for anything else in it.
std::vector<AcceptedIncrease> accepted_increases_from(const std::string& text,
                                                      const std::filesystem::path& file);

/// The same of a file; none if there is no such file.
std::vector<AcceptedIncrease> read_accepted_increases(const std::filesystem::path& file);

}  // namespace phytobench
