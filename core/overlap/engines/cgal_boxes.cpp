// SPDX-License-Identifier: MIT
// CGAL's intersecting boxes of discs. This part of CGAL is GPL: so is a program that contains this
// file.
#include <vector>

#include <CGAL/Box_intersection_d/Box_with_info_d.h>
#include <CGAL/Random.h>
#include <CGAL/box_intersection_d.h>
#include <CGAL/version.h>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

using Box = CGAL::Box_intersection_d::Box_with_info_d<double, 2, const DiscEntry*>;

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  const std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  std::vector<Box> boxes;
  boxes.reserve(entries.size());
  for (const DiscEntry& e : entries) {
    // Wider by more than rounding: touching is decided by the distance.
    const double half = e.radius * (1.0 + 1e-6);
    double low[] = {e.x - half, e.y - half}, high[] = {e.x + half, e.y + half};
    boxes.emplace_back(low, high, &e);
  }
  CGAL::get_default_random() = CGAL::Random(0);  // it would start from the clock
  CGAL::box_self_intersection_d(boxes.begin(), boxes.end(), [&](const Box& a, const Box& b) {
    const DiscEntry &i = *a.info(), &j = *b.info();
    if (i.is_image() && j.is_image()) return;
    // Of the two ways to see a pair across the border, the image of the later disc counts.
    const DiscEntry &image = i.is_image() ? i : j, &disc = i.is_image() ? j : i;
    if (image.is_image() && image.disc <= disc.disc) return;
    collector.offer(static_cast<std::size_t>(disc.disc), static_cast<std::size_t>(image.disc),
                    image.image);
  });
  collector.work().places = entries.size();
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor cgal_boxes;
constinit const OverlapEngineDescriptor cgal_boxes{
    .name = "cgal_boxes",
    .summary = "Has CGAL intersect the boxes around all discs.",
    .source = "CGAL, box_self_intersection_d (Zomorodian and Edelsbrunner 2002)",
    .library = "CGAL " CGAL_VERSION_STR,
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
