// SPDX-License-Identifier: MIT
// What a Google Benchmark program writes with --benchmark_out=FILE --benchmark_out_format=json
// (versions 1.4 and later; read against 1.7.1).
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/comparison/stored_result.hpp"

namespace phytobench {

/// Whether it has a context and a list of benchmarks.
bool is_google_benchmark_document(const nlohmann::ordered_json& document);

/// Repetitions are samples; means, medians and other aggregates are left out. The time is that of
/// the processor, or the one by the clock where the name says "/real_time" or "/manual_time". The
/// name of the host is not kept. Throws InputError beginning with `whose`.
StoredResult google_benchmark_result_from(const std::string& json, const std::string& whose);

}  // namespace phytobench
