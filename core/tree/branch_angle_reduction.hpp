// SPDX-License-Identifier: MIT
#pragma once

#include "core/tree/skeleton.hpp"

namespace phytobench {

/// Moves every node but the root by `share` of the way to its parent, all at once: parents count
/// where they stood before. Each edge becomes (1 - share) of itself plus `share` of the one below
/// it, so branches leave a fork more nearly in the direction of the branch that carries them.
/// [Liebemann2017] sec. 3.4, step 3, gives no formula and cites Runions et al. 2007, who move each
/// node halfway: a share of 0.5. share in [0, 1). Children of the root keep their angles, because
/// nothing carries it.
Skeleton reduce_branch_angles(const Skeleton& skeleton, double share);

}  // namespace phytobench
