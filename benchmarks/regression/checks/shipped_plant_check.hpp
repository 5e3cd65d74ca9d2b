// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "core/component_graph/build_plant.hpp"

namespace phytobench {

/// What is wrong with a plant of any graph, in one line; empty if nothing. Instances are as many as
/// a grammar that only counts says, where chance does not decide; meshes are such as can be drawn:
/// numbers finite, normals of length 1 and on the side to which their triangles look, triangles of
/// vertices that are there. (Where things lie, umbrella_check.hpp says of a plant
/// whose numbers are regular.)
std::string objection_to_shipped_plant(const ComponentGraph& graph, const BuiltPlant& plant);

}  // namespace phytobench
