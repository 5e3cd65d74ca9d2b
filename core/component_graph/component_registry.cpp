// SPDX-License-Identifier: MIT
#include "core/component_graph/component_registry.hpp"

#include <array>

#include "core/contract/registered.hpp"

// A test may add a second list to prove that a line and a file are all a component needs.
#ifndef PHYTOBENCH_EXTRA_COMPONENTS
#define PHYTOBENCH_EXTRA_COMPONENTS "core/component_graph/no_extra_components.def"
#endif

namespace phytobench {

namespace components {
#define COMPONENT(name, dependency) extern const ComponentKind name;
#include "core/component_graph/components.def"
#include PHYTOBENCH_EXTRA_COMPONENTS
#undef COMPONENT
}  // namespace components

namespace {

constexpr auto component_table = std::to_array<const ComponentKind*>({
#define COMPONENT(name, dependency) &components::name,
#include "core/component_graph/components.def"
#include PHYTOBENCH_EXTRA_COMPONENTS
#undef COMPONENT
});

}  // namespace

std::span<const ComponentKind* const> all_component_kinds() {
  return component_table;
}

std::string known_component_kind_names() {
  return registered_names(all_component_kinds());
}

const ComponentKind& component_kind_named(std::string_view name) {
  return registered_as(name, "kind of component", all_component_kinds());
}

}  // namespace phytobench
