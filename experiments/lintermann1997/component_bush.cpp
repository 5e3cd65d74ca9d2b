// SPDX-License-Identifier: MIT
// Sec. 5.3: the bush as components, and what it has in common with the L-system of sec. 2.1.
#include "core/lsystem/derive.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"
#include "reference/oracles/lintermann1997_bush.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr int recursions = 5;

/// Slashes turn and do not count here; they are those of The Algorithmic Beauty of Plants.
constexpr const char* bush_system =
    "axiom: A\nangle: 22.5\nA -> [&FL!A]/////'[&FL!A]///////'[&FL!A]\nF -> S/////F\nS -> FL\n"
    "L -> ['''^^{-f+f+f-|-f+f+f}]\n";

/// The limit is at the multiplier, with which the recursion begins.
ComponentGraph bush(const std::string& multiplier, int most_recursions) {
  return graph_of(fmt::format(
      "[graph]\nroot = \"fork\"\n[component.fork]\nkind = \"{}\"\ncount = 3\n"
      "most_recursions = {}\n[component.twig]\nkind = \"tree\"\nbranches = "
      "2\n[component.blade]\nkind = \"leaf\"\n"
      "[[link]]\nfrom = \"fork\"\nto = \"twig\"\n[[link]]\nfrom = \"twig\"\nto = \"fork\"\n"
      "[[link]]\nfrom = \"twig\"\nto = \"blade\"\nkind = \"branch\"\n",
      multiplier, most_recursions));
}

void record_counts(ExperimentContext& context) {
  for (int k = 1; k <= recursions; ++k) {
    const std::string name = fmt::format("recursion-{}/", k);
    const auto made = instances_by_name(bush("phiball", k));
    context.record(name + "phiballs", made.at("fork"));
    context.record(name + "trees", made.at("twig"));
    context.record(name + "leaves", made.at("blade"));
    const auto star = instances_by_name(bush("hydra", k));
    context.record(name + "trees_by_hydra", star.at("twig"));
    context.record(name + "oracle_groups",
                   static_cast<std::int64_t>(oracles::lintermann1997::bush_groups(k)));
  }
}

/// The three of a phiball and of a hydra do not stand alike.
void record_directions(ExperimentContext& context) {
  for (const char* kind : {"phiball", "hydra"}) {
    const char* keys = *kind == 'p' ? "count = 3\nradius = 0\npolar_last = 60" : "count = 3";
    const auto three = SingleComponent(kind, keys).children(3);
    const std::string name = fmt::format("three_of_{}/", kind);
    for (std::size_t i = 0; i < 3; ++i)
      context.record(fmt::format("{}step-{}", name, i + 1),
                     azimuth_step_deg(three[i].y, three[(i + 1) % 3].y), "degrees");
    context.record(name + "difference_of_tilts",
                   angle_deg(three[2].y, {0, 1, 0}) - angle_deg(three[0].y, {0, 1, 0}), "degrees");
  }
}

/// A branch of the L-system's plant is a group "[&...]". What it carries itself, without the groups
/// within it.
struct Branch {
  int depth = 0;
  std::int64_t groups = 0, segments = 0, polygons = 0;
};

std::vector<Branch> branches_of(const std::string& word) {
  std::vector<Branch> branches;
  std::vector<std::size_t> open;  // positions in `branches`
  std::vector<bool> bracket_is_group;
  for (std::size_t i = 0; i < word.size(); ++i) {
    const char c = word[i];
    if (c == '[') {
      bracket_is_group.push_back(word[i + 1] == '&');
      if (!bracket_is_group.back()) continue;
      if (!open.empty()) ++branches[open.back()].groups;
      open.push_back(branches.size());
      branches.emplace_back().depth = static_cast<int>(open.size());
    } else if (c == ']') {
      if (bracket_is_group.back()) open.pop_back();
      bracket_is_group.pop_back();
    } else if (!open.empty()) {
      branches[open.back()].segments += c == 'F';
      branches[open.back()].polygons += c == '{';
    }
  }
  return branches;
}

void record_lsystem(ExperimentContext& context) {
  const LSystem system = parse_lsystem(bush_system, "bush");
  const std::vector<Branch> branches =
      branches_of(text_of(system, derive(system, {.steps = recursions})));
  context.record("l_system/branches", static_cast<std::int64_t>(branches.size()));
  for (int depth = 1; depth <= recursions; ++depth) {
    std::int64_t count = 0, with_three = 0, with_leaves = 0, segments = 0;
    for (const Branch& branch : branches) {
      if (branch.depth != depth) continue;
      ++count;
      with_three += branch.groups == 3;
      with_leaves += branch.polygons > 0;
      segments += branch.segments;
    }
    const std::string name = fmt::format("l_system/depth-{}/", depth);
    context.record(name + "branches", count);
    context.record(name + "with_three_branches", with_three);
    context.record(name + "with_leaves", with_leaves);
    context.record(name + "segments_per_branch",
                   static_cast<double>(segments) / static_cast<double>(count));
  }
}

void run(ExperimentContext& context) {
  record_counts(context);
  record_directions(context);
  record_lsystem(context);
}

}  // namespace

extern const ExperimentDescriptor component_bush;
constinit const ExperimentDescriptor component_bush{
    .id = "lintermann1997/component-bush",
    .question = "What has the bush of components in common with that of the L-system?",
    .source = "[Lintermann1997] sec. 5.3, fig. 8",
    .seconds = {0.02, 0.02, 0.02},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
