// SPDX-License-Identifier: MIT
// Growth towards light and weight ([Lintermann1997] sec. 4: trees and leaves follow two fields).
#pragma once

#include "core/component_graph/component.hpp"

namespace phytobench {

/// Degrees by which an axis would turn over its whole length if it stood at right angles to the
/// field all the way; negative: away from it.
struct Tropism {
  double photo_deg = 0.0;
  double gravi_deg = 0.0;
};

/// What pulls at a place of the instance's own frame: both fields, each of unit length or zero,
/// with their weights in radians. In that frame's directions.
Vector3 pull_at(const ComponentInput& input, const Vector3& local, const Tropism& tropism);

/// The frame turned as by a constant pull over `share` of the whole length: along the axis the
/// angle to the pull falls as d(angle) / ds = -|pull| sin(angle), so that tan(angle / 2) shrinks by
/// exp(-|pull| share). Never past the pull, however strong; no turn where the axis looks straight
/// along it or against it. In a constant field the direction at the end does not depend on into how
/// many shares the length is cut.
Frame pulled(const Frame& frame, const Vector3& pull, double share);

}  // namespace phytobench
