// SPDX-License-Identifier: MIT
#include "core/nearest_node/engine_registry.hpp"

#include <array>

#include "core/contract/errors.hpp"

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
  std::string names;
  for (const EngineDescriptor* engine : table) {
    if (!names.empty()) names += ", ";
    names += engine->name;
  }
  return names;
}

const EngineDescriptor& engine_named(std::string_view name) {
  for (const EngineDescriptor* engine : table) {
    if (engine->name != name) continue;
    if (engine->built()) return *engine;
    throw InputError(
        "engine '" + std::string(name) + "' is not built: " + std::string(engine->missing_package) +
        " was not found, or left out, when phytobench was configured; install it and build "
        "again");
  }
  throw InputError("unknown engine '" + std::string(name) + "'; known: " + known_engine_names());
}

}  // namespace phytobench
