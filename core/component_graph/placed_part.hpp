// SPDX-License-Identifier: MIT
#pragma once

#include <memory>
#include <span>

#include "core/component_graph/build_context.hpp"
#include "core/component_graph/frame.hpp"
#include "core/component_graph/material.hpp"

namespace phytobench {

/// Beyond it single precision, in which meshes are exported, has no neighbours left to measure by.
inline constexpr double largest_coordinate = 1e15;

/// Never for what is not finite.
bool is_within_reach(const Vector3& place);

/// Moves a part from an instance's own frame into the world and bends it, by the last deformation
/// first. A surface that a deformation does not bend keeps its shape and goes with the place and
/// the axes of the frame. False, and the part is of no use, if it leaves what is_within_reach().
bool place_part(MeshPart& part, const Frame& frame,
                std::span<const std::shared_ptr<const Deformation>> deformations);

/// Where a deformation takes a frame: its place, its y direction and the plane of x and y. The
/// frame is only moved where the deformation flattens its axes.
Frame deformed(const Frame& frame, const Deformation& deformation);

}  // namespace phytobench
