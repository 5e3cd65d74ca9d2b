// SPDX-License-Identifier: MIT
// Whether the thesis' plants are what it says of them: hanging branches, meshes, leaves, parts.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

#include "core/tree/branches.hpp"
#include "core/tree/mesh_measures.hpp"
#include "core/tree/plant.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

double mean_tip_height(const Skeleton& tree) {
  const ChildLists children(tree);
  double sum = 0.0;
  for (std::size_t node = 1; node < tree.node_count(); ++node)
    if (children.of(static_cast<std::int32_t>(node)).empty()) sum += tree.positions()[node].y;
  return sum / static_cast<double>(tip_count(tree));
}

/// Greatest distance between nodes of equal number.
double largest_move(const Skeleton& a, const Skeleton& b) {
  double largest = 0.0;
  for (std::size_t i = 0; i < a.node_count(); ++i)
    largest = std::max(largest, norm(a.positions()[i] - b.positions()[i]));
  return largest;
}

double largest_length_change(const Skeleton& a, const Skeleton& b) {
  const auto length = [](const Skeleton& s, std::size_t i) {
    return norm(s.positions()[i] - s.position(s.parents()[i]));
  };
  double largest = 0.0;
  for (std::size_t i = 1; i < a.node_count(); ++i)
    largest = std::max(largest, std::abs(length(a, i) / length(b, i) - 1.0));
  return largest;
}

/// Figure 43: the same tree, bent more and more.
void record_hanging(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-43-left");
  const Skeleton grown = grow_thesis_tree(parameters, context.threads());
  PendulousBranches pendulous = parameters.plant.pendulous;
  context.record("hanging/first_order", static_cast<std::int64_t>(pendulous.first_order));
  for (const double lambda : {0.0, 0.2, 0.4, 0.6, 0.8, 1.0}) {
    pendulous.intensity = lambda;
    PlantParameters look = parameters.plant;
    look.pendulous = pendulous;
    const Plant plant = make_plant(grown, look);
    const std::string name = "hanging/lambda-" + std::to_string(std::lround(10 * lambda));
    context.record(name + "/mean_tip_height", mean_tip_height(plant.skeleton), "length");
    context.record(name + "/vertices", whole(plant.vertex_count()));
    context.record(name + "/triangles", whole(plant.triangle_count()));
  }
  pendulous.intensity = 0.8;
  const Skeleton once = bend_branches(grown, pendulous);
  context.record("hanging/second_time_moves", largest_move(bend_branches(once, pendulous), once),
                 "length");
  context.record("hanging/edge_length_change", largest_length_change(once, grown));
  const std::vector<std::int32_t> depths = node_depths(grown);
  std::int64_t moved_below = 0, moved_above = 0;
  for (std::size_t i = 0; i < depths.size(); ++i) {
    const bool moved = !(once.positions()[i] == grown.positions()[i]);
    moved_below += moved && depths[i] < pendulous.first_order;
    moved_above += moved && depths[i] >= pendulous.first_order;
  }
  context.record("hanging/moved_below_first_order", moved_below);
  context.record("hanging/moved_from_first_order", moved_above);
  pendulous.intensity = 0.0;
  context.record("hanging/lambda_zero_moves", largest_move(bend_branches(grown, pendulous), grown),
                 "length");
}

/// One more stem node moves every order by one, so that the crown is bent otherwise (sec. 6.2).
void record_stem_side_effect(ExperimentContext& context) {
  TreeParameters parameters = thesis_tree("figure-43-middle");
  const Seedling seedling = make_seedling(parameters);
  const TreeOnStem tree{grow_thesis_tree(parameters, context.threads()), seedling.crown_root};
  parameters.stem_length += parameters.step_length;
  const TreeOnStem taller = regrow_stem(tree, parameters);
  const auto crown_change = [&](const Skeleton& a, const Skeleton& b) {
    const std::int32_t shift = taller.crown_root - tree.crown_root;
    double largest = 0.0;
    for (std::int32_t i = tree.crown_root; i < static_cast<std::int32_t>(a.node_count()); ++i) {
      const Vector3 before = a.position(i) - a.position(tree.crown_root);
      const Vector3 after = b.position(i + shift) - b.position(taller.crown_root);
      largest = std::max(largest, norm(after - before));
    }
    return largest;
  };
  const PendulousBranches& pendulous = parameters.plant.pendulous;
  context.record("regrown-stem/crown_change", crown_change(tree.skeleton, taller.skeleton),
                 "length");
  context.record("regrown-stem/added_nodes",
                 static_cast<std::int64_t>(taller.crown_root - tree.crown_root));
  context.record("regrown-stem/bent_crown_change",
                 crown_change(bend_branches(tree.skeleton, pendulous),
                              bend_branches(taller.skeleton, pendulous)),
                 "length");
}

/// Figure 50: bent from a low order, a trunk leaves the vertical.
void record_excurrent(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-42-left");
  const Seedling seedling = make_seedling(parameters);
  const Skeleton grown = grow_thesis_tree(parameters, context.threads());
  const auto trunk_top = seedling.skeleton.node_count() - 1;
  const Skeleton bent = bend_branches(grown, {.intensity = 0.8, .first_order = 10});
  const auto off_axis = [trunk_top](const Skeleton& s) {
    const Vector3& top = s.positions()[trunk_top];
    return norm({top.x, 0.0, top.z});
  };
  context.record("excurrent/trunk_off_axis", off_axis(grown), "length");
  context.record("excurrent/bent_trunk_off_axis", off_axis(bent), "length");
  context.record("excurrent/highest_trunk_node", grown.positions()[trunk_top].y, "length");
  context.record("excurrent/cloud_top", extent_of(seedling.attraction_points).high().y, "length");
}

struct MeshLaws {
  double off_plane = 0.0, normal_length = 0.0, seam = 0.0;
  std::int64_t not_finite = 0, flat_triangles = 0, inward = 0;
  std::int64_t facing_axis = 0;
  double facing_axis_least_lean = 180.0;
};

/// Planes of the rings of a mesh, duplicates included, from its own corners.
std::vector<std::pair<Vector3, Vector3>> ring_planes(const TriangleMesh& mesh,
                                                     std::size_t ring_size) {
  std::vector<std::pair<Vector3, Vector3>> planes;
  for (std::size_t first = 0; first < mesh.vertex_count(); first += ring_size) {
    Vector3 center{}, normal{};
    for (std::size_t i = 0; i + 1 < ring_size; ++i) {
      const Vector3 &a = mesh.positions[first + i], &b = mesh.positions[first + i + 1];
      center = center + a / static_cast<double>(ring_size - 1);
      normal = normal + cross(b - mesh.positions[first], a - mesh.positions[first]);
    }
    planes.push_back({center, normal});
  }
  return planes;
}

/// Of a triangle's two rings, how far the more oblique one leans from across their branch, in
/// degrees.
double lean_deg(const Triangle& triangle, std::size_t ring_size,
                const std::vector<std::pair<Vector3, Vector3>>& planes) {
  const auto& low = planes[triangle[0] / ring_size];
  const auto& high = planes[triangle[1] / ring_size];
  const Vector3 axis = high.first - low.first;
  const auto lean = [&](const Vector3& normal) {
    return std::atan2(norm(cross(normal, axis)), dot(normal, axis)) * 180.0 / std::numbers::pi;
  };
  return std::max(lean(low.second), lean(high.second));
}

/// Whether a triangle shows its outside to the line between the centers of its two rings.
bool faces_axis(const TriangleMesh& mesh, const Triangle& triangle, const Vector3& normal,
                std::size_t ring_size, const std::vector<std::pair<Vector3, Vector3>>& planes) {
  const Vector3& low = planes[triangle[0] / ring_size].first;
  const Vector3 axis = planes[triangle[1] / ring_size].first - low;
  const Vector3 middle =
      (mesh.positions[triangle[0]] + mesh.positions[triangle[1]] + mesh.positions[triangle[2]]) /
      3.0;
  const Vector3 off = middle - low;
  const Vector3 away = off - (dot(off, axis) / dot(axis, axis)) * axis;
  return dot(normal, away) < 0.0;
}

MeshLaws laws_of(const Plant& plant, const PlantParameters& parameters) {
  const TriangleMesh& mesh = plant.branches.mesh;
  const auto ring_size = static_cast<std::size_t>(parameters.branches.circle_resolution) + 1;
  const std::vector<Vector3> normals =
      ring_normals(plant.skeleton, plant.radii, parameters.branches.single_child_normal);
  const auto planes = ring_planes(mesh, ring_size);
  MeshLaws laws;
  for (std::size_t i = 0; i < mesh.vertex_count(); ++i) {
    laws.not_finite += !is_finite(mesh.positions[i]) || !is_finite(mesh.normals[i]);
    laws.normal_length = std::max(laws.normal_length, std::abs(norm(mesh.normals[i]) - 1.0));
    const std::size_t ring = i / ring_size;
    if (i % ring_size == 0)
      laws.seam = std::max(laws.seam, norm(mesh.normals[i] - mesh.normals[i + ring_size - 1]));
    if (ring < normals.size())
      laws.off_plane = std::max(
          laws.off_plane,
          std::abs(dot(mesh.positions[i] - plant.skeleton.positions()[ring], normals[ring])) /
              plant.radii[ring]);
  }
  for (const Triangle& t : mesh.triangles) {
    const Vector3& a = mesh.positions[t[0]];
    const Vector3 normal = cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    laws.flat_triangles += !(norm(normal) > 0.0);
    laws.inward += dot(normal, mesh.normals[t[0]] + mesh.normals[t[1]] + mesh.normals[t[2]]) < 0.0;
    if (!faces_axis(mesh, t, normal, ring_size, planes)) continue;
    ++laws.facing_axis;
    laws.facing_axis_least_lean =
        std::min(laws.facing_axis_least_lean, lean_deg(t, ring_size, planes));
  }
  return laws;
}

/// Open ends that the skeleton asks for: the root, every tip, every ring of a branch's own, and
/// every ring that all branches above leave through rings of their own.
std::int64_t expected_loops(const Plant& plant, double duplicate_ratio) {
  const ChildLists children(plant.skeleton);
  std::size_t loops = 1 + plant.branches.duplicated_rings;
  for (std::size_t node = 1; node < plant.skeleton.node_count(); ++node) {
    const auto above = children.of(static_cast<std::int32_t>(node));
    loops += std::all_of(above.begin(), above.end(), [&](std::int32_t child) {
      return needs_own_ring(plant.radii[static_cast<std::size_t>(child)], plant.radii[node],
                            duplicate_ratio);
    });
  }
  return whole(loops);
}

void record_topology(ExperimentContext& context, const std::string& name, const Plant& plant,
                     const BranchMeshOptions& options) {
  const SurfaceEdges edges(plant.branches.mesh);
  context.record(name + "/euler_characteristic", edges.euler_characteristic());
  context.record(name + "/boundary_loops",
                 static_cast<double>(edges.boundary_edges()) / options.circle_resolution);
  context.record(name + "/expected_loops",
                 static_cast<double>(expected_loops(plant, options.duplicate_ratio)));
}

void record_meshes(ExperimentContext& context) {
  for (const char* row : {"figure-40-left", "figure-42-left", "figure-43-middle", "figure-52"}) {
    context.progress(std::string("mesh of ") + row);
    const TreeParameters parameters = thesis_tree(row);
    const Plant plant =
        make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
    const MeshLaws laws = laws_of(plant, parameters.plant);
    const std::string name = std::string("mesh/") + row;
    context.record(name + "/off_plane", laws.off_plane);
    context.record(name + "/normal_length_error", laws.normal_length);
    context.record(name + "/seam_error", laws.seam);
    context.record(name + "/not_finite", laws.not_finite);
    context.record(name + "/flat_triangles", laws.flat_triangles);
    context.record(name + "/inward_triangles", laws.inward);
    context.record(name + "/triangles_facing_axis", laws.facing_axis);
    context.record(name + "/facing_axis_least_lean", laws.facing_axis_least_lean, "degrees");
    record_topology(context, name, plant, parameters.plant.branches);
  }
}

/// Parts of at most 65,536 vertices, leaves and branches in meshes of their own as in the exports.
void record_parts(ExperimentContext& context) {
  for (const char* row : {"figure-43-right", "figure-52"}) {
    const TreeParameters parameters = thesis_tree(row);
    const Plant plant =
        make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
    TriangleMesh together = plant.branches.mesh;
    append(together, plant.leaf_mesh);
    std::size_t largest = 0, triangles = 0;
    const std::vector<TriangleMesh> parts = split(together);
    for (const TriangleMesh& part : parts) {
      largest = std::max(largest, part.vertex_count());
      triangles += part.triangle_count();
    }
    const std::string name = std::string("parts/") + row;
    context.record(name + "/parts", whole(parts.size()));
    context.record(name + "/largest", whole(largest));
    context.record(name + "/triangles", whole(triangles));
    context.record(name + "/whole_triangles", whole(together.triangle_count()));
  }
}

/// Thickness changes radii and duplicates, never the skeleton.
void record_thickness(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-42-left");
  const Skeleton grown = grow_thesis_tree(parameters, context.threads());
  for (const int percent : {55, 80, 85}) {
    PlantParameters look = parameters.plant;
    look.radius_exponent = radius_exponent_of(percent / 100.0);
    const Plant plant = make_plant(grown, look);
    const std::string name = "thickness/" + std::to_string(percent);
    context.record(name + "/duplicated_rings", whole(plant.branches.duplicated_rings));
    context.record(name + "/root_radius", plant.radii[0], "length");
    context.record(name + "/skeleton_moves", largest_move(plant.skeleton, grown), "length");
  }
}

/// Figure 42's cloud with its lower half cut off, as the text says, and with a little more.
void record_cuts(ExperimentContext& context) {
  TreeParameters parameters = thesis_tree("figure-42-left");
  for (const int percent : {50, 60}) {
    parameters.cloud.cutoff_bottom = percent / 100.0;
    const Plant plant =
        make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
    const std::string name = "cut/" + std::to_string(percent) + "-percent";
    context.record(name + "/vertices", whole(plant.vertex_count()));
    context.record(name + "/triangles", whole(plant.triangle_count()));
  }
}

void run(ExperimentContext& context) {
  record_cuts(context);
  record_hanging(context);
  record_stem_side_effect(context);
  record_excurrent(context);
  record_meshes(context);
  record_parts(context);
  record_thickness(context);
}

}  // namespace

extern const ExperimentDescriptor plant_meshes;
constinit const ExperimentDescriptor plant_meshes{
    .id = "brzoska2019/plant-meshes",
    .question = "Are hanging branches, meshes and their parts what the thesis says of them?",
    .source = "[Brzoska2019] sec. 2.2, 3.4.5, 3.7, 5.1, 5.5, 6.2",
    .seconds = {2, 2, 2},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
