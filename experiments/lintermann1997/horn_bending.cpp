// SPDX-License-Identifier: MIT
// Sec. 5.1: a cone bent by two rotations, one between its first two pieces and one between its last
// two, interpolated for the joints in between.
#include "core/component_graph/shapes/outward_frame.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

constexpr std::size_t corners = 6;

SingleComponent horn(int joints, double first, double last) {
  return SingleComponent(
      "horn", fmt::format("segments = {}\ncorners = {}\nbend_first = {}\nbend_last = {}\n"
                          "radius_first = 0.01\nradius_last = 0.01\ncaps = \"none\"",
                          joints + 1, corners, first, last));
}

/// Signed, from each piece of the axis to the next, from y to z. The axis goes through the middles
/// of the point sets.
std::vector<double> turns_of(const SingleComponent& horn) {
  const TriangleMesh mesh = horn.mesh();
  std::vector<Vector3> middles;
  for (std::size_t set = 0; set * (corners + 1) < mesh.vertex_count(); ++set) {
    Vector3 sum;
    for (std::size_t i = 0; i < corners; ++i) sum = sum + mesh.positions[set * (corners + 1) + i];
    middles.push_back(sum / corners);
  }
  std::vector<double> turns;
  for (std::size_t i = 1; i + 1 < middles.size(); ++i) {
    const Vector3 a = middles[i] - middles[i - 1], b = middles[i + 1] - middles[i];
    turns.push_back(degrees_of(std::atan2(a.y * b.z - a.z * b.y, dot(a, b))));
  }
  return turns;
}

void record_joints(ExperimentContext& context) {
  constexpr std::pair<double, double> bends[] = {{3.2, -0.8}, {-7.0, -1.0}, {5.0, 5.0}, {0.0, 4.0}};
  double first_turn = 0.0, last_turn = 0.0, inner = 0.0, total = 0.0;
  for (const int m : {2, 3, 7, 16})
    for (const auto& [r_0, r_1] : bends) {
      const std::vector<double> turns = turns_of(horn(m, r_0, r_1));
      first_turn = std::fmax(first_turn, std::abs(turns.front() - r_0));
      last_turn = std::fmax(last_turn, std::abs(turns.back() - r_1));
      double sum = 0.0;
      for (int joint = 1; joint <= m; ++joint) {
        const double turn = turns[static_cast<std::size_t>(joint) - 1];
        inner = std::fmax(inner, std::abs(turn - oracle::turn_at_joint(r_0, r_1, m, joint)));
        sum += turn;
      }
      total = std::fmax(total, std::abs(sum - oracle::total_turn(r_0, r_1, m)));
    }
  context.record("first_turn_deviation", first_turn, "degrees");
  context.record("last_turn_deviation", last_turn, "degrees");
  context.record("difference_to_linear", inner, "degrees");
  context.record("difference_to_total_turn", total, "degrees");
}

void record_special_cases(ExperimentContext& context) {
  context.record("one_joint/turn", turns_of(horn(1, 8.0, 2.0)).at(0), "degrees");
  // Equal turns: the joints lie on a circle, the end on a chord of it.
  const double turn = radians(5.0);
  const double chord = 1.0 / 12.0 * std::sin(6.0 * turn) / std::sin(0.5 * turn);
  context.record("equal_turns/ratio_to_chord", norm(horn(11, 5.0, 5.0).child().origin) / chord);
  std::int64_t changes = 0;
  const std::vector<double> turns = turns_of(horn(15, 3.2, -0.8));
  for (std::size_t i = 1; i < turns.size(); ++i) changes += turns[i - 1] * turns[i] < 0.0;
  context.record("opposite_turns/changes_of_side", changes);
  context.record("no_turns/end_height", horn(7, 0.0, 0.0).child().origin.y, "length");
}

/// A horn that stands on another begins where that ends, in its direction.
void record_next_horn(ExperimentContext& context) {
  const Frame end = horn(7, 4.0, 12.0).child();
  context.record("next/turn", angle_deg(end.y, {0.0, 1.0, 0.0}), "degrees");
}

void run(ExperimentContext& context) {
  record_joints(context);
  record_special_cases(context);
  record_next_horn(context);
}

}  // namespace

extern const ExperimentDescriptor horn_bending;
constinit const ExperimentDescriptor horn_bending{
    .id = "lintermann1997/horn-bending",
    .question = "How is a horn bent by the rotations at its beginning and its end?",
    .source = "[Lintermann1997] sec. 5.1",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
