// SPDX-License-Identifier: MIT
// Sort and sweep: discs in the order of their left ends, each compared with those that begin before
// it ends. Time grows as n^1.5 on a square.
#include <algorithm>
#include <vector>

#include "core/overlap/candidate_pairs.hpp"

namespace phytobench::overlap_engines {

namespace {

OverlapWork find_overlaps(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                          OverlapPairs& pairs) {
  PairCollector collector(discs, ground, setup, pairs);
  std::vector<DiscEntry> entries = entries_with_images(discs, ground);
  const auto left = [](const DiscEntry& e) { return e.x - e.radius; };
  std::stable_sort(entries.begin(), entries.end(),
                   [&](const DiscEntry& a, const DiscEntry& b) { return left(a) < left(b); });
  for (std::size_t a = 0; a < entries.size(); ++a) {
    const DiscEntry& i = entries[a];
    // A little more than it reaches: touching is decided by the distance, not here.
    const double right = i.x + i.radius + 1e-6 * i.radius;
    for (std::size_t b = a + 1; b < entries.size() && left(entries[b]) <= right; ++b) {
      const DiscEntry& j = entries[b];
      if (std::abs(j.y - i.y) > 1.000001 * (i.radius + j.radius)) continue;
      if (i.is_image() && j.is_image()) continue;
      // Of the two ways to see a pair across the border, the image of the later disc counts.
      const DiscEntry& image = i.is_image() ? i : j;
      const DiscEntry& disc = i.is_image() ? j : i;
      if (image.is_image() && image.disc <= disc.disc) continue;
      collector.offer(static_cast<std::size_t>(disc.disc), static_cast<std::size_t>(image.disc),
                      image.image);
    }
  }
  collector.work().places = entries.size();
  return collector.finish();
}

}  // namespace

extern const OverlapEngineDescriptor sweep;
constinit const OverlapEngineDescriptor sweep{
    .name = "sweep",
    .summary = "Sorts discs by their left ends and compares each with those that begin inside it.",
    .source = "sort and sweep, Shamos and Hoey 1976",
    .create = overlap_engine_from<find_overlaps>,
};

}  // namespace phytobench::overlap_engines
