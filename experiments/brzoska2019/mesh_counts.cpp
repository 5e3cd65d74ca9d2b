// SPDX-License-Identifier: MIT
// What generalised cylinders cost: the tube of figure 4, trees of any shape, and single branchings,
// counted in their meshes.
#include <algorithm>
#include <array>
#include <cstdlib>
#include <set>

#include "core/random/counter_stream.hpp"
#include "core/tree/branch_mesh.hpp"
#include "core/tree/branches.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

std::size_t distinct_places(const TriangleMesh& mesh) {
  std::set<std::array<double, 3>> places;
  for (const Vector3& p : mesh.positions) places.insert({p.x, p.y, p.z});
  return places.size();
}

/// Figure 4, right: four rings of six points.
void record_tube(ExperimentContext& context) {
  Skeleton line({0, 0, 0});
  line.append(0, {0.2, 1.0, 0});
  line.append(1, {0.6, 1.9, 0.1});
  line.append(2, {1.2, 2.7, 0.3});
  const std::vector<double> radii{0.5, 0.45, 0.4, 0.36};
  const TriangleMesh mesh = mesh_branches(line, radii, {.circle_resolution = 6}).mesh;
  context.record("tube/rings", whole(line.node_count()));
  context.record("tube/segments", whole(line.edge_count()));
  context.record("tube/distinct_points", whole(distinct_places(mesh)));
  context.record("tube/vertices", whole(mesh.vertex_count()));
  context.record("tube/triangles", whole(mesh.triangle_count()));
}

/// A tree that branches at random: every new node hangs on any of the nodes before it.
Skeleton random_tree(UnitStream& stream, std::size_t nodes) {
  Skeleton tree({0, 0, 0});
  while (tree.node_count() < nodes) {
    const auto parent =
        static_cast<std::int32_t>(stream.next_between(0.0, static_cast<double>(tree.node_count())));
    const double x = stream.next_between(-1.0, 1.0), z = stream.next_between(-1.0, 1.0);
    const Vector3 edge{x, stream.next_between(0.1, 1.0), z};
    tree.append(parent, tree.position(parent) + edge);
  }
  return tree;
}

/// Children much thinner than their parent, counted from the definition.
std::size_t thin_children(const Skeleton& tree, const std::vector<double>& radii, double ratio) {
  std::size_t count = 0;
  for (std::size_t node = 1; node < tree.node_count(); ++node)
    count += radii[node] <= ratio * radii[static_cast<std::size_t>(tree.parents()[node])];
  return count;
}

/// Largest deviations from T = 2 w E and V = (w + 1) rings, over random trees.
void record_count_law(ExperimentContext& context) {
  CounterStream stream(context.seed(), 51);
  std::int64_t vertices_off = 0, places_off = 0, triangles_off = 0, duplicates = 0;
  constexpr int trees = 200;
  for (int i = 0; i < trees; ++i) {
    const auto w = static_cast<std::size_t>(3 + i % 10);
    const Skeleton tree =
        random_tree(stream, static_cast<std::size_t>(stream.next_between(1.0, 200.0)));
    const std::vector<double> radii = branch_radii(tree, 0.007, stream.next_between(1.5, 3.0));
    const BranchMeshOptions options{.circle_resolution = static_cast<int>(w)};
    const TriangleMesh mesh = mesh_branches(tree, radii, options).mesh;
    const std::size_t thin = thin_children(tree, radii, options.duplicate_ratio);
    const std::int64_t rings = whole(tree.node_count() + thin);
    duplicates += whole(thin);
    vertices_off =
        std::max(vertices_off, std::abs(whole(mesh.vertex_count()) - whole(w + 1) * rings));
    places_off = std::max(places_off, std::abs(whole(distinct_places(mesh)) - whole(w) * rings));
    triangles_off = std::max(
        triangles_off, std::abs(whole(mesh.triangle_count()) - whole(2 * w * tree.edge_count())));
  }
  context.record("count_law/trees", std::int64_t{trees});
  context.record("count_law/duplicated_rings", duplicates);
  context.record("count_law/vertices_off", vertices_off);
  context.record("count_law/places_off", places_off);
  context.record("count_law/triangles_off", triangles_off);
}

/// Triangles that rise from the rings about one place.
std::size_t triangles_from(const TriangleMesh& mesh, const Vector3& center, std::size_t w) {
  const auto starts_there = [&](std::uint32_t vertex) {
    const std::size_t first = vertex / (w + 1) * (w + 1);
    Vector3 sum;
    for (std::size_t i = 0; i < w; ++i) sum = sum + mesh.positions[first + i];
    return norm(sum / static_cast<double>(w) - center) < 1e-9;
  };
  std::size_t count = 0;
  for (const Triangle& t : mesh.triangles) count += starts_there(t[0]);
  return count;
}

/// One node with 1 to 8 children of equal radius: 2 w triangles to each of them.
void record_branchings(ExperimentContext& context) {
  constexpr int most_children = 8;
  for (const double ratio : {0.0, 0.49}) {
    std::int64_t largest_deviation = 0, own_rings = 0;
    for (const int w : {3, 6, 7})
      for (int k = 1; k <= most_children; ++k) {
        Skeleton tree({0, 0, 0});
        tree.append(0, {0, 1, 0});
        for (int i = 0; i < k; ++i) tree.append(1, {0.3 * i - 1.0, 2.0, 0.2 * i});
        const BranchMesh branches =
            mesh_branches(tree, branch_radii(tree, 0.007, 1.9),
                          {.circle_resolution = w, .duplicate_ratio = ratio});
        const auto corners = static_cast<std::size_t>(w);
        const std::size_t rising = triangles_from(branches.mesh, {0, 1, 0}, corners);
        largest_deviation = std::max(largest_deviation, std::abs(whole(rising) - 2 * w * k));
        own_rings += whole(branches.duplicated_rings);
      }
    const std::string name = ratio == 0.0 ? "branching/one_ring" : "branching/own_rings";
    context.record(name + "/triangles_off", largest_deviation);
    context.record(name + "/duplicated_rings", own_rings);
  }
  context.record("branching/most_children", std::int64_t{most_children});
}

void run(ExperimentContext& context) {
  record_tube(context);
  record_count_law(context);
  record_branchings(context);
}

}  // namespace

extern const ExperimentDescriptor mesh_counts;
constinit const ExperimentDescriptor mesh_counts{
    .id = "brzoska2019/mesh-counts",
    .question = "How many vertices and triangles do rings and branchings make?",
    .source = "[Brzoska2019] sec. 2.2, 5.1, fig. 4",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
