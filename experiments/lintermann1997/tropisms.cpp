// SPDX-License-Identifier: MIT
// Sec. 4 and 5.2: trees and leaves that turn to where light comes from and where weight pulls, and
// worlds that replace both fields.
#include "core/component_graph/shapes/outward_frame.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr Vector3 up{0.0, 1.0, 0.0}, down{0.0, -1.0, 0.0};

/// At the origin, leaning from the vertical by an angle.
SingleComponent leaning(const char* kind, double from_up_deg, const std::string& keys) {
  SingleComponent component(kind, keys);
  component.frame = outward_frame({}, 30.0, from_up_deg);
  return component;
}

double end_angle(const SingleComponent& component, const Vector3& to) {
  return angle_deg(component.frame.direction(component.child().y), to);
}

void record_horn_and_tree(ExperimentContext& context) {
  const auto positions = [](const char* kind, const char* keys) {
    const TriangleMesh mesh = SingleComponent(kind, keys).mesh();
    return std::vector<Vector3>(mesh.positions.begin(), mesh.positions.end());
  };
  const char* bent = "bend_first = 6\nbend_last = -9";
  context.record("tree_without_tropism/distance_to_horn",
                 greatest_distance(positions("tree", bent), positions("horn", bent)), "length");
}

/// In a constant field the angle to it falls as d(angle) / ds = -w sin(angle) along the axis.
double angle_by_the_law(double angle_deg, double weight_deg) {
  return 2.0 *
         degrees_of(std::atan(std::tan(radians(0.5 * angle_deg)) * std::exp(-radians(weight_deg))));
}

void record_gravitropism(ExperimentContext& context) {
  double from_law = 0.0, by_pieces = 0.0;
  for (const double weight : {0.0, 30.0, 60.0, 120.0, 240.0, 480.0}) {
    const auto with_pieces = [&](int pieces) {
      return end_angle(
          leaning("tree", 70.0, fmt::format("gravitropism = {}\nsegments = {}", weight, pieces)),
          down);
    };
    const double angle = with_pieces(14);
    context.record(fmt::format("gravity-{:.0f}/angle_to_weight", weight), angle, "degrees");
    from_law = std::fmax(from_law, std::abs(angle - angle_by_the_law(110.0, weight)));
    by_pieces = std::fmax(by_pieces, std::abs(with_pieces(1) - with_pieces(200)));
  }
  context.record("gravity/deviation_from_law", from_law, "degrees");
  context.record("gravity/difference_by_number_of_pieces", by_pieces, "degrees");
}

void record_phototropism(ExperimentContext& context) {
  for (const double weight : {0.0, 60.0, 240.0})
    context.record(fmt::format("light-{:.0f}/angle_to_light", weight),
                   end_angle(leaning("tree", 70.0, fmt::format("phototropism = {}", weight)), up),
                   "degrees");
  context.record("both_equal/angle_to_light",
                 end_angle(leaning("tree", 70.0, "phototropism = 90\ngravitropism = 90"), up),
                 "degrees");
  for (const double weight : {0.0, 60.0, 240.0})
    context.record(
        fmt::format("leaf/gravity-{:.0f}/angle_to_weight", weight),
        end_angle(leaning("leaf", 70.0, fmt::format("bend = 0\ngravitropism = {}", weight)), down),
        "degrees");
}

/// A tree beside another one that stands in a world of its own.
std::vector<Vector3> in_world(const std::string& world, const std::string& tree,
                              double time = 0.0) {
  return positions_of(graph_of(
      fmt::format("[graph]\nroot = \"w\"\ntime = {}\n[component.w]\nkind = \"world\"\n{}\n"
                  "[component.s]\nkind = \"simple\"\nshape = \"none\"\nmove_x = 2\nturn_z = 40\n"
                  "[component.t]\nkind = \"tree\"\nsegments = 300\nradius_first = 1e-6\n"
                  "radius_last = 1e-6\n{}\n[[link]]\nfrom = \"w\"\nto = \"s\"\n"
                  "[[link]]\nfrom = \"s\"\nto = \"t\"\n",
                  time, world, tree)));
}

void record_worlds(ExperimentContext& context) {
  const std::string both = "phototropism = 70\ngravitropism = 30";
  const std::vector<Vector3> without = in_world("", both);
  context.record(
      "world/up_and_down/distance",
      greatest_distance(
          without, in_world("photo = [\"0\", \"2\", \"0\"]\ngravi = [\"0\", \"-5\", \"0\"]", both)),
      "length");
  context.record("world/no_light/distance",
                 greatest_distance(in_world("photo = [\"0\", \"0\", \"0\"]", "phototropism = 900"),
                                   in_world("", "")),
                 "length");
  // Turned to it at once, the tree grows straight to the lamp from where it stands.
  const Vector3 foot{2.0, 0.0, 0.0}, lamp{1.0, 0.5, 1.5}, way = lamp - foot;
  const Vector3 tip =
      in_world("photo = [\"1 - x\", \"0.5 - y\", \"1.5 - z\"]", "phototropism = 9000").back();
  context.record("world/lamp/angle_to_lamp", angle_deg(tip - foot, way), "degrees");
  const std::string turning = "gravi = [\"cos(90 * t)\", \"0\", \"sin(90 * t)\"]";
  for (const double time : {0.0, 1.0}) {
    const Vector3 late = in_world(turning, "gravitropism = 9000\nlength = 9", time).back() - foot;
    const Vector3 pull{time == 0.0 ? 1.0 : 0.0, 0.0, time == 0.0 ? 0.0 : 1.0};
    context.record(fmt::format("world/time-{:.0f}/angle_to_weight", time), angle_deg(late, pull),
                   "degrees");
  }
}

void run(ExperimentContext& context) {
  record_horn_and_tree(context);
  record_gravitropism(context);
  record_phototropism(context);
  record_worlds(context);
}

}  // namespace

extern const ExperimentDescriptor tropisms;
constinit const ExperimentDescriptor tropisms{
    .id = "lintermann1997/tropisms",
    .question = "How do light and weight turn trees and leaves, and what does a world change?",
    .source = "[Lintermann1997] sec. 4, 5.2",
    .seconds = {0.05, 0.05, 0.05},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
