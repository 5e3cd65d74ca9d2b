// SPDX-License-Identifier: MIT
// From a grown skeleton to what can be seen of a plant.
#include <fmt/format.h>

#include "benchmarks/nearest_node/workload.hpp"
#include "benchmarks/regression/checks/plant_check.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/tree/plant.hpp"

namespace phytobench::families {

namespace {

/// The thesis' test tree; its growth is watched elsewhere.
Skeleton grown_test_tree() {
  const Workload workload = scaled_test_tree({});
  const auto engine = engine_named("node_driven").create();
  return grow_crown(workload.seedling, *engine,
                    {.options = loop_options_named("dn"), .count_work = false})
      .skeleton;
}

void add_mesh(KernelDigest& digest, const TriangleMesh& mesh) {
  digest.add(mesh.positions).add(mesh.normals).add(mesh.texture_points).add(mesh.triangles);
}

class MeshKernel final : public WatchedKernel {
 public:
  MeshKernel() : skeleton_(grown_test_tree()) {}

  std::string inputs() const override {
    const BranchMeshOptions& branches = parameters_.branches;
    const LeafOptions& leaves = parameters_.leaves;
    return KernelDigest()
        .add(skeleton_.positions())
        .add(skeleton_.parents())
        .add({parameters_.tip_radius, parameters_.radius_exponent, parameters_.pendulous.intensity,
              digest_number(parameters_.pendulous.first_order)})
        .add({digest_number(branches.circle_resolution), branches.duplicate_ratio,
              digest_number(branches.ring_turn), digest_number(branches.single_child_normal),
              branches.texture_length})
        .add({leaves.per_node, leaves.size, leaves.size_spread, leaves.radius_limit,
              digest_number(leaves.shape), digest_number(leaves.seed)})
        .hex();
  }

  void run() override { plant_ = make_plant(skeleton_, parameters_); }

  std::string answer() const override {
    KernelDigest digest;
    digest.add(plant_.radii);
    add_mesh(digest, plant_.branches.mesh);
    add_mesh(digest, plant_.leaf_mesh);
    return digest.hex();
  }

  WorkCounts work() const override {
    return {{"nodes", plant_.radii.size()},
            {"leaves", plant_.leaves.size()},
            {"vertices", plant_.vertex_count()},
            {"triangles", plant_.triangle_count()}};
  }

  std::string objection() override { return objection_to_plant(plant_, skeleton_, parameters_); }

 private:
  Skeleton skeleton_;
  PlantParameters parameters_;
  Plant plant_;
};

std::vector<WatchedBenchmark> list_trees(const FamilyRequest&) {
  return {{.name = "tree/skeleton-to-mesh",
           .summary = "Radii, branch mesh and leaves of the grown test tree.",
           .is_own = true,
           .prepare = [] { return std::make_unique<MeshKernel>(); }}};
}

}  // namespace

extern const BenchmarkFamily tree;
constinit const BenchmarkFamily tree{
    .name = "tree",
    .summary = "Dressing a skeleton with branches and leaves.",
    .list = list_trees,
};

}  // namespace phytobench::families
