// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench {

/// Every engine of shadow_engines.def in that order, whether built or not.
std::span<const ShadowEngineDescriptor* const> all_shadow_engines();

/// The built engine of that name. Throws InputError naming the known ones, or the missing package.
const ShadowEngineDescriptor& shadow_engine_named(std::string_view name);

/// "exact_traversal, max_pyramid, ..." for messages.
std::string known_shadow_engine_names();

}  // namespace phytobench
