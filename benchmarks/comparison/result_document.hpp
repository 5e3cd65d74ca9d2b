// SPDX-License-Identifier: MIT
// What every JSON document about a build has in common: it is read whole, damage is one line, and
// it says which build it is about.
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "benchmarks/comparison/stored_result.hpp"

namespace phytobench {

/// The JSON object in `text`. Takes NaN and Infinity as null: Google Benchmark writes them so.
/// Throws InputError beginning with `whose` where it is no JSON, or no object.
nlohmann::ordered_json parsed_document(const std::string& text, const std::string& whose);

/// "phytobench/result-1", or empty where the document does not say.
std::string schema_of(const nlohmann::ordered_json& document);

nlohmann::ordered_json origin_json(const SideOrigin& origin);

/// Throws nlohmann's exceptions where a key is missing or of another type; what is not needed to
/// tell builds apart may be missing.
SideOrigin origin_from(const nlohmann::ordered_json& json);

/// Of {processor, logical_processors, kernel}, with the same exceptions.
ResultMachine result_machine_from(const nlohmann::ordered_json& json);

}  // namespace phytobench
