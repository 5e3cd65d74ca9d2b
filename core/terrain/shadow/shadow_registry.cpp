// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/shadow_registry.hpp"

#include <array>

#include "core/contract/registered.hpp"

// A test may add a second list to prove that a line and a file are all an engine needs.
#ifndef PHYTOBENCH_EXTRA_SHADOW_ENGINES
#define PHYTOBENCH_EXTRA_SHADOW_ENGINES "core/terrain/shadow/no_extra_shadow_engines.def"
#endif

namespace phytobench {

namespace shadow_engines {
#define SHADOW(name, dependency) extern const ShadowEngineDescriptor name;
#include "core/terrain/shadow/shadow_engines.def"
#include PHYTOBENCH_EXTRA_SHADOW_ENGINES
#undef SHADOW
}  // namespace shadow_engines

namespace {

constexpr auto table = std::to_array<const ShadowEngineDescriptor*>({
#define SHADOW(name, dependency) &shadow_engines::name,
#include "core/terrain/shadow/shadow_engines.def"
#include PHYTOBENCH_EXTRA_SHADOW_ENGINES
#undef SHADOW
});

}  // namespace

std::span<const ShadowEngineDescriptor* const> all_shadow_engines() {
  return table;
}

std::string known_shadow_engine_names() {
  return registered_names(all_shadow_engines());
}

const ShadowEngineDescriptor& shadow_engine_named(std::string_view name) {
  return registered_as(name, "engine", all_shadow_engines());
}

}  // namespace phytobench
