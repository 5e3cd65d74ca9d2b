// SPDX-License-Identifier: MIT
// Sec. 4.4.3: rings of the cylinders that stand for edges. The end ring is said to lie in a plane
// across the start normal: do cylinders of a branch then meet?
#include <set>

#include "core/geometry/rotation.hpp"
#include "core/tree/branch_mesh.hpp"
#include "experiments/liebemann2017/limited_growth.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int corners = 8;

/// A branch of unit edges that turns by this angle at each node.
Skeleton bent_branch(double turn_deg) {
  Skeleton branch{Vector3{}};
  for (int v = 0; v < 12; ++v) {
    const double heading = v * turn_deg * std::numbers::pi / 180.0;
    branch.append(v, branch.position(v) + Vector3{std::sin(heading), std::cos(heading), 0});
  }
  return branch;
}

/// Rings of all edges as printed: both across the start normal, which is the end normal of the
/// predecessor's edge. Greatest distance of corners that should be one between the end ring of an
/// edge and the start ring of the next, as a share of the radius.
double printed_gap(const Skeleton& skeleton, const std::vector<double>& radii) {
  const std::vector<Vector3> normals = ring_normals(skeleton, radii, SingleChildNormal::bisector);
  std::vector<Rotation> turned{Rotation::between({0, 1, 0}, normals[0])};
  double gap = 0.0;
  for (std::size_t v = 1; v < skeleton.node_count(); ++v) {
    const auto below = static_cast<std::size_t>(skeleton.parents()[v]);
    turned.push_back(Rotation::between(normals[below], normals[v]) * turned[below]);
    const auto end = ring(skeleton.positions()[v], radii[v], turned[below], corners);
    const auto start_of_next = ring(skeleton.positions()[v], radii[v], turned[v], corners);
    for (std::size_t i = 0; i < end.size(); ++i)
      gap = std::max(gap, norm(end[i] - start_of_next[i]) / radii[v]);
  }
  return gap;
}

/// Faults of the mesh that the core makes.
struct Faults {
  double off_centre = 0.0, off_radius = 0.0, off_plane = 0.0;
  std::int64_t edges_elsewhere = 0;  // whose triangles do not join the two nodes' rings
};

Vector3 centre_of(const TriangleMesh& mesh, std::size_t ring_number) {
  Vector3 sum;
  for (int i = 0; i < corners; ++i)
    sum = sum + mesh.positions[ring_number * (corners + 1) + static_cast<std::size_t>(i)];
  return sum / corners;
}

void check_rings(const Skeleton& skeleton, const std::vector<double>& radii,
                 const TriangleMesh& mesh, Faults& faults) {
  const std::vector<Vector3> normals = ring_normals(skeleton, radii, SingleChildNormal::bisector);
  for (std::size_t v = 0; v < skeleton.node_count(); ++v) {
    faults.off_centre =
        std::max(faults.off_centre, norm(centre_of(mesh, v) - skeleton.positions()[v]));
    for (std::size_t i = 0; i <= corners; ++i) {
      const Vector3 spoke = mesh.positions[v * (corners + 1) + i] - skeleton.positions()[v];
      faults.off_radius = std::max(faults.off_radius, std::abs(norm(spoke) - radii[v]));
      faults.off_plane = std::max(faults.off_plane, std::abs(dot(spoke, normals[v])));
    }
  }
}

/// Triangles join the ring of a node to that of its predecessor, or to one more at the
/// predecessor's place: the end ring of an edge is where those of the next edges start.
void check_joints(const Skeleton& skeleton, const TriangleMesh& mesh, Faults& faults) {
  std::vector<std::int64_t> triangles(skeleton.node_count(), 0);
  for (const auto& triangle : mesh.triangles) {
    std::set<std::size_t> rings;
    for (const auto vertex : triangle)
      rings.insert(static_cast<std::size_t>(vertex) / (corners + 1));
    bool joined = false;
    for (const std::size_t end : rings) {
      if (rings.size() != 2 || end == 0 || end >= skeleton.node_count()) continue;
      const std::size_t start = *rings.begin() == end ? *rings.rbegin() : *rings.begin();
      const Vector3 place = skeleton.position(skeleton.parents()[end]);
      if (norm(centre_of(mesh, start) - place) > 1e-9) continue;
      joined = true;
      ++triangles[end];
    }
    faults.edges_elsewhere += !joined;
  }
  for (std::size_t v = 1; v < triangles.size(); ++v)
    faults.edges_elsewhere += triangles[v] != 2 * corners;
}

void measure_mesh(ExperimentContext& context, const std::string& name, const Skeleton& skeleton) {
  const std::vector<double> radii = branch_radii(skeleton, tip_radius, ring_g);
  BranchMeshOptions options;
  options.circle_resolution = corners;
  const TriangleMesh mesh = mesh_branches(skeleton, radii, options).mesh;
  Faults faults;
  check_rings(skeleton, radii, mesh, faults);
  check_joints(skeleton, mesh, faults);
  record_seeded(context, name + "/centre_off_node", faults.off_centre, "length");
  record_seeded(context, name + "/radius_off", faults.off_radius, "length");
  record_seeded(context, name + "/corners_off_plane", faults.off_plane, "length");
  record_seeded(context, name + "/edges_that_do_not_meet", faults.edges_elsewhere);
  record_seeded(context, name + "/printed_gap", printed_gap(skeleton, radii));
}

void run(ExperimentContext& context) {
  for (const int turn : {0, 10, 30, 60})
    measure_mesh(context, fmt::format("bent-branch/turn-{}", turn), bent_branch(turn));
  measure_mesh(context, "grown-tree", grow(quarter_scene(context.seed(), 0)).skeleton);
}

}  // namespace

extern const ExperimentDescriptor end_rings;
constinit const ExperimentDescriptor end_rings{
    .id = "liebemann2017/end-rings",
    .question = "Do the cylinders of neighbouring edges meet?",
    .source = "[Liebemann2017] sec. 4.4.3",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
