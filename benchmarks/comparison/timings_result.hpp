// SPDX-License-Identifier: MIT
// Times of the experiments of `phytobench run` as a stored result.
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "benchmarks/comparison/stored_result.hpp"

namespace phytobench {

/// Whether it begins as timings.jsonl does.
bool is_timings_text(std::string_view text);

/// Of a run's folder. Throws InputError where it is none, or not as it was written.
StoredResult timings_result_of_run(const std::filesystem::path& folder);

/// Of timings.jsonl alone. Where an environment.json that belongs to it lies beside it, that says
/// which build and machine it is from; else both are unknown.
StoredResult timings_result_from(const std::filesystem::path& file, std::string_view text);

}  // namespace phytobench
