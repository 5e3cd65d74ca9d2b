// SPDX-License-Identifier: MIT
// Eq. 2.17: what its angles decide, what the sense of rolls decides, and what neither does.
#include <cmath>
#include <numbers>

#include "core/lsystem/drawing_measures.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/path_lengths.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int steps = space_tree_steps;
constexpr double radians = std::numbers::pi / 180.0;

/// At forks: how far branches lean away from the line they leave, and how far apart two that follow
/// each other stand around it.
void measure_forks(ExperimentContext& context, const std::string& name, const Skeleton& skeleton) {
  const ChildLists children(skeleton);
  Range lean, apart;
  std::int64_t forks = 0;
  const auto along = [&](std::int32_t node) {
    const Vector3 edge = skeleton.position(node) -
                         skeleton.position(skeleton.parents()[static_cast<std::size_t>(node)]);
    return edge / norm(edge);
  };
  const auto angle_deg = [](const Vector3& u, const Vector3& v) {
    return std::atan2(norm(cross(u, v)), dot(u, v)) / radians;
  };
  for (std::int32_t node = 1; node < static_cast<std::int32_t>(skeleton.node_count()); ++node) {
    const std::span<const std::int32_t> branches = children.of(node);
    if (branches.size() < 2) continue;
    ++forks;
    const Vector3 stem = along(node);
    const auto aside = [&](std::int32_t branch) {
      return along(branch) - dot(along(branch), stem) * stem;
    };
    for (std::size_t i = 0; i < branches.size(); ++i) {
      lean.extend(angle_deg(stem, along(branches[i])));
      if (i > 0) apart.extend(angle_deg(aside(branches[i - 1]), aside(branches[i])));
    }
  }
  context.record(name + "forks", forks);
  lean.record(context, name + "branching_angle", "deg");
  apart.record(context, name + "divergence_angle", "deg");
}

/// What does not depend on angles, and what the sense of rolls decides.
void measure_relations(ExperimentContext& context) {
  const LSystem other = space_tree_system(50.0, "start: local", 90.0);
  const Word word = derived(other, steps);
  context.record("other_angles/drawn_length", total_length(draw(other, word)), "length");
  tip_path_lengths(turtle_tree(other, word).skeleton)
      .record(context, "other_angles/path_to_tip", "length");

  const LSystem left = space_tree_system(pitch_a_deg),
                right = space_tree_system(pitch_a_deg, "start: local turtle: cpfg");
  const Drawing by_words = draw(left, derived(left, steps));
  Drawing rolled_back = draw(right, derived(right, steps));
  context.record("rolled_the_other_way/off", segments_off(rolled_back.segments, by_words.segments),
                 "length");
  for (TurtleSegment& s : rolled_back.segments) {
    s.from.y = -s.from.y;
    s.to.y = -s.to.y;
  }
  context.record("rolled_the_other_way/mirrored_off",
                 segments_off(rolled_back.segments, by_words.segments), "length");
}

/// The axiom that the cited page of The Algorithmic Beauty of Plants has, without widths.
void measure_source(ExperimentContext& context) {
  const LSystem source = parse_lsystem(
      "axiom: F(200)/(45)A\nstart: local\n"
      "p1 : A -> F(50)[&(18.95)F(50)A]/(137.5)[&(18.95)F(50)A]/(137.5)[&(18.95)F(50)A]\n"
      "p2 : F(l) -> F(l * 1.3)\n",
      "equation 2.17 with a trunk");
  const Word word = derived(source, steps);
  const Skeleton skeleton = turtle_tree(source, word).skeleton;
  context.record("source/lines", static_cast<std::int64_t>(skeleton.edge_count()));
  tip_path_lengths(skeleton).record(context, "source/path_to_tip", "length");
}

void run(ExperimentContext& context) {
  for (const auto& [name, pitch_deg] :
       {std::pair{"a/", pitch_a_deg}, std::pair{"b/", pitch_b_deg}}) {
    const LSystem system = space_tree_system(pitch_deg);
    measure_forks(context, name, turtle_tree(system, derived(system, steps)).skeleton);
  }
  measure_relations(context);
  measure_source(context);
}

}  // namespace

extern const ExperimentDescriptor space_tree_angles;
constinit const ExperimentDescriptor space_tree_angles{
    .id = "liebemann2017/space-tree-angles",
    .question = "What do the angles of eq. 2.17 decide, and what not?",
    .source = "[Liebemann2017] sec. 2.3.3, eq. 2.17, fig. 2.6",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
