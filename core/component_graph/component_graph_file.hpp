// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>

#include "core/component_graph/component_graph.hpp"

namespace phytobench {

inline constexpr std::size_t most_components = 256;
inline constexpr std::size_t most_links = 1000;
inline constexpr int most_recursions_allowed = 1000;

/// Reads a graph of components from a TOML file:
///   [graph] root, seed, time; [component.NAME] kind, most_recursions and the keys of the kind;
///   [[link]] from, to, kind = "child", "branch" or "leaf".
/// Missing keys take their defaults. Throws InputError with file, line, key and what is allowed;
/// also for what recursion_problem() refuses, branch links from components that bear none, and
/// components that no links reach.
ComponentGraph read_component_graph(const std::filesystem::path& file);

/// The same from text; `name` stands for the file in messages.
ComponentGraph parse_component_graph(std::string_view text, std::string_view name);

/// A small graph with a component of that kind, every key at its default, each with meaning, unit,
/// range and source. It can be read and built.
std::string example_component_graph(const ComponentKind& kind);

}  // namespace phytobench
