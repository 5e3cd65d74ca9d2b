// SPDX-License-Identifier: MIT
#include "core/overlap/overlap_registry.hpp"

#include <array>

#include "core/contract/registered.hpp"

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
  return registered_names(all_overlap_engines());
}

const OverlapEngineDescriptor& overlap_engine_named(std::string_view name) {
  return registered_as(name, "engine", all_overlap_engines());
}

}  // namespace phytobench
