// SPDX-License-Identifier: MIT
// Kinds of components without geometry, and graphs of them, for tests.
#pragma once

#include <array>
#include <string>
#include <utility>

#include "core/component_graph/component_graph.hpp"

namespace phytobench::test_components {

inline void place_nowhere(const ComponentInput&, LinkKind, std::span<Frame>) {}

inline std::uint64_t first_count(const ComponentValues& values) {
  return values.count(0);
}

inline constexpr std::array count_key{ComponentKey{
    .name = "count",
    .unit = "1",
    .meaning = "how many",
    .source = "own",
    .default_text = "3",
    .kind =
        RangedNumber{.range = {.low = 0.0, .high = 0x1p40, .whole = true}, .default_value = 3.0}}};

inline constexpr ComponentKind plain{.name = "plain",
                                     .summary = "One child per link.",
                                     .source = "own",
                                     .place_children = place_nowhere};
inline constexpr ComponentKind multiplier{.name = "multiplier",
                                          .summary = "Several children per link.",
                                          .source = "own",
                                          .keys = count_key,
                                          .is_multiplier = true,
                                          .child_count = first_count,
                                          .place_children = place_nowhere};
inline constexpr ComponentKind bearer{.name = "bearer",
                                      .summary = "Several branches per branch link.",
                                      .source = "own",
                                      .keys = count_key,
                                      .carries_branches = true,
                                      .branch_count = first_count,
                                      .place_children = place_nowhere};

/// Builds graphs by name; the first component is the root.
class GraphMaker {
 public:
  GraphMaker& add(const std::string& name, const ComponentKind& kind = plain,
                  std::uint32_t most_recursions = 0) {
    Prototype prototype = make_prototype(name, kind);
    if (most_recursions > 0) prototype.most_recursions = most_recursions;
    graph_.prototypes.push_back(std::move(prototype));
    return *this;
  }

  GraphMaker& add_counted(const std::string& name, const ComponentKind& kind, double count,
                          std::uint32_t most_recursions = 0) {
    add(name, kind, most_recursions);
    graph_.prototypes.back().settings[0] = ParameterRange::of(count);
    return *this;
  }

  GraphMaker& link(const std::string& from, const std::string& to,
                   LinkKind kind = LinkKind::child) {
    graph_.links.push_back({position(from), position(to), kind});
    return *this;
  }

  std::uint32_t position(const std::string& name) const {
    std::uint32_t i = 0;
    while (graph_.prototypes.at(i).name != name) ++i;
    return i;
  }

  ComponentGraph graph() const { return graph_; }

 private:
  ComponentGraph graph_;
};

/// The example of [Lintermann1997] sec. 3.1.1: a root, a stem, a multiplier by three, and a part of
/// a branch that follows itself.
inline GraphMaker published_example(std::uint32_t most_recursions = 3) {
  GraphMaker maker;
  maker.add("A").add("B").add_counted("C", multiplier, 3.0).add("D", plain, most_recursions);
  maker.link("A", "B").link("B", "C").link("C", "D").link("D", "D");
  return maker;
}

}  // namespace phytobench::test_components
