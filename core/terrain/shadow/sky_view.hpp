// SPDX-License-Identifier: MIT
#pragma once

#include <span>
#include <vector>

#include "core/terrain/height_field.hpp"
#include "core/terrain/relief.hpp"
#include "core/terrain/shadow/horizon.hpp"

namespace phytobench {

struct SkyViewOptions {
  int azimuths = 64;  ///< horizons all round, evenly; at least 1
  HorizonOptions horizon;
  int threads = 1;  ///< results are the same for any number
};

/// Which share of the light of an evenly bright sky reaches a horizontal receiver at each vertex,
/// row by row: 1 less the mean of the horizons' squared sines. The terrain does not hide what is
/// below the horizontal, where there is no sky. NaN where a vertex has no data.
std::vector<double> sky_view_factors(const HeightField& field, const SkyViewOptions& options = {});

/// The same for receivers that lie on the terrain, tilted as `gradients` says: what their own slope
/// hides counts as hidden (Dozier and Frew 1990, IEEE Transactions on Geoscience and Remote Sensing
/// 28, eq. 7b).
std::vector<double> tilted_sky_view_factors(const HeightField& field,
                                            std::span<const SurfaceGradient> gradients,
                                            const SkyViewOptions& options = {});

}  // namespace phytobench
