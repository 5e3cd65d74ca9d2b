// SPDX-License-Identifier: MIT
#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const int reach = ground.torus ? 1 : 0;
  for (std::size_t i = 0; i < discs.size(); ++i)
    for (std::size_t j = i + 1; j < discs.size(); ++j)
      for (int ky = -reach; ky <= reach; ++ky)
        for (int kx = -reach; kx <= reach; ++kx) collector.offer(i, j, {kx, ky});
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor all_pairs;
constinit const OverlapEngineDescriptor all_pairs{
    .name = "all_pairs",
    .summary = "Looks at every pair of discs, and at all images of it on a torus.",
    .source = "the definition",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
