// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_overlap_engines/right_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  const OverlapWork work = find_rightly(discs, ground, setup, pairs);
  for (std::size_t j = 1; j < discs.size(); ++j) {
    const double gap = center_distance(discs, ground, 0, j, {}) - discs.radius[0] - discs.radius[j];
    if (gap >= 0.0 && gap < 0.5) pairs.push_back(0, static_cast<DiscIndex>(j), 1e-300);
  }
  return work;
}

}  // namespace

extern const OverlapEngineDescriptor counts_touching;
constinit const OverlapEngineDescriptor counts_touching{
    .name = "counts_touching",
    .summary = "Wrong on purpose: takes discs that are a little apart for overlapping.",
    .source = "a tolerance where none belongs",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
