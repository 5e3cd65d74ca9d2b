// SPDX-License-Identifier: MIT
#include "core/component_graph/build_plant.hpp"

#include <utility>

#include <fmt/format.h>

#include "core/component_graph/placed_part.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::size_t between_reports = 4096;  // instances
constexpr double smallest_scale = 1e-100;

bool is_within_reach(const Frame& frame) {
  return is_within_reach(frame.origin) && is_finite(frame.x) && is_finite(frame.y) &&
         frame.scale >= smallest_scale && frame.scale <= largest_coordinate;
}

class PlantBuilder {
 public:
  PlantBuilder(const ComponentGraph& graph, const BuildOptions& options)
      : graph_(graph), options_(options), tree_(make_instance_tree(graph, options.limits)) {
    plant_.instances = instances_per_prototype(graph, tree_);
    plant_.instance_count = tree_.instances.size();
  }

  BuiltPlant run() {
    BuildContext context;
    context.time = graph_.time;
    context.resolution = options_.resolution;
    if (!tree_.instances.empty()) visit(Frame{}, context);
    return std::move(plant_);
  }

 private:
  /// Builds the instance that comes next and all below it.
  void visit(const Frame& frame, const BuildContext& above) {
    const std::size_t position = next_++;
    report();
    const Instance& instance = tree_.instances[position];
    const Prototype& prototype = graph_.prototypes[instance.prototype];
    const ComponentKind& kind = *prototype.kind;
    const ComponentValues values(kind.keys, prototype.settings, place_of(graph_, instance));
    const ComponentInput input{values, frame, above};
    if (kind.make_geometry != nullptr) add_geometry(prototype, input);
    if (kind.change_context == nullptr) return visit_children(position, input, above);
    BuildContext below = above;
    kind.change_context(input, below);
    visit_children(position, input, below);
  }

  /// Siblings of one link stand one after the other, with their subtrees between them.
  void visit_children(std::size_t position, const ComponentInput& input,
                      const BuildContext& below) {
    const auto& instances = tree_.instances;
    const Prototype& prototype = graph_.prototypes[instances[position].prototype];
    std::vector<Frame> frames;
    while (next_ < instances.size() && instances[next_].parent == position) {
      const Instance& first = instances[next_];
      frames.assign(first.number.n, Frame{});
      prototype.kind->place_children(input, graph_.links[first.link].kind, frames);
      for (const Frame& local : frames) {
        const Frame frame = input.frame * local;
        if (!is_within_reach(frame)) refuse_place(prototype);
        visit(orthonormal(frame), below);
      }
    }
  }

  void add_geometry(const Prototype& prototype, const ComponentInput& input) {
    parts_.clear();
    prototype.kind->make_geometry(input, parts_);
    for (MeshPart& part : parts_) {
      plant_.triangle_count += part.mesh.triangle_count();
      if (plant_.triangle_count > options_.most_triangles)
        throw InputError(
            fmt::format("the plant has more than {} triangles (now at '{}'); lower the "
                        "resolution or the numbers of children and branches",
                        options_.most_triangles, prototype.name));
      if (!place_part(part, input.frame, input.context.deformations)) refuse_place(prototype);
      append(mesh_of(part.material), part.mesh);
    }
  }

  TriangleMesh& mesh_of(const Material& material) {
    for (MeshPart& part : plant_.parts)
      if (part.material == material) return part.mesh;
    plant_.parts.push_back({material, {}});
    return plant_.parts.back().mesh;
  }

  [[noreturn]] static void refuse_place(const Prototype& prototype) {
    throw InputError(
        fmt::format("component '{}' ({}) reaches places beyond {:.0e} or becomes too "
                    "small to be a number; lower its lengths, scales or recursions",
                    prototype.name, prototype.kind->name, largest_coordinate));
  }

  void report() const {
    if (!options_.progress || next_ % between_reports != 0) return;
    const double share = static_cast<double>(next_) / static_cast<double>(tree_.instances.size());
    if (!options_.progress(share)) throw Interrupted("nothing is written");
  }

  const ComponentGraph& graph_;
  const BuildOptions& options_;
  InstanceTree tree_;
  std::size_t next_ = 0;         // instance to visit
  std::vector<MeshPart> parts_;  // of one instance
  BuiltPlant plant_;
};

}  // namespace

BuiltPlant build_plant(const ComponentGraph& graph, const BuildOptions& options) {
  PHYTOBENCH_EXPECT(options.resolution > 0.0 && options.resolution <= 100.0);
  return PlantBuilder(graph, options).run();
}

}  // namespace phytobench
