// SPDX-License-Identifier: MIT
#include "benchmarks/point_pattern/kdtree_hopkins.hpp"

#include <array>
#include <cmath>
#include <cstddef>

#include <nanoflann.hpp>

namespace phytobench {

namespace {

struct Cloud {
  std::span<const Point2> points;

  std::size_t kdtree_get_point_count() const { return points.size(); }
  double kdtree_get_pt(std::size_t i, std::size_t axis) const {
    return axis == 0 ? points[i].x : points[i].y;
  }
  template <class Box>
  bool kdtree_get_bbox(Box&) const {
    return false;
  }
};

using Tree = nanoflann::KDTreeSingleIndexAdaptor<nanoflann::L2_Simple_Adaptor<double, Cloud>, Cloud,
                                                 2, std::size_t>;

/// Squared distance to the nearest point, or to the second nearest: the point itself is the first.
double squared_nearest(const Tree& tree, const Point2& query, std::size_t which) {
  const double at[] = {query.x, query.y};
  std::array<std::size_t, 2> index{};
  std::array<double, 2> squared{};
  tree.knnSearch(at, which + 1, index.data(), squared.data());
  return squared[which];
}

struct Sums {
  double distance = 0.0, squared = 0.0;

  void add(double squared_distance) {
    distance += std::sqrt(squared_distance);
    squared += squared_distance;
  }
};

}  // namespace

std::string_view kdtree_library() {
  return "nanoflann 1.4";
}

HopkinsIndex kdtree_hopkins(std::span<const Point2> points, std::span<const Point2> places) {
  const Cloud cloud{points};
  Tree tree(2, cloud, nanoflann::KDTreeSingleIndexAdaptorParams(10));
  tree.buildIndex();
  Sums from_places, among;
  for (const Point2& place : places) from_places.add(squared_nearest(tree, place, 0));
  for (const Point2& point : points) among.add(squared_nearest(tree, point, 1));
  const double share = static_cast<double>(points.size()) / static_cast<double>(places.size());
  return {share * from_places.distance / among.distance,
          share * from_places.squared / among.squared};
}

}  // namespace phytobench
