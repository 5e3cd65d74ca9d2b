// SPDX-License-Identifier: MIT
// A program of somebody else's: grows a tree with two engines and finds discs that overlap.
#include <cstdio>
#include <exception>
#include <string>
#include <vector>

#include "core/colonization/growth.hpp"
#include "core/colonization/tree_parameters.hpp"
#include "core/nearest_node/engine_registry.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/tree/skeleton.hpp"

namespace {

phytobench::Skeleton grown_with(const std::string& engine_name) {
  phytobench::TreeParameters parameters;
  parameters.seed = 7;
  parameters.cloud.radii = {2.0, 2.8, 1.8};  // a crown of some thousand attraction points
  const phytobench::Seedling seedling = phytobench::make_seedling(parameters);
  const auto engine = phytobench::engine_named(engine_name).create();
  return phytobench::grow_crown(seedling, *engine).skeleton;
}

/// Whether both engines grow the same tree, bit for bit.
bool compare_engines() {
  const phytobench::Skeleton fast = grown_with("node_driven"), simple = grown_with("squared_scan");
  const std::string hash = phytobench::tree_hash(fast);
  const bool same = hash == phytobench::tree_hash(simple);
  std::printf("node_driven and squared_scan grow %s of %zu edges (%s)\n",
              same ? "the same tree" : "different trees", fast.edge_count(), hash.c_str());
  return same;
}

/// Three discs in a row, of which neighbours overlap.
void find_overlaps() {
  const std::vector<double> x{0.0, 1.0, 2.5}, y{0.0, 0.0, 0.0}, radius{1.0, 1.0, 1.0};
  const phytobench::Discs discs{x, y, radius};
  phytobench::OverlapPairs pairs;
  phytobench::overlap_engine_named("layered_grid").create()->find(discs, {}, {}, pairs);
  pairs.sort(discs.size());
  for (std::size_t k = 0; k < pairs.size(); ++k)
    std::printf("discs %d and %d share %.12f\n", pairs.first()[k], pairs.second()[k],
                pairs.area()[k]);
  std::printf("%zu of 3 pairs overlap\n", pairs.size());
}

}  // namespace

int main() {
  try {
    find_overlaps();
    return compare_engines() ? 0 : 1;
  } catch (const std::exception& error) {
    std::fprintf(stderr, "consumer: %s\n", error.what());
    return 2;
  }
}
