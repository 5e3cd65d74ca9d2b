// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_overlap_engines/right_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  OverlapPairs all;
  const OverlapWork work = find_rightly(discs, ground, setup, all);
  pairs.clear();
  for (std::size_t p = 0; p + 1 < all.size(); ++p)
    pairs.push_back(all.first()[p], all.second()[p], all.area()[p]);
  return work;
}

}  // namespace

extern const OverlapEngineDescriptor misses_one_pair;
constinit const OverlapEngineDescriptor misses_one_pair{
    .name = "misses_one_pair",
    .summary = "Wrong on purpose: leaves out the pair it finds last.",
    .source = "a loop that ends too early",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
