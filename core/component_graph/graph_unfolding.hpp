// SPDX-License-Identifier: MIT
// What counting instances and making them have in common.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/component_graph/instance_identity.hpp"
#include "core/component_graph/instance_tree.hpp"

namespace phytobench {

class GraphUnfolding {
 public:
  /// Throws InputError for what recursion_problem() refuses.
  GraphUnfolding(const ComponentGraph& graph, const InstanceLimits& limits);

  /// Raises the counter of a prototype while it lives, and lowers it again.
  class Visit {
   public:
    Visit(GraphUnfolding& unfolding, std::uint32_t prototype);
    ~Visit();
    Visit(const Visit&) = delete;
    Visit& operator=(const Visit&) = delete;

   private:
    GraphUnfolding& unfolding_;
    std::uint32_t prototype_;
  };

  /// Instances of a prototype on the present way.
  std::uint32_t depth(std::uint32_t prototype) const { return depth_[prototype]; }

  /// Whether one more instance of the prototype may follow on the present way.
  bool may_follow(std::uint32_t prototype) const;

  /// Calls use(position of the link, n) for the links that make n >= 1 instances below `instance`,
  /// which is being visited: leaf links last, and only if the recursion has ended here. Stops where
  /// `use` returns false.
  template <class Use>
  void for_each_link(const Instance& instance, const Use& use) const {
    bool recursion_has_ended = false;
    for (const std::uint32_t position : links_of_[instance.prototype]) {
      const ComponentLink& link = graph_.links[position];
      if (link.kind == LinkKind::leaf && !recursion_has_ended) continue;
      if (!may_follow(link.to)) {
        recursion_has_ended = recursion_has_ended || multiplicity(link, instance) > 0;
        continue;
      }
      const std::uint64_t n = multiplicity(link, instance);
      if (n > 0 && !use(position, n)) return;
    }
  }

  /// Whether all instances of a prototype that stand at one place have subtrees of one size.
  bool siblings_are_alike(std::uint32_t prototype) const { return alike_[prototype]; }

  Instance root() const;
  /// The i-th of n that the link makes below `parent`, which is at `position`.
  Instance child(const Instance& parent, std::uint32_t position, std::uint32_t link,
                 SiblingNumber number) const;

 private:
  /// Targets that a link makes below an instance: 1 for leaf links.
  std::uint64_t multiplicity(const ComponentLink& link, const Instance& source) const;
  void find_links();
  void find_alike();

  const ComponentGraph& graph_;
  InstanceLimits limits_;
  std::vector<std::vector<std::uint32_t>> links_of_;  // per prototype, leaf links last
  std::vector<bool> alike_;
  std::vector<std::uint32_t> depth_;
  std::uint32_t levels_ = 0;
};

}  // namespace phytobench
