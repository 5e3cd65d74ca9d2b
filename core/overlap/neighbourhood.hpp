// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <vector>

#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

/// All pairs of discs of the open plane, such as an OverlapEngine finds; valid until the next call.
using PairFinder = std::function<const OverlapPairs&(const Discs&)>;

/// Discs with their images as plain discs of the plane, and who overlaps whom: what walks around
/// circles need. Discs of radius 0 are left out.
struct Neighbourhood {
  std::vector<Point2> center;  ///< from `origin`
  std::vector<double> radius;
  std::vector<DiscIndex> disc;  ///< whose entry or image this is
  std::size_t originals = 0;    ///< entries before the first image
  std::vector<std::size_t> begin;
  std::vector<DiscIndex> neighbour;

  std::size_t size() const { return center.size(); }
  bool is_image(std::size_t e) const { return e >= originals; }
  std::span<const DiscIndex> neighbours(std::size_t e) const {
    return std::span(neighbour).subspan(begin[e], begin[e + 1] - begin[e]);
  }
};

/// Neighbours come in the order in which `find` gives their pairs.
Neighbourhood neighbourhood_of(const Discs& discs, const Ground& ground, const Point2& origin,
                               const PairFinder& find);

/// With the suite's own engine, kept by what is returned.
PairFinder own_pair_finder(const OverlapSetup& setup);

}  // namespace phytobench
