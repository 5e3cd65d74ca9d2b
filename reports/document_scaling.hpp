// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/scaling.hpp"

namespace phytobench {

/// The page on engines over the size of their workload as ready texts: pictures, tables,
/// crossovers, aims. `pictures` are SVG texts by name.
nlohmann::ordered_json scaling_document(const JudgedScaling& scaling,
                                        const std::map<std::string, std::string>& pictures,
                                        bool without_varying);

}  // namespace phytobench
