// SPDX-License-Identifier: MIT
// Boost.Geometry's R-tree over the boxes of discs, packed from all of them at once, asked with each
// disc's box.
#include <iterator>
#include <utility>
#include <vector>

#define BOOST_ALLOW_DEPRECATED_HEADERS  // Boost includes one itself and then reports that
#include <boost/geometry/geometries/box.hpp>
#include <boost/geometry/geometries/point.hpp>
#include <boost/geometry/index/rtree.hpp>
#include <boost/geometry/strategies/strategies.hpp>
#include <boost/iterator/function_output_iterator.hpp>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

namespace geometry = boost::geometry;
namespace rtree = geometry::index;
using Corner = geometry::model::point<double, 2, geometry::cs::cartesian>;
using Box = geometry::model::box<Corner>;
using Entry = std::pair<Box, const DiscEntry*>;

/// Wider by more than rounding: touching is decided by the distance.
Box box_of(const DiscEntry& e) {
  const double half = e.radius * (1.0 + 1e-6);
  return {Corner(e.x - half, e.y - half), Corner(e.x + half, e.y + half)};
}

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  std::vector<Entry> boxes;
  boxes.reserve(entries.size());
  for (const DiscEntry& e : entries) boxes.emplace_back(box_of(e), &e);
  const rtree::rtree<Entry, rtree::quadratic<16>> tree(boxes);
  for (const auto& [box, i] : boxes) {
    if (i->is_image()) break;  // they follow the discs
    const auto offer = [&collector, disc = i](const Entry& found) {
      const DiscEntry& j = *found.second;
      if (j.disc > disc->disc)
        collector.offer(static_cast<std::size_t>(disc->disc), static_cast<std::size_t>(j.disc),
                        j.image);
    };
    tree.query(rtree::intersects(box), boost::make_function_output_iterator(offer));
  }
  collector.work().places = entries.size();
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor boost_boxes;
constinit const OverlapEngineDescriptor boost_boxes{
    .name = "boost_boxes",
    .summary = "Asks an R-tree of the boxes around all discs, packed at once, with each box.",
    .source = "Boost.Geometry, index::rtree",
    .library = "Boost " BOOST_LIB_VERSION,
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
