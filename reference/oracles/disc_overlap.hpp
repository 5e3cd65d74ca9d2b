// SPDX-License-Identifier: MIT
// Which discs overlap, by looking: the judge of overlap engines. Shares no code with core/.
#pragma once

#include <cstddef>
#include <cstdint>
#include <utility>
#include <vector>

namespace phytobench::oracles {

struct OracleDisc {
  double x, y, r;
};

/// period_x, period_y: 0 on the open plane.
struct OracleGround {
  double period_x = 0.0;
  double period_y = 0.0;
};

/// Pair of places in the list, the lower first, and the distance of centers (of two images).
struct OracleOverlap {
  std::int64_t i, j;
  double distance;
};

/// Every pair whose distance is less than the sum of the radii, by the double loop: time n^2. On a
/// torus every image counts, as long as discs fit into the period.
std::vector<OracleOverlap> overlaps_literally(const std::vector<OracleDisc>& discs,
                                              const OracleGround& ground);

/// The same through a table of centers: each disc looks at all centers within its own diameter, so
/// that the smaller of a pair is found by the larger.
std::vector<OracleOverlap> overlaps_by_table(const std::vector<OracleDisc>& discs,
                                             const OracleGround& ground);

/// The same for one disc, with everything else.
std::vector<OracleOverlap> overlaps_of(std::size_t disc, const std::vector<OracleDisc>& discs,
                                       const OracleGround& ground);

}  // namespace phytobench::oracles
