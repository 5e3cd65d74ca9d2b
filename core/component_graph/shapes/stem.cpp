// SPDX-License-Identifier: MIT
#include "core/component_graph/shapes/stem.hpp"

#include <algorithm>
#include <cmath>

#include "core/component_graph/shapes/outward_frame.hpp"
#include "core/component_graph/shapes/vertex_limit.hpp"

namespace phytobench {

namespace {

/// Rounded to the nearest of 0 ... last.
std::size_t spread(int i, int n, std::size_t last) {
  return static_cast<std::size_t>(
      std::round(static_cast<double>(i) * static_cast<double>(last) / static_cast<double>(n)));
}

}  // namespace

Frame bent(const ComponentValues& values, const Frame& frame, int joint, int joints) {
  if (joint < 1 || joint > joints) return frame;
  const NumberSpan span{values.number(StemKey::bend_first), values.number(StemKey::bend_last)};
  const double bend =
      joints == 1
          ? 0.5 * (span.first + span.last)
          : span.at({static_cast<std::uint32_t>(joint), static_cast<std::uint32_t>(joints)});
  const Frame twisted = rolled(frame, values.number(StemKey::twist));
  return bend == 0.0 ? twisted : twisted.turned(Rotation::about(twisted.x, radians(bend)));
}

Spine stem_spine(const ComponentValues& values, const SpineTurn& turn) {
  return make_spine(values.number(StemKey::length),
                    static_cast<int>(values.count(StemKey::segments)), turn);
}

double stem_radius(const ComponentValues& values, double share) {
  const double first = values.number(StemKey::radius_first);
  const double last = values.number(StemKey::radius_last);
  if (share == 1.0) return last;
  const double way = std::pow(share, values.number(StemKey::radius_power));
  return std::max(0.0, first + way * (last - first));
}

void add_stem(const ComponentInput& input, const Spine& spine, std::vector<MeshPart>& parts) {
  const ComponentValues& values = input.values;
  const std::size_t segments = spine.pieces.size();
  const int pieces =
      std::min(input.context.pieces(static_cast<double>(segments), 1), static_cast<int>(segments));
  const int corners = input.context.pieces(static_cast<double>(values.count(StemKey::corners)), 3);
  refuse_too_many_vertices("a stem", pieces + 1, corners + 1);
  std::vector<Frame> rings;
  std::vector<double> radii;
  for (int i = 0; i <= pieces; ++i) {
    const std::size_t ring = spread(i, pieces, segments);
    rings.push_back(spine.rings[ring]);
    radii.push_back(stem_radius(values, static_cast<double>(ring) / static_cast<double>(segments)));
  }
  const TubeOptions options{.corners = corners,
                            .caps = static_cast<TubeCaps>(values.choice(StemKey::caps)),
                            .texture_scale = input.frame.scale};
  TriangleMesh mesh = tapered_tube(rings, radii, options);
  if (mesh.triangles.empty()) return;
  parts.push_back({material_of(values, StemKey::surface, StemKey::colour), std::move(mesh)});
}

}  // namespace phytobench
