// SPDX-License-Identifier: MIT
// Figure 4: how hydra, ring and phiball turn and place what they multiply; and the transformation
// that a simple component applies to what follows (sec. 4).
#include "core/component_graph/shapes/outward_frame.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr std::size_t counts[] = {2, 3, 6, 18};

struct Deviations {
  double origin = 0.0;   ///< from the centre, or from the circle or sphere
  double outward = 0.0;  ///< of a child's direction from that away from the centre, degrees
  double step = 0.0;     ///< of the azimuth from child to child, degrees
  double copy = 0.0;     ///< of a child's axes from those of the first, turned about the axis
};

void add_steps(const std::vector<Frame>& children, double step_deg, Deviations& deviations) {
  for (std::size_t i = 0; i < children.size(); ++i) {
    const Frame& next = children[(i + 1) % children.size()];
    const double step = azimuth_step_deg(children[i].y, next.y);
    deviations.step = std::fmax(deviations.step, std::abs(step - step_deg));
    const Rotation turn =
        Rotation::about({0.0, 1.0, 0.0}, radians(step_deg * static_cast<double>(i)));
    const Frame copy = children[0].turned(turn);
    for (const Vector3& difference : {children[i].x - copy.x, children[i].y - copy.y})
      deviations.copy = std::fmax(deviations.copy, norm(difference));
  }
}

void record_hydra(ExperimentContext& context) {
  Deviations deviations;
  double tilt = 0.0;
  for (const std::size_t n : counts) {
    const SingleComponent hydra("hydra", fmt::format("count = {}\ntilt = 70", n));
    const std::vector<Frame> children = hydra.children(n);
    add_steps(children, 360.0 / static_cast<double>(n), deviations);
    for (const Frame& child : children) {
      deviations.origin = std::fmax(deviations.origin, norm(child.origin));
      tilt = std::fmax(tilt, std::abs(angle_deg(child.y, {0.0, 1.0, 0.0}) - 70.0));
    }
  }
  context.record("hydra/distance_of_origins", deviations.origin, "length");
  context.record("hydra/step_deviation", deviations.step, "degrees");
  context.record("hydra/tilt_deviation", tilt, "degrees");
  context.record("hydra/copy_deviation", deviations.copy);
}

void record_ring(ExperimentContext& context) {
  Deviations deviations;
  double apart = 1e9;
  for (const std::size_t n : counts) {
    const SingleComponent ring("ring", fmt::format("count = {}\nradius = 0.3", n));
    const std::vector<Frame> children = ring.children(n);
    add_steps(children, 360.0 / static_cast<double>(n), deviations);
    for (const Frame& child : children) {
      const double from_circle = std::hypot(norm(child.origin) - 0.3, child.origin.y);
      deviations.origin = std::fmax(deviations.origin, from_circle);
      deviations.outward = std::fmax(deviations.outward, angle_deg(child.y, child.origin));
    }
    apart = std::fmin(apart, norm(children[1].origin - children[0].origin));
  }
  context.record("ring/deviation_from_circle", deviations.origin, "length");
  context.record("ring/outward_deviation", deviations.outward, "degrees");
  context.record("ring/step_deviation", deviations.step, "degrees");
  context.record("ring/copy_deviation", deviations.copy);
  context.record("ring/smallest_distance_of_neighbours", apart, "length");
}

void record_phiball(ExperimentContext& context) {
  Deviations deviations;
  const SingleComponent ball("phiball", "count = 200\nradius = 0.7\npolar_first = 10");
  for (const Frame& child : ball.children(200)) {
    deviations.origin = std::fmax(deviations.origin, std::abs(norm(child.origin) - 0.7));
    deviations.outward = std::fmax(deviations.outward, angle_deg(child.y, child.origin));
  }
  context.record("phiball/deviation_from_sphere", deviations.origin, "length");
  context.record("phiball/outward_deviation", deviations.outward, "degrees");
}

/// Scaled, turned about x, then y, then z, then moved: the three matrices written out.
Vector3 transformed(const Vector3& p, double scale, const Vector3& turn_deg, const Vector3& move) {
  const double a = radians(turn_deg.x), b = radians(turn_deg.y), c = radians(turn_deg.z);
  const Vector3 s = scale * p;
  const Vector3 x{s.x, std::cos(a) * s.y - std::sin(a) * s.z,
                  std::sin(a) * s.y + std::cos(a) * s.z};
  const Vector3 y{std::cos(b) * x.x + std::sin(b) * x.z, x.y,
                  -std::sin(b) * x.x + std::cos(b) * x.z};
  const Vector3 z{std::cos(c) * y.x - std::sin(c) * y.y, std::sin(c) * y.x + std::cos(c) * y.y,
                  y.z};
  return z + move;
}

/// Two components behind each other, the first without and with a transformation.
void record_simple(ExperimentContext& context) {
  const auto graph = [](const char* keys) {
    return graph_of(
        fmt::format("[graph]\nroot = \"a\"\n[component.a]\nkind = \"simple\"\n"
                    "shape = \"none\"\n{}\n[component.b]\nkind = \"horn\"\n"
                    "bend_first = 9\n[[link]]\nfrom = \"a\"\nto = \"b\"\n",
                    keys));
  };
  std::vector<Vector3> expected = positions_of(graph(""));
  for (Vector3& p : expected) p = transformed(p, 1.75, {25.0, -40.0, 110.0}, {0.5, -2.0, 3.0});
  const std::vector<Vector3> placed = positions_of(
      graph("scale = 1.75\nturn_x = 25\nturn_y = -40\nturn_z = 110\nmove_x = 0.5\nmove_y = -2\n"
            "move_z = 3"));
  context.record("simple/transformed_vertices", static_cast<std::int64_t>(placed.size()));
  context.record("simple/deviation_from_matrices", greatest_distance(placed, expected), "length");
}

void run(ExperimentContext& context) {
  record_hydra(context);
  record_ring(context);
  record_phiball(context);
  record_simple(context);
}

}  // namespace

extern const ExperimentDescriptor component_placement;
constinit const ExperimentDescriptor component_placement{
    .id = "lintermann1997/component-placement",
    .question = "Where do multipliers place their children, and how do these look?",
    .source = "[Lintermann1997] sec. 4, fig. 4",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
