// SPDX-License-Identifier: MIT
#include "benchmarks/point_pattern/kdtree_hopkins.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

std::string_view kdtree_library() {
  return {};
}

HopkinsIndex kdtree_hopkins(std::span<const Point2>, std::span<const Point2>) {
  PHYTOBENCH_EXPECT(false && "no k-d tree library was found");
  return {};
}

}  // namespace phytobench
