// SPDX-License-Identifier: MIT
// FLANN's exact kd-tree of centers. It knows no radii, so each disc asks for all centers within
// twice its own: the smaller of a pair is always found by the larger.
#include <cstddef>
#include <vector>

#include <flann/config.h>
#include <flann/flann.hpp>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

/// Hands on what the search meets instead of keeping it.
template <class Visit>
class Within final : public flann::ResultSet<double> {
 public:
  Within(double squared_reach, const Visit& visit) : squared_reach_(squared_reach), visit_(visit) {}
  void addPoint(double squared, std::size_t row) override {
    if (squared <= squared_reach_) visit_(row);
  }
  double worstDist() const override { return squared_reach_; }
  bool full() const override { return true; }

 private:
  double squared_reach_;
  const Visit& visit_;
};

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  if (entries.empty()) return collector.finish();
  std::vector<double> centers;
  centers.reserve(2 * entries.size());
  for (const DiscEntry& e : entries) centers.insert(centers.end(), {e.x, e.y});
  constexpr int leaf_size = 10;  // FLANN's default
  flann::KDTreeSingleIndex<flann::L2_Simple<double>> tree(
      flann::Matrix<double>(centers.data(), entries.size(), 2),
      flann::KDTreeSingleIndexParams(leaf_size));
  tree.buildIndex();
  offer_within_diameters(discs, entries, collector,
                         [&](const DiscEntry& i, double squared_reach, const auto& visit) {
                           const double center[] = {i.x, i.y};
                           Within within(squared_reach, visit);
                           tree.findNeighbors(within, center, flann::SearchParams());
                         });
  collector.work().places = entries.size();
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor flann_radius;
constinit const OverlapEngineDescriptor flann_radius{
    .name = "flann_radius",
    .summary = "Asks FLANN's exact kd-tree for all centers within twice a disc's radius.",
    .source = "FLANN (Muja and Lowe), KDTreeSingleIndex",
    .library = "FLANN " FLANN_VERSION_,
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
