// SPDX-License-Identifier: MIT
#include "core/component_graph/graph_unfolding.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/component_graph/recursions.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

GraphUnfolding::GraphUnfolding(const ComponentGraph& graph, const InstanceLimits& limits)
    : graph_(graph),
      limits_(limits),
      links_of_(graph.prototypes.size()),
      alike_(graph.prototypes.size(), true),
      depth_(graph.prototypes.size(), 0) {
  PHYTOBENCH_EXPECT(graph.root < graph.prototypes.size());
  PHYTOBENCH_EXPECT(limits.most_instances < 0xffffffff);
  if (const auto problem = recursion_problem(graph)) throw InputError(problem->text);
  find_links();
  find_alike();
}

void GraphUnfolding::find_links() {
  for (std::uint32_t i = 0; i < graph_.links.size(); ++i)
    if (graph_.links[i].kind != LinkKind::leaf) links_of_[graph_.links[i].from].push_back(i);
  for (std::uint32_t i = 0; i < graph_.links.size(); ++i)
    if (graph_.links[i].kind == LinkKind::leaf) links_of_[graph_.links[i].from].push_back(i);
}

void GraphUnfolding::find_alike() {
  const auto reached = reached_prototypes(graph_);
  for (std::size_t varied = 0; varied < alike_.size(); ++varied) {
    if (!multiplicity_varies(graph_.prototypes[varied])) continue;
    alike_[varied] = false;
    for (std::size_t above = 0; above < alike_.size(); ++above)
      if (reached[above][varied]) alike_[above] = false;
  }
}

GraphUnfolding::Visit::Visit(GraphUnfolding& unfolding, std::uint32_t prototype)
    : unfolding_(unfolding), prototype_(prototype) {
  // Before anything changes: a constructor that throws has no destructor call.
  if (unfolding.levels_ == unfolding.limits_.most_levels)
    throw InputError(
        fmt::format("the plant would have more than {} levels of components within "
                    "each other; lower most_recursions (now at '{}')",
                    unfolding.limits_.most_levels, unfolding.graph_.prototypes[prototype].name));
  ++unfolding.levels_;
  ++unfolding.depth_[prototype];
}

GraphUnfolding::Visit::~Visit() {
  --unfolding_.levels_;
  --unfolding_.depth_[prototype_];
}

bool GraphUnfolding::may_follow(std::uint32_t prototype) const {
  const auto& most = graph_.prototypes[prototype].most_recursions;
  return !most || depth_[prototype] + 1 <= *most;
}

std::uint64_t GraphUnfolding::multiplicity(const ComponentLink& link,
                                           const Instance& source) const {
  const Prototype& prototype = graph_.prototypes[link.from];
  const ComponentKind& kind = *prototype.kind;
  const ComponentValues values(kind.keys, prototype.settings, place_of(graph_, source));
  switch (link.kind) {
    case LinkKind::child:
      return kind.is_multiplier ? kind.child_count(values) : 1;
    case LinkKind::branch:
      PHYTOBENCH_EXPECT(kind.carries_branches);
      return kind.branch_count(values);
    case LinkKind::leaf:
      break;
  }
  return 1;
}

Instance GraphUnfolding::root() const {
  Instance root;
  root.prototype = graph_.root;
  root.link = any_link;
  root.identity = identity_of_root;
  return root;
}

Instance GraphUnfolding::child(const Instance& parent, std::uint32_t position, std::uint32_t link,
                               SiblingNumber number) const {
  Instance child;
  child.prototype = graph_.links[link].to;
  child.parent = position;
  child.link = link;
  child.depth = depth_[child.prototype] + 1;
  child.number = number;
  child.identity = identity_of_child(parent.identity, link, number.i);
  return child;
}

InstancePlace place_of(const ComponentGraph& graph, const Instance& instance) {
  InstancePlace place;
  place.number = instance.number;
  place.depth = instance.depth;
  place.time = graph.time;
  place.seed = graph.seed;
  place.identity = instance.identity;
  return place;
}

}  // namespace phytobench
