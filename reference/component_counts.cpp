// SPDX-License-Identifier: MIT
#include "reference/component_counts.hpp"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "reference/oracles/lintermann1997_instance_counts.hpp"

namespace phytobench {

namespace {

using oracles::lintermann1997::CountedComponent;
using oracles::lintermann1997::Link;
using oracles::lintermann1997::Sibling;
using Settings = std::vector<ComponentSetting>;

bool uses_random(const ParameterRange& range) {
  return range.function && range.function->uses_random();
}

/// Whether siblings may get different numbers.
bool uses_sibling(const ParameterRange& range) {
  const bool has_span =
      std::any_of(range.frames.begin(), range.frames.end(),
                  [](const KeyFrame& frame) { return frame.value.first != frame.value.last; });
  if (!range.function) return has_span;
  constexpr std::uint16_t i = 1, n = 2;  // among value, i, n, depth and t
  const auto& program = range.function->program();
  return has_span ||
         std::any_of(program.begin(), program.end(), [](const Expression::Instruction& step) {
           return step.operation == Expression::Operation::parameter &&
                  (step.index == i || step.index == n);
         });
}

/// The settings with no number where `is_unknown`: a component that asks for one of these is
/// refused, so that what it gives otherwise does not depend on them.
template <class Predicate>
Settings without(const Settings& settings, const Predicate& is_unknown) {
  Settings rest = settings;
  for (ComponentSetting& setting : rest) {
    const auto* range = std::get_if<ParameterRange>(&setting);
    if (range != nullptr && is_unknown(*range))
      setting = ParameterRange::of(std::numeric_limits<double>::quiet_NaN());
  }
  return rest;
}

/// How many instances the links of one prototype ask for.
class Multiplicity {
 public:
  Multiplicity(const ComponentGraph& graph, const Prototype& prototype)
      : kind_(prototype.kind),
        time_(graph.time),
        for_siblings_(without(prototype.settings, uses_random)),
        for_all_(without(for_siblings_, uses_sibling)) {}

  std::optional<std::uint64_t> operator()(Link link, int depth,
                                          const std::optional<Sibling>& sibling) const {
    const auto& count = link == Link::branch ? kind_->branch_count : kind_->child_count;
    if (link == Link::leaf || (link == Link::child && !kind_->is_multiplier)) return 1;
    PHYTOBENCH_EXPECT(count != nullptr);
    InstancePlace place;
    if (sibling)
      place.number = {static_cast<std::uint32_t>(sibling->i),
                      static_cast<std::uint32_t>(sibling->n)};
    place.depth = static_cast<std::uint32_t>(depth);
    place.time = time_;
    try {
      return count(ComponentValues(kind_->keys, sibling ? for_siblings_ : for_all_, place));
    } catch (const InputError&) {
      return std::nullopt;
    }
  }

 private:
  const ComponentKind* kind_;
  double time_;
  Settings for_siblings_;  // without what chance decides
  Settings for_all_;       // and without what differs among siblings
};

Link link_of(LinkKind kind) {
  if (kind == LinkKind::branch) return Link::branch;
  return kind == LinkKind::leaf ? Link::leaf : Link::child;
}

std::vector<CountedComponent> translated(const ComponentGraph& graph) {
  std::vector<CountedComponent> components;
  for (const Prototype& prototype : graph.prototypes) {
    CountedComponent component;
    if (prototype.most_recursions)
      component.maximal_recursions = static_cast<int>(*prototype.most_recursions);
    component.times = Multiplicity(graph, prototype);
    components.push_back(std::move(component));
  }
  for (const ComponentLink& link : graph.links)
    components[link.from].edges.push_back({link.to, link_of(link.kind)});
  return components;
}

}  // namespace

PredictedCounts predicted_counts(const ComponentGraph& graph) {
  constexpr std::size_t most_numbers = 4'000'000;  // that the grammar's table holds
  constexpr std::size_t most_productions = 100'000;
  const std::size_t size = graph.prototypes.size();
  PHYTOBENCH_EXPECT(graph.root < size);
  auto counts = oracles::lintermann1997::instance_counts(
      translated(graph), graph.root, std::min(most_productions, most_numbers / size));
  if (counts) return {.instances = std::move(*counts)};
  return {.instances = std::vector<std::optional<std::uint64_t>>(size), .is_too_large = true};
}

std::string count_disagreement(const ComponentGraph& graph, std::span<const std::uint64_t> made,
                               const PredictedCounts& predicted) {
  PHYTOBENCH_EXPECT(made.size() == graph.prototypes.size());
  PHYTOBENCH_EXPECT(predicted.instances.size() == made.size());
  for (std::size_t i = 0; i < made.size(); ++i)
    if (predicted.instances[i] && *predicted.instances[i] != made[i])
      return fmt::format("component '{}' has {} instances where its grammar counts {}",
                         graph.prototypes[i].name, made[i], *predicted.instances[i]);
  return {};
}

}  // namespace phytobench
