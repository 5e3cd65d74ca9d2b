// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <vector>

#include "core/component_graph/material.hpp"
#include "core/component_graph/vector_field.hpp"

namespace phytobench {

/// A map of space into itself that bends what is already built: free-form deformation.
class Deformation {
 public:
  virtual ~Deformation() = default;
  /// Where a place of the undeformed plant goes. Smooth and finite everywhere.
  virtual Vector3 moved(const Vector3& place) const = 0;
  /// Whether meshes of this surface bend; others keep their shape and go with their origin.
  virtual bool bends(Surface surface) const = 0;
};

/// What an instance takes from those above it. Every subtree has its own copy: a component that
/// changes it (World, free-form deformation) changes it for what hangs below.
struct BuildContext {
  double time = 0.0;
  /// Detail of meshes: components multiply their numbers of corners and pieces by it, > 0.
  double resolution = 1.0;
  /// Where light comes from and where weight pulls: +y and -y unless a World says otherwise.
  std::shared_ptr<const VectorField> photo = std::make_shared<VectorField>(Vector3{0.0, 1.0, 0.0});
  std::shared_ptr<const VectorField> gravi = std::make_shared<VectorField>(Vector3{0.0, -1.0, 0.0});
  /// From the outermost to the innermost; the innermost is applied first.
  std::vector<std::shared_ptr<const Deformation>> deformations;

  /// `wanted` pieces at this resolution, rounded, at least `fewest`, at most 10000.
  int pieces(double wanted, int fewest) const;
};

}  // namespace phytobench
