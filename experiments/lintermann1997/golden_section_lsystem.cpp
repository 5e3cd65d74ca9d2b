// SPDX-License-Identifier: MIT
// Sec. 2.1 says that L-systems cannot place by the golden section without other programs. Two
// parametric L-systems that do: on the disc of a sunflower, and on a sphere.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/component_graph/component_graph_file.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;

constexpr const char* constants =
    "angle: 90\nstart: local\n"
    "phi = (1 + sqrt(5)) / 2\n"
    "golden = 360 / phi ^ 2\n";

/// Seed i stands at sqrt(i) from the middle, turned by i golden angles; a short line marks it.
std::string disc_text(int count) {
  return fmt::format(
      "{}N = {}\naxiom: A(1)\n"
      "A(i) : i <= N -> [+(i * golden)f(sqrt(i))F(0.4)]A(i + 1)\n",
      constants, count);
}

/// The same on a sphere: height 1 - (2 i + 1) / N over its middle, i from 0.
std::string sphere_text(int count) {
  return fmt::format(
      "{}N = {}\naxiom: A(0, 1 - 1 / N)\n"
      "A(i, h) : i < N -> [\\(i * golden)^(90 - atan(h / sqrt(1 - h ^ 2)))f(1)F(0.1)]"
      "A(i + 1, h - 2 / N)\n",
      constants, count);
}

std::vector<Vector3> places_of(const Drawing& drawing) {
  std::vector<Vector3> places;
  for (const TurtleSegment& segment : drawing.segments) places.push_back(segment.from);
  return places;
}

std::vector<Vector3> places_of_phiball(int count) {
  const ComponentGraph graph = parse_component_graph(
      fmt::format("[graph]\nroot = \"ball\"\n[component.ball]\nkind = \"phiball\"\ncount = {}\n",
                  count),
      "phiball");
  const Prototype& ball = graph.prototypes.at(0);
  const ComponentValues values(ball.kind->keys, ball.settings, InstancePlace{});
  std::vector<Frame> frames(static_cast<std::size_t>(count));
  ball.kind->place_children({values, Frame{}, BuildContext{}}, LinkKind::child, frames);
  std::vector<Vector3> places;
  for (const Frame& frame : frames) places.push_back(frame.origin);
  return places;
}

/// Between all pairs; says whether two sets are the same but for a motion or a mirror.
double largest_difference_of_distances(const std::vector<Vector3>& a,
                                       const std::vector<Vector3>& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.size(); ++i)
    for (std::size_t j = 0; j < i; ++j)
      largest = std::max(largest, std::abs(norm(a[i] - a[j]) - norm(b[i] - b[j])));
  return largest;
}

void record_disc(ExperimentContext& context, int count) {
  const LSystem system = parse_lsystem(disc_text(count), "sunflower");
  const Drawing drawing = draw(system, derived(system, count + 1));
  const std::vector<Vector3> places = places_of(drawing);
  const std::vector<oracle::Place> expected = oracle::places_on_disc(count);
  double farthest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    farthest = std::max(farthest,
                        norm(places.at(i) - Vector3{expected[i].x, expected[i].y, expected[i].z}));
  std::vector<oracle::Place> drawn;
  for (const Vector3& p : places) drawn.push_back({p.x, p.y, p.z});
  const oracle::ClosestPair closest = oracle::closest_pair(drawn);
  context.record("disc/places", static_cast<std::int64_t>(places.size()));
  context.record("disc/farthest_from_golden_section", farthest);
  context.record("disc/closest_distance", closest.distance);
  context.record("disc/productions", static_cast<std::int64_t>(system.productions.size()));
  context.artifact("sunflower-by-an-l-system.svg", drawing_svg(drawing, "Seeds by golden section"));
}

void record_sphere(ExperimentContext& context, int count) {
  const LSystem system = parse_lsystem(sphere_text(count), "ball");
  const std::vector<Vector3> places = places_of(draw(system, derived(system, count + 1)));
  const std::vector<oracle::Place> expected = oracle::places_on_cap(count, 1, 0, 180);
  double farthest = 0.0;
  for (std::size_t i = 0; i < expected.size(); ++i)
    farthest = std::max(farthest,
                        norm(places.at(i) - Vector3{expected[i].z, expected[i].y, expected[i].x}));
  context.record("sphere/places", static_cast<std::int64_t>(places.size()));
  context.record("sphere/farthest_from_golden_section", farthest);
  context.record("sphere/largest_difference_of_distances_from_phiball",
                 largest_difference_of_distances(places, places_of_phiball(count)));
}

void run(ExperimentContext& context) {
  const int count = 300;
  record_disc(context, count);
  record_sphere(context, count);
}

}  // namespace

extern const ExperimentDescriptor golden_section_lsystem;
constinit const ExperimentDescriptor golden_section_lsystem{
    .id = "lintermann1997/golden-section-lsystem",
    .question = "Can an L-system place by the golden section without another program?",
    .source = "[Lintermann1997] sec. 2.1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
