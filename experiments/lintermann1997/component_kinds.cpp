// SPDX-License-Identifier: MIT
// Sec. 4 and figure 5: which kinds of components there are, in which groups, and which of them have
// tropisms and branches.
#include <algorithm>

#include "core/component_graph/component_registry.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

template <class Belongs>
std::string kinds_that(const Belongs& belongs) {
  std::string names;
  for (const ComponentKind* kind : all_component_kinds()) {
    if (!belongs(*kind)) continue;
    if (!names.empty()) names += ' ';
    names += kind->name;
  }
  return names;
}

bool makes_geometry(const ComponentKind& kind) {
  return kind.make_geometry != nullptr;
}
bool multiplies(const ComponentKind& kind) {
  return kind.is_multiplier;
}
bool changes_what_follows(const ComponentKind& kind) {
  return kind.change_context != nullptr;
}

const ComponentKey* key_named(const ComponentKind& kind, std::string_view name) {
  const auto found = std::find_if(kind.keys.begin(), kind.keys.end(),
                                  [&](const ComponentKey& key) { return key.name == name; });
  return found == kind.keys.end() ? nullptr : &*found;
}

std::string bodies_of_simple() {
  const ComponentKey* shape = key_named(component_kind_named("simple"), "shape");
  std::string bodies;
  for (const std::string_view word : std::get<WordChoice>(shape->kind).words) {
    if (!bodies.empty()) bodies += ' ';
    bodies += word;
  }
  return bodies;
}

std::int64_t kinds_not_in_one_group() {
  std::int64_t count = 0;
  for (const ComponentKind* kind : all_component_kinds())
    count +=
        int{makes_geometry(*kind)} + int{multiplies(*kind)} + int{changes_what_follows(*kind)} != 1;
  return count;
}

void run(ExperimentContext& context) {
  context.record("kinds", static_cast<std::int64_t>(all_component_kinds().size()));
  context.record("with_geometry", kinds_that(makes_geometry));
  context.record("multipliers", kinds_that(multiplies));
  context.record("deformers_and_fields", kinds_that(changes_what_follows));
  context.record("not_in_one_group", kinds_not_in_one_group());
  context.record("with_branches",
                 kinds_that([](const ComponentKind& kind) { return kind.carries_branches; }));
  for (const char* key : {"phototropism", "gravitropism"})
    context.record(std::string("with_") + key, kinds_that([&](const ComponentKind& kind) {
                     return key_named(kind, key) != nullptr;
                   }));
  context.record("bodies_of_simple", bodies_of_simple());
}

}  // namespace

extern const ExperimentDescriptor component_kinds;
constinit const ExperimentDescriptor component_kinds{
    .id = "lintermann1997/component-kinds",
    .question = "Which kinds of components are there, and what can each group of them do?",
    .source = "[Lintermann1997] sec. 4, fig. 5",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
