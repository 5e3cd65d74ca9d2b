// SPDX-License-Identifier: MIT
// The plant of eq. 6 after one step and after seven: letters, box and branching.
#include <algorithm>
#include <array>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "core/tree/branches.hpp"
#include "experiments/brzoska2019/drawn_plant_picture.hpp"
#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/lsystem_closed_forms.hpp"
#include "reference/oracles/turtle_2d.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

struct LetterName {
  const char* letter;
  const char* name;
};
constexpr std::array<LetterName, 6> letter_names{{{"F", "segments"},
                                                  {"X", "apices"},
                                                  {"+", "plus"},
                                                  {"-", "minus"},
                                                  {"[", "open"},
                                                  {"]", "close"}}};

std::uint64_t count_of(const LSystem& system, const Word& word, const char* letter) {
  return symbol_counts(system, word)[*find_symbol(system, letter, 0)];
}

int deepest_nesting(const std::string& word) {
  int depth = 0, deepest = 0;
  for (const char letter : word) {
    depth += letter == '[' ? 1 : letter == ']' ? -1 : 0;
    deepest = std::max(deepest, depth);
  }
  return deepest;
}

/// Greatest distance of a segment's end from that of the literal turtle.
double distance_from_oracle(const Drawing& ours, const std::string& word) {
  const auto literal =
      oracles::turtle_2d(oracles::modules_of(word), {.length = 1.0, .angle_deg = 10.0});
  if (literal.segments.size() != ours.segments.size()) return 1e9;
  double largest = 0.0;
  for (std::size_t i = 0; i < ours.segments.size(); ++i)
    largest = std::max(largest, norm(ours.segments[i].to - Vector3{literal.segments[i].to.x,
                                                                   literal.segments[i].to.y, 0.0}));
  return largest;
}

void record_tree(ExperimentContext& context, const std::string& name, const Skeleton& tree) {
  context.record(name + "nodes", whole(tree.node_count()), "nodes");
  context.record(name + "tips", whole(tip_count(tree)), "nodes");
  context.record(name + "depth", whole(edge_depth(tree)), "segments");
  for (const auto& [children, nodes] : child_counts(tree))
    context.record(fmt::format("{}children-{}", name, children), whole(nodes), "nodes");
  context.record(name + "root_radius", branch_radii(tree, 1.0, 2.0)[0], "radii of tips");
}

void add_picture(ExperimentContext& context, const LSystem& system, const Word& word) {
  DrawingPlantOptions options;
  options.radii = BranchRadii::widths;
  options.length_of_width = 1.4;
  options.circle_resolution = 3;
  Camera front;
  front.elevation_deg = 0.0;
  add_plant_picture(context, "figure-14-right", make_drawing_plant(system, word, options), options,
                    front, false);
}

void record_stage(ExperimentContext& context, const LSystem& system, int n) {
  const std::string name = fmt::format("n-{}/", n);
  const Word word = derived(system, n);
  context.record(name + "letters", whole(word.size()), "letters");
  for (const auto& [letter, its_name] : letter_names)
    context.record(name + its_name, static_cast<std::int64_t>(count_of(system, word, letter)),
                   "letters");
  const std::string text = text_of(system, word);
  context.record(name + "deepest_nesting", std::int64_t{deepest_nesting(text)});
  const Drawing plant = draw(system, word);
  const BoundingBox box = segment_box(plant);
  context.record(name + "low_x", box.low().x, "d");
  context.record(name + "high_x", box.high().x, "d");
  context.record(name + "low_y", box.low().y, "d");
  context.record(name + "high_y", box.high().y, "d");
  context.record(name + "differs_from_oracle", distance_from_oracle(plant, text), "d");
  record_tree(context, name, turtle_tree(system, word).skeleton);
  if (n == 1)
    context.artifact("figure-14-left.svg", drawing_svg(plant, "eq. 6 after one step"));
  else
    add_picture(context, system, word);
}

/// How often X and F come of one of each, and all letters beside their closed forms.
void record_growth(ExperimentContext& context, const LSystem& system) {
  constexpr int most_steps = 10;
  std::int64_t compared = 0, differ = 0;
  DeriveOptions options;
  options.steps = most_steps;
  options.threads = context.untimed_threads();
  options.each_word = [&](int n, const Word& word) {
    using namespace oracles;
    const std::array expected = {equation_6_F(n),    equation_6_X(n),     equation_6_plus(n),
                                 equation_6_plus(n), equation_6_pairs(n), equation_6_pairs(n)};
    for (std::size_t i = 0; i < expected.size(); ++i, ++compared)
      differ += count_of(system, word, letter_names[i].letter) != expected[i];
    differ += word.size() != equation_6_letters(n);
    ++compared;
    context.record(fmt::format("growth/n-{}/apices", n),
                   static_cast<std::int64_t>(count_of(system, word, "X")), "letters");
    context.record(fmt::format("growth/n-{}/segments", n),
                   static_cast<std::int64_t>(count_of(system, word, "F")), "letters");
  };
  derive(system, options);
  context.record("growth/counts", compared, "counts");
  context.record("growth/other_than_closed_forms", differ, "counts");
  const LSystem segment = with_axiom(system, "F");
  for (int n = 1; n <= 4; ++n)
    context.record(fmt::format("segment/n-{}/segments", n), whole(word_after(segment, n).size()),
                   "letters");
}

void run(ExperimentContext& context) {
  const LSystem system = thesis_l_system(equation_6_text);
  record_growth(context, system);
  for (const int n : {1, 7}) record_stage(context, system, n);
}

}  // namespace

extern const ExperimentDescriptor figure_14;
constinit const ExperimentDescriptor figure_14{
    .id = "brzoska2019/figure-14",
    .question = "What plant does eq. 6 draw after one step and after seven?",
    .source = "[Brzoska2019] eq. 6, fig. 14",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
