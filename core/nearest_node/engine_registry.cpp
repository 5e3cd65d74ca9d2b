// SPDX-License-Identifier: MIT
#include "core/nearest_node/engine_registry.hpp"

#include <array>

#include "core/contract/registered.hpp"

// A test may add a second list to prove that a line and a file are all an engine needs.
#ifndef PHYTOBENCH_EXTRA_ENGINES
#define PHYTOBENCH_EXTRA_ENGINES "core/nearest_node/no_extra_engines.def"
#endif

namespace phytobench {

namespace engines {
#define ENGINE(name, dependency) extern const EngineDescriptor name;
#include "core/nearest_node/engines.def"
#include PHYTOBENCH_EXTRA_ENGINES
#undef ENGINE
}  // namespace engines

namespace {

constexpr auto table = std::to_array<const EngineDescriptor*>({
#define ENGINE(name, dependency) &engines::name,
#include "core/nearest_node/engines.def"
#include PHYTOBENCH_EXTRA_ENGINES
#undef ENGINE
});

}  // namespace

std::span<const EngineDescriptor* const> all_engines() {
  return table;
}

std::string known_engine_names() {
  return registered_names(all_engines());
}

const EngineDescriptor& engine_named(std::string_view name) {
  return registered_as(name, "engine", all_engines());
}

}  // namespace phytobench
