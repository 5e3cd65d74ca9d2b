// SPDX-License-Identifier: MIT
// The worked examples and properties of the equations that turn a skeleton into a plant: rings,
// radii, hanging branches, the camera.
#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "core/picture/camera.hpp"
#include "core/random/counter_stream.hpp"
#include "core/tree/branch_mesh.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/pendulous_branches.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

constexpr double degree = std::numbers::pi / 180.0;
constexpr Vector3 up{0.0, 1.0, 0.0};

double degrees(double radians) {
  return radians / degree;
}

double angle_between(const Vector3& a, const Vector3& b) {
  return std::atan2(norm(cross(a, b)), dot(a, b));
}

Vector3 random_direction(UnitStream& stream) {
  for (;;) {
    const double x = stream.next_between(-1.0, 1.0), y = stream.next_between(-1.0, 1.0);
    const Vector3 v{x, y, stream.next_between(-1.0, 1.0)};
    if (squared_norm(v) <= 1.0 && squared_norm(v) >= 1e-4) return v / norm(v);
  }
}

void record_circles(ExperimentContext& context) {
  double length = 0.0, height = 0.0, side = 0.0, centroid = 0.0;
  for (int w = 3; w <= 64; ++w) {
    const std::vector<Vector3> points = ring({}, 1.0, {}, w);
    Vector3 sum;
    for (std::size_t i = 0; i < points.size(); ++i) {
      const Vector3& next = points[(i + 1) % points.size()];
      length = std::max(length, std::abs(norm(points[i]) - 1.0));
      height = std::max(height, std::abs(points[i].y));
      side =
          std::max(side, std::abs(norm(next - points[i]) - 2.0 * std::sin(std::numbers::pi / w)));
      sum = sum + points[i];
    }
    centroid = std::max(centroid, norm(sum));
  }
  context.record("equation-1/max_length_error", length);
  context.record("equation-1/max_height", height);
  context.record("equation-2/max_side_error", side);
  context.record("equation-2/max_centroid", centroid);
  const std::vector<Vector3> hexagon = ring({}, 1.0, {}, 6);
  context.record("equation-2/hexagon_step", degrees(angle_between(hexagon[0], hexagon[1])),
                 "degree");
  // In a right-handed system the corners go clockwise seen from above (ambiguity A12).
  context.record("equation-1/right_handed_normal_y",
                 cross(hexagon[0], hexagon[1]).y > 0 ? 1.0 : -1.0);
}

void record_ring_turns(ExperimentContext& context) {
  CounterStream stream(context.seed(), 31);
  double turn = 0.0, radius = 0.0, offset = 0.0, centroid = 0.0;
  std::int64_t wrong_order_agrees = 0;
  constexpr int trials = 100000;
  for (int i = 0; i < trials; ++i) {
    const Vector3 n = random_direction(stream);
    const Rotation turned = Rotation::between(up, n);
    turn = std::max(turn, norm(turned(up) - n));
    if (i % 100 != 0) continue;
    const Vector3 center = 10.0 * random_direction(stream);
    const double r = stream.next_between(0.01, 2.0);
    const std::vector<Vector3> points = ring(center, r, turned, 7);
    Vector3 sum;
    for (const Vector3& point : points) {
      radius = std::max(radius, std::abs(norm(point - center) - r) / r);
      offset = std::max(offset, std::abs(dot(point - center, n)) / r);
      sum = sum + (point - center);
    }
    centroid = std::max(centroid, norm(sum) / r);
    // Moved before it is turned, a ring ends up elsewhere.
    const Vector3 wrong = turned(r * Vector3{1, 0, 0} + center);
    wrong_order_agrees += norm(wrong - points[0]) < 1e-6;
  }
  context.record("equation-3/max_error", turn);
  context.record("ring/max_radius_error", radius);
  context.record("ring/max_offset", offset);
  context.record("ring/max_centroid_error", centroid);
  context.record("ring/wrong_order_agrees", wrong_order_agrees);
  const Rotation sideways = Rotation::between(up, {1, 0, 0});
  context.record("equation-3/example_axis_z", sideways.axial().z / norm(sideways.axial()));
  context.record("equation-3/example_angle", degrees(2.0 * std::acos(sideways.w())), "degree");
  for (const double sign : {1.0, -1.0}) {
    const std::string name = sign > 0 ? "up" : "down";
    const Vector3 n = sign * up;
    double away = norm(Rotation::between(up, n)(up) - n);
    for (const Vector3& point : ring({}, 1.0, Rotation::between(up, n), 5))
      away = std::max(away, is_finite(point) ? std::abs(point.y) : 1.0);
    context.record("equation-3/degenerate_" + name + "_error", away);
  }
}

/// A fork whose two tips have radius 1.
Skeleton fork() {
  Skeleton tree({0, 0, 0});
  tree.append(0, {1, 1, 0});
  tree.append(0, {-1, 1, 0});
  return tree;
}

void record_radii(ExperimentContext& context) {
  for (const int n : {2, 3})
    context.record(fmt::format("equation-11/two_tips_n{}", n), branch_radii(fork(), 1.0, n)[0]);
  const TreeParameters parameters = thesis_tree("figure-51");
  const Skeleton tree = grow_thesis_tree(parameters, context.threads());
  const double n = parameters.plant.radius_exponent, tip = parameters.plant.tip_radius;
  const std::vector<double> radii = branch_radii(tree, tip, n);
  const ChildLists children(tree);
  double recursion = 0.0;
  std::int64_t thicker_than_parent = 0, chains_that_change = 0;
  for (std::size_t node = 0; node < tree.node_count(); ++node) {
    const auto above = children.of(static_cast<std::int32_t>(node));
    double sum = 0.0;
    for (const std::int32_t child : above) {
      const double r = radii[static_cast<std::size_t>(child)];
      sum += std::pow(r, n);
      thicker_than_parent += r > radii[node];
      chains_that_change += above.size() == 1 && r != radii[node];
    }
    const double expected = above.empty() ? tip : std::pow(sum, 1.0 / n);
    recursion = std::max(recursion, std::abs(radii[node] / expected - 1.0));
  }
  context.record("equation-12/max_recursion_error", recursion);
  context.record("equation-12/thicker_than_parent", thicker_than_parent);
  context.record("equation-12/chains_that_change", chains_that_change);
  context.record("equation-12/figure-51/root_radius", radii[0], "length");
  // One pass from the tips down against a walk from every tip to the root.
  std::int64_t walk = 0;
  const std::vector<std::int32_t> depths = node_depths(tree);
  for (std::size_t node = 1; node < tree.node_count(); ++node)
    if (children.of(static_cast<std::int32_t>(node)).empty()) walk += depths[node];
  context.record("equation-12/steps_from_every_tip", walk);
  context.record("equation-12/steps_in_one_pass", static_cast<std::int64_t>(tree.edge_count()));
}

void record_pendulous_angles(ExperimentContext& context) {
  constexpr double lambda = 0.8;
  const auto psi = [](double theta_deg) {
    return degrees(pendulous_angle(theta_deg * degree, lambda));
  };
  for (const int theta : {30, 60, 90, 120, 180})
    context.record(fmt::format("equation-13/psi_{}", theta), psi(theta), "degree");
  double symmetry = 0.0, formula = 0.0, largest = 0.0, at = 0.0;
  std::int64_t overshoots = 0, crossings = 0, fraction_rises = 0;
  for (double theta = 0.1; theta <= 180.0; theta += 0.1) {
    symmetry = std::max(symmetry, std::abs(psi(theta) - psi(180.0 - theta)));
    formula = std::max(formula, std::abs(psi(theta) - lambda * (1.0 - theta / 180.0) * theta));
    if (psi(theta) > largest) at = theta;
    largest = std::max(largest, psi(theta));
    overshoots += psi(theta) > theta || psi(theta) < -1e-12;
    crossings += theta - psi(theta) < theta - 0.1 - psi(theta - 0.1) - 1e-12;
    fraction_rises += psi(theta) / theta >= psi(theta - 0.1 + 1e-9) / (theta - 0.1 + 1e-9);
  }
  context.record("equation-13/symmetry_error", symmetry);
  context.record("equation-13/formula_error", formula);
  context.record("equation-13/largest", largest, "degree");
  context.record("equation-13/largest_at", at, "degree");
  context.record("equation-13/overshoots", overshoots);
  context.record("equation-13/crossings", crossings);
  context.record("equation-13/fraction_rises", fraction_rises);
}

double angle_to_ground_deg(const Skeleton& tree, std::size_t node) {
  const Vector3 edge = tree.positions()[node] - tree.position(tree.parents()[node]);
  return degrees(angle_between(edge, {0, -1, 0}));
}

/// Eq. 13 over its angle.
PlotPanel bending_panel() {
  PlotPanel panel{.curves = {},
                  .caption = "a) turn of one branch (13)",
                  .x_label = "angle θ to the downward vertical, degrees",
                  .y_label = "turn ψ, degrees",
                  .x_range = AxisRange{0.0, 180.0},
                  .y_range = AxisRange{0.0, 50.0}};
  for (const double lambda : {0.4, 0.8, 1.0}) {
    PlotCurve curve{.name = fmt::format("λ = {}", lambda), .x = {}, .y = {}};
    for (int theta = 0; theta <= 180; theta += 2) {
      curve.x.push_back(theta);
      curve.y.push_back(degrees(pendulous_angle(theta * degree, lambda)));
    }
    panel.curves.push_back(curve);
  }
  return panel;
}

void record_chain(ExperimentContext& context) {
  PlotPanel chain{.curves = {},
                  .caption = "b) a straight branch at 120°, edge by edge",
                  .x_label = "edges from the first bent one",
                  .y_label = "angle θ, degrees",
                  .y_range = AxisRange{0.0, 120.0}};
  Skeleton branch({0, 0, 0});
  branch.append(0, {0, 1, 0});
  const Vector3 step{std::sin(120 * degree), -std::cos(120 * degree), 0};
  for (std::int32_t i = 1; i < 7; ++i) branch.append(i, branch.position(i) + 0.5 * step);
  for (const double lambda : {0.4, 0.8}) {
    const Skeleton bent = bend_branches(branch, {.intensity = lambda, .first_order = 2});
    PlotCurve curve{
        .name = fmt::format("λ = {}", lambda), .x = {}, .y = {}, .style = PlotStyle::marked};
    for (std::size_t i = 2; i < bent.node_count(); ++i) {
      curve.x.push_back(static_cast<double>(i - 1));
      curve.y.push_back(angle_to_ground_deg(bent, i));
      context.record(fmt::format("chain/lambda-{}/step-{}", lambda, i - 1), curve.y.back(),
                     "degree");
    }
    chain.curves.push_back(curve);
  }
  add_plot(context, "equation-13",
           {.title = "How branches hang, by equation 13",
            .description = "Left, the turn of a branch over its angle to the downward vertical: "
                           "none straight up or down, the largest at a right angle. Right, the "
                           "angles of successive edges of a straight branch, each turned with all "
                           "below it: the branch nears the vertical and never passes it.",
            .panels = {bending_panel(), chain}});
  // Fig. 22: an upright main shoot and one side branch; bent from order 2 on.
  Skeleton plant({0, 0, 0});
  plant.append(0, {0, 1, 0});
  plant.append(1, {0, 2, 0});
  plant.append(1, Vector3{0, 1, 0} + step);
  const Skeleton bent = bend_branches(plant, {.intensity = 0.8, .first_order = 2});
  context.record("figure-22/main_shoot", angle_to_ground_deg(bent, 2), "degree");
  context.record("figure-22/side_branch", angle_to_ground_deg(bent, 3), "degree");
}

void record_camera(ExperimentContext& context) {
  CounterStream stream(context.seed(), 32);
  double distance = 0.0, view = 0.0, reach = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const Vector3 wanted = random_direction(stream);
    const Camera camera{.target = random_direction(stream),
                        .azimuth_deg = degrees(std::atan2(wanted.z, wanted.x)),
                        .elevation_deg = degrees(std::asin(std::clamp(wanted.y, -1.0, 1.0))),
                        .distance = stream.next_between(0.5, 50.0)};
    const Vector3 offset = camera.position() - camera.target;
    distance = std::max(distance, std::abs(norm(offset) / camera.distance - 1.0));
    view = std::max(view, norm(view_frame(camera).forward + offset / camera.distance));
    reach = std::max(reach, norm(offset / camera.distance - wanted));
  }
  context.record("camera/max_distance_error", distance);
  context.record("camera/max_view_error", view);
  context.record("camera/max_reach_error", reach);
  const Camera camera{.target = {1, 2, 3}};
  const Camera moved = camera.shifted({0, 0.5, 0});
  context.record("camera/shift_error",
                 norm((moved.position() - camera.position()) - (moved.target - camera.target)));
}

void run(ExperimentContext& context) {
  record_circles(context);
  record_ring_turns(context);
  context.progress("radii of the test tree");
  record_radii(context);
  record_pendulous_angles(context);
  record_chain(context);
  record_camera(context);
}

}  // namespace

extern const ExperimentDescriptor plant_equations;
constinit const ExperimentDescriptor plant_equations{
    .id = "brzoska2019/plant-equations",
    .question =
        "Do the equations for rings, radii, hanging branches and the camera give what the "
        "thesis says?",
    .source = "[Brzoska2019] eq. 1-3, 11-15, fig. 22, 25",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
