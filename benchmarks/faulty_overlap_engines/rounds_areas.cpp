// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_overlap_engines/right_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  OverlapPairs all;
  const OverlapWork work = find_rightly(discs, ground, setup, all);
  pairs.clear();
  for (std::size_t p = 0; p < all.size(); ++p)
    pairs.push_back(all.first()[p], all.second()[p],
                    static_cast<double>(static_cast<float>(all.area()[p])));
  return work;
}

}  // namespace

extern const OverlapEngineDescriptor rounds_areas;
constinit const OverlapEngineDescriptor rounds_areas{
    .name = "rounds_areas",
    .summary = "Wrong on purpose: gives areas in single precision.",
    .source = "too little precision",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
