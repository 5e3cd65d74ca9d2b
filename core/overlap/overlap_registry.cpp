// SPDX-License-Identifier: MIT
#include "core/overlap/overlap_registry.hpp"

#include <array>

#include "core/contract/errors.hpp"

// A test may add a second list to prove that a line and a file are all an engine needs.
#ifndef PHYTOBENCH_EXTRA_OVERLAP_ENGINES
#define PHYTOBENCH_EXTRA_OVERLAP_ENGINES "core/overlap/no_extra_overlap_engines.def"
#endif

namespace phytobench {

namespace overlap_engines {
#define OVERLAP(name, dependency) extern const OverlapEngineDescriptor name;
#include "core/overlap/overlap_engines.def"
#include PHYTOBENCH_EXTRA_OVERLAP_ENGINES
#undef OVERLAP
}  // namespace overlap_engines

namespace {

constexpr auto table = std::to_array<const OverlapEngineDescriptor*>({
#define OVERLAP(name, dependency) &overlap_engines::name,
#include "core/overlap/overlap_engines.def"
#include PHYTOBENCH_EXTRA_OVERLAP_ENGINES
#undef OVERLAP
});

}  // namespace

std::span<const OverlapEngineDescriptor* const> all_overlap_engines() {
  return table;
}

std::string known_overlap_engine_names() {
  std::string names;
  for (const OverlapEngineDescriptor* engine : table) {
    if (!names.empty()) names += ", ";
    names += engine->name;
  }
  return names;
}

const OverlapEngineDescriptor& overlap_engine_named(std::string_view name) {
  for (const OverlapEngineDescriptor* engine : table) {
    if (engine->name != name) continue;
    if (engine->built()) return *engine;
    throw InputError("engine '" + std::string(name) +
                     "' is not built: " + std::string(engine->missing_package) +
                     " was not found, or left out, when phytobench was configured; install it and "
                     "build again");
  }
  throw InputError("unknown engine '" + std::string(name) +
                   "'; known: " + known_overlap_engine_names());
}

}  // namespace phytobench
