// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <string>
#include <string_view>

#include "core/component_graph/component.hpp"

namespace phytobench {

/// Every kind of components.def in that order, whether built or not.
std::span<const ComponentKind* const> all_component_kinds();

/// The built kind of that name. Throws InputError naming the known ones, or the missing package.
const ComponentKind& component_kind_named(std::string_view name);

/// "simple, horn, ..." for messages.
std::string known_component_kind_names();

}  // namespace phytobench
