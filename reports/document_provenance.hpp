// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace phytobench {

/// environment.json as rows of name and value: the machine, compiler, libraries and command line of
/// a run.
nlohmann::ordered_json environment_rows(const nlohmann::ordered_json& environment);

/// Machine and compiler in one line, to stand below timings. Empty where nothing was recorded.
std::string machine_line(const nlohmann::ordered_json& environment);

}  // namespace phytobench
