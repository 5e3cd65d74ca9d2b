// SPDX-License-Identifier: MIT
// The way back from to_json_line().
#pragma once

#include <nlohmann/json_fwd.hpp>

#include "core/record/record.hpp"

namespace phytobench {

/// Throw InputError or an exception of the JSON library for what is not such a line.
Record record_from(const nlohmann::ordered_json& line);
TimingSample timing_from(const nlohmann::ordered_json& line);

}  // namespace phytobench
