// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

#include "core/record/run_files.hpp"
#include "core/record/sealed_file.hpp"

namespace phytobench {

inline constexpr const char* environment_name = "environment.json";
inline constexpr const char* artifacts_name = "artifacts";

/// What is whole in a run's folder, and where each file goes on.
struct WholeRun {
  RunContents contents;
  Seal last_of_records;
  Seal last_of_timings;
};

/// As read_run().
WholeRun read_whole_run(const std::filesystem::path& folder);

}  // namespace phytobench
