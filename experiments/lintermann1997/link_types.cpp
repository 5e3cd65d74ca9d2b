// SPDX-License-Identifier: MIT
// Sec. 4.1: how many instances child, branch and leaf links make and where these stand, with
// and without recursions.
#include "core/contract/errors.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

std::string component(const char* name, const std::string& keys) {
  return fmt::format("[component.{}]\n{}\n", name, keys);
}
std::string link(const char* from, const char* to, const char* kind = "child") {
  return fmt::format("[[link]]\nfrom = \"{}\"\nto = \"{}\"\nkind = \"{}\"\n", from, to, kind);
}
std::string recursive(int most) {
  return fmt::format("\nmost_recursions = {}", most);
}
const std::string horn = "kind = \"horn\"", leaf = "kind = \"leaf\"";

std::map<std::string, std::int64_t> instances(const std::string& root, const std::string& text) {
  return instances_by_name(graph_of("[graph]\nroot = \"" + root + "\"\n" + text));
}

/// One tree with seven branches, something at its end, a multiplier of three, and a leaf on each.
void record_without_recursion(ExperimentContext& context) {
  const auto made = instances(
      "tree", component("tree", "kind = \"tree\"\nbranches = 7") + component("twig", horn) +
                  component("end", horn) + component("three", "kind = \"hydra\"\ncount = 3") +
                  component("hair", horn) + link("tree", "twig", "branch") + link("tree", "end") +
                  link("end", "three") + link("three", "hair"));
  context.record("one_tree/branches", made.at("twig"));
  context.record("one_tree/children", made.at("end"));
  context.record("one_tree/multiplied_children", made.at("hair"));
  const SingleComponent tree("tree", "branches = 7\nbranch_from = 0.2\nbranch_to = 0.8");
  const auto twigs = tree.frames(LinkKind::branch, 7);
  context.record("one_tree/lowest_branch", twigs.front().origin.y, "length");
  context.record("one_tree/highest_branch", twigs.back().origin.y, "length");
  context.record("one_tree/child_at", tree.child().origin.y, "length");
}

/// Four branches, or one child, of the tree itself: sums of powers.
void record_recursive_trees(ExperimentContext& context) {
  for (const int most : {1, 2, 3, 4})
    for (const char* kind : {"branch", "child"}) {
      const auto made =
          instances("tree", component("tree", "kind = \"tree\"\nbranches = 4" + recursive(most)) +
                                component("leaf", leaf) + link("tree", "tree", kind) +
                                link("tree", "leaf", "leaf"));
      const std::string name = fmt::format("recursion-{}/by_{}/", most, kind);
      context.record(name + "trees", made.at("tree"));
      context.record(name + "leaves", made.at("leaf"));
    }
}

/// What makes no sense under these meanings is refused instead of being ignored.
void record_refusals(ExperimentContext& context) {
  const auto refused = [](const std::string& text) -> std::int64_t {
    try {
      graph_of("[graph]\nroot = \"a\"\n" + text);
      return 0;
    } catch (const InputError&) {
      return 1;
    }
  };
  const std::string two = component("a", horn) + component("b", horn);
  context.record("refused/child_link", refused(two + link("a", "b")));
  context.record("refused/branch_link_from_horn", refused(two + link("a", "b", "branch")));
  context.record("refused/leaf_link_without_recursion", refused(two + link("a", "b", "leaf")));
}

void run(ExperimentContext& context) {
  record_without_recursion(context);
  record_recursive_trees(context);
  record_refusals(context);
}

}  // namespace

extern const ExperimentDescriptor link_types;
constinit const ExperimentDescriptor link_types{
    .id = "lintermann1997/link-types",
    .question = "How many instances do child, branch and leaf links make, and where?",
    .source = "[Lintermann1997] sec. 4.1",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
