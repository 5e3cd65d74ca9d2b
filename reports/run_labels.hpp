// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <vector>

namespace phytobench {

/// Where a run comes from.
struct RunOrigin {
  std::string environment_json;  ///< "{}" if none was recorded
  std::string folder;            ///< as the user named it
};

/// One label per run, no two equal: compiler and processor ("GCC 12.2.0 on AMD EPYC"), with the
/// folder's name where these are equal, and its whole path where that is equal too.
std::vector<std::string> run_labels(std::span<const RunOrigin> runs);

}  // namespace phytobench
