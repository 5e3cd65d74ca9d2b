// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_overlap_engines/right_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  const OverlapWork work = find_rightly(discs, ground, setup, pairs);
  if (pairs.size() > 0) pairs.push_back(pairs.first()[0], pairs.second()[0], pairs.area()[0]);
  return work;
}

}  // namespace

extern const OverlapEngineDescriptor reports_a_pair_twice;
constinit const OverlapEngineDescriptor reports_a_pair_twice{
    .name = "reports_a_pair_twice",
    .summary = "Wrong on purpose: has one pair once too often.",
    .source = "a search from both discs",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
