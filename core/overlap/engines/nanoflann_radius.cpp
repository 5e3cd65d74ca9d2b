// SPDX-License-Identifier: MIT
// nanoflann's kd-tree of centers. It knows no radii, so each disc asks for all centers within twice
// its own: the smaller of a pair is always found by the larger.
#include <cstddef>
#include <type_traits>
#include <vector>

#include <nanoflann.hpp>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

struct Centers {
  const std::vector<DiscEntry>& entries;

  std::size_t kdtree_get_point_count() const { return entries.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return axis == 0 ? entries[i].x : entries[i].y;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

/// Hands on what the search meets instead of keeping it.
template <class Visit>
struct Within {
  double squared_reach;
  const Visit& visit;

  bool addPoint(double squared, std::size_t row) {
    if (squared <= squared_reach) visit(row);
    return true;
  }
  double worstDist() const { return squared_reach; }
  bool full() const { return true; }
  std::size_t size() const { return 0; }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Centers>,
                                                 Centers, 2, std::size_t>;

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  const Centers centers{entries};
  if (entries.empty()) return collector.finish();
  Tree tree(2, centers, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  offer_within_diameters(discs, entries, collector,
                         [&](const DiscEntry& i, double squared_reach, const auto& visit) {
                           const double center[] = {i.x, i.y};
                           Within<std::decay_t<decltype(visit)>> within{squared_reach, visit};
                           tree.findNeighbors(within, center, nanoflann::SearchParams());
                         });
  collector.work().places = entries.size();
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor nanoflann_radius;
constinit const OverlapEngineDescriptor nanoflann_radius{
    .name = "nanoflann_radius",
    .summary = "Asks nanoflann's kd-tree for all centers within twice a disc's radius.",
    .source = "nanoflann (Blanco and Rai 2014), KDTreeSingleIndexAdaptor",
    .library = "nanoflann 1.4",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
