// SPDX-License-Identifier: MIT
// Sec. 4: free-form deformation of all that follows a component, or of branches without leaves.
#include <array>

#include "core/component_graph/shapes/lattice_deformation.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/single_component.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr std::size_t points = 4;  // control points in each direction

/// Bernstein polynomials of degree 3, written out.
std::array<double, points> bernstein(double t) {
  const double s = 1.0 - t;
  return {s * s * s, 3.0 * s * s * t, 3.0 * s * t * t, t * t * t};
}

/// Over the box from (-1, 0, -1) to (1, 2, 1).
Lattice lattice_of(std::vector<Vector3> moves) {
  Lattice lattice;
  lattice.low = {-1.0, 0.0, -1.0};
  lattice.high = {1.0, 2.0, 1.0};
  lattice.points = {points, points, points};
  lattice.moves = std::move(moves);
  return lattice;
}

Vector3 moved_by_definition(const Vector3& p, const std::vector<Vector3>& moves) {
  const auto u = bernstein(0.5 * (p.x + 1.0)), v = bernstein(0.5 * p.y);
  const auto w = bernstein(0.5 * (p.z + 1.0));
  Vector3 sum = p;
  for (std::size_t k = 0; k < points; ++k)
    for (std::size_t j = 0; j < points; ++j)
      for (std::size_t i = 0; i < points; ++i)
        sum = sum + (u[i] * v[j] * w[k]) * moves[i + points * (j + points * k)];
  return sum;
}

Vector3 random_vector(CounterStream& random, double reach) {
  Vector3 v;
  for (double* part : {&v.x, &v.y, &v.z}) *part = random.next_between(-reach, reach);
  return v;
}

void record_definition(ExperimentContext& context) {
  CounterStream random(context.seed(), 1);
  std::vector<Vector3> moves;
  for (std::size_t i = 0; i < points * points * points; ++i)
    moves.push_back(random_vector(random, 0.5));
  const LatticeDeformation map(Frame{}, lattice_of(moves), Bends::all);
  double deviation = 0.0;
  constexpr int places = 500;
  for (int i = 0; i < places; ++i) {
    const Vector3 place = random_vector(random, 1.0) + Vector3{0.0, 1.0, 0.0};
    deviation = std::fmax(deviation, norm(map.moved(place) - moved_by_definition(place, moves)));
  }
  Record record;
  record.measurement = "deviation_from_definition";
  record.value = deviation;
  record.unit = "length";
  record.sample_size = places;
  record.seed = context.seed();
  context.record(std::move(record));
}

/// Every second control point along y is pushed aside. The tree's bark comes before its leaves.
ComponentGraph tree_below(const char* bends) {
  std::string moves;
  for (int point = 0; point < 27; ++point)
    moves += point / 3 % 3 == 1 ? "0.4, 0, 0.1, " : "0, 0, 0, ";
  return graph_of(fmt::format(
      "[graph]\nroot = \"all\"\n[component.all]\nkind = \"simple\"\nshape = \"none\"\n"
      "[component.ffd]\nkind = \"ffd\"\npoints_x = 3\npoints_y = 3\npoints_z = 3\n{}\n"
      "[component.tree]\nkind = \"tree\"\nsegments = 20\n[component.leaf]\nkind = \"leaf\"\n"
      "[component.beside]\nkind = \"horn\"\nsurface = \"plain\"\n"
      "[[link]]\nfrom = \"all\"\nto = \"ffd\"\n[[link]]\nfrom = \"ffd\"\nto = \"tree\"\n"
      "[[link]]\nfrom = \"tree\"\nto = \"leaf\"\nkind = \"branch\"\n"
      "[[link]]\nfrom = \"all\"\nto = \"beside\"\n",
      *bends == 0 ? "" : fmt::format("moves = [{}]\nbends = \"{}\"", moves, bends)));
}

struct Changes {
  double moved = 0.0;   ///< greatest distance that a vertex goes
  double strain = 0.0;  ///< greatest relative change of the length of an edge
};

Changes changes_between(const TriangleMesh& before, const TriangleMesh& behind) {
  Changes changes;
  for (std::size_t i = 0; i < before.vertex_count(); ++i)
    changes.moved = std::fmax(changes.moved, norm(before.positions[i] - behind.positions[i]));
  for (const Triangle& t : before.triangles)
    for (std::size_t i = 0; i < 3; ++i) {
      const auto length = [&](const TriangleMesh& mesh) {
        return norm(mesh.positions[t[i]] - mesh.positions[t[(i + 1) % 3]]);
      };
      if (length(before) == 0.0) continue;
      changes.strain = std::fmax(changes.strain, std::abs(length(behind) / length(before) - 1.0));
    }
  return changes;
}

void record_parts(ExperimentContext& context) {
  const BuiltPlant before = build_plant(tree_below(""));
  for (const char* bends : {"all", "all_but_leaves", "leaves"}) {
    const BuiltPlant behind = build_plant(tree_below(bends));
    constexpr const char* parts[] = {"branches", "leaves", "beside"};
    for (std::size_t part = 0; part < 3; ++part) {
      const Changes changes =
          changes_between(before.parts.at(part).mesh, behind.parts.at(part).mesh);
      const std::string name = fmt::format("{}/{}/", bends, parts[part]);
      const bool keeps_its_shape = part == 1 && std::string_view(bends) == "all_but_leaves";
      if (part == 2 || keeps_its_shape) context.record(name + "moved", changes.moved, "length");
      if (part < 2) context.record(name + "strain", changes.strain);
    }
  }
}

void run(ExperimentContext& context) {
  record_definition(context);
  record_parts(context);
}

}  // namespace

extern const ExperimentDescriptor free_form_deformation;
constinit const ExperimentDescriptor free_form_deformation{
    .id = "lintermann1997/free-form-deformation",
    .question = "Does a free-form deformation bend all data, or branches without their leaves?",
    .source = "[Lintermann1997] sec. 4",
    .seconds = {0.05, 0.05, 0.05},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
