// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Every engine of engines.def in that order, whether built or not.
std::span<const EngineDescriptor* const> all_engines();

/// The built engine of that name. Throws InputError naming the known ones, or the missing package.
const EngineDescriptor& engine_named(std::string_view name);

/// "euclidean_scan, squared_scan, ..." for messages.
std::string known_engine_names();

}  // namespace phytobench
