// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

/// Every engine of overlap_engines.def in that order, whether built or not.
std::span<const OverlapEngineDescriptor* const> all_overlap_engines();

/// The built engine of that name. Throws InputError naming the known ones, or the missing package.
const OverlapEngineDescriptor& overlap_engine_named(std::string_view name);

/// "all_pairs, sweep, ..." for messages.
std::string known_overlap_engine_names();

}  // namespace phytobench
