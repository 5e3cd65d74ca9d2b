// SPDX-License-Identifier: MIT
// How discs share the ground they cover, by strips: the judge of exact shares. Shares no code with
// core/.
#pragma once

#include <vector>

#include "reference/oracles/disc_overlap.hpp"

namespace phytobench::oracles {

/// What each disc wins where every place belongs to the discs that cover it, to each by its
/// area^exponent over the sum of theirs (siplab, Garcia 2014); infinity: all to the largest, equal
/// ones share. The plane is cut into strips wherever a disc begins or ends or two circles cross;
/// within a strip no arcs cross, and the area between neighbouring arcs has a closed form. On a
/// torus every disc meets all images of the others. Time n^3 at least.
std::vector<double> disc_shares_by_strips(const std::vector<OracleDisc>& discs,
                                          const OracleGround& ground, double exponent);

/// The same by looking at the middles of `steps` x `steps` squares of each disc's box: an error of
/// some steps^-1.5 of its area, and no geometry to go wrong.
std::vector<double> disc_shares_by_squares(const std::vector<OracleDisc>& discs,
                                           const OracleGround& ground, double exponent, int steps);

}  // namespace phytobench::oracles
