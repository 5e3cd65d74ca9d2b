// SPDX-License-Identifier: MIT
// What engines share that only propose pairs: the test, the areas, and images of discs for indices
// that know no torus.
#pragma once

#include <array>
#include <vector>

#include "core/contract/check.hpp"
#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

/// Throws the InputError of an engine that has found too many pairs.
[[noreturn]] void refuse_more_pairs(std::size_t most_pairs);

/// Distances up to this may belong to overlapping discs: a few roundings above r + s, so that only
/// lens_area() decides.
constexpr double reach_of(double r, double s) {
  return (r + s) * (1.0 + 0x1p-50);
}

/// Takes proposed pairs one by one and computes areas in batches, which vectors do fastest.
class PairCollector {
 public:
  PairCollector(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                OverlapPairs& pairs)
      : discs_(discs), ground_(ground), most_pairs_(setup.most_pairs), pairs_(pairs) {
    pairs.clear();
  }

  void offer(std::size_t i, std::size_t j, TorusImage image) {
    ++work_.candidates;
    const double distance = center_distance(discs_, ground_, i, j, image);
    const double r = discs_.radius[i], s = discs_.radius[j];
    if (distance > reach_of(r, s)) return;
    if (waiting_ == batch) flush();
    r_[waiting_] = r;
    s_[waiting_] = s;
    distance_[waiting_] = distance;
    first_[waiting_] = static_cast<DiscIndex>(i < j ? i : j);
    second_[waiting_++] = static_cast<DiscIndex>(i < j ? j : i);
  }

  /// The last batch. Call it once.
  OverlapWork finish() {
    flush();
    return work_;
  }

  OverlapWork& work() { return work_; }

 private:
  static constexpr std::size_t batch = 512;
  void flush();

  const Discs& discs_;
  const Ground& ground_;
  std::size_t most_pairs_;
  OverlapPairs& pairs_;
  OverlapWork work_;
  std::size_t waiting_ = 0;
  std::array<double, batch> r_, s_, distance_, area_;
  std::array<DiscIndex, batch> first_, second_;
};

/// A disc, or its image on the other side of a torus, as an entry of an index on the open plane.
struct DiscEntry {
  double x, y, radius;
  DiscIndex disc;
  TorusImage image;

  bool is_image() const { return image != TorusImage{}; }
};

/// All discs in their order, then every image that may meet a disc. Discs of radius 0 meet nothing
/// and have no entry.
std::vector<DiscEntry> entries_with_images(const Discs& discs, const Ground& ground);

/// Whether a search around disc i that has found `entry` is the one that offers the pair: it is
/// found from both discs, or from the larger one only if reach is measured by that.
inline bool offers_from_larger(const Discs& discs, std::size_t i, const DiscEntry& entry) {
  const double r = discs.radius[i];
  return entry.radius < r || (entry.radius == r && i < static_cast<std::size_t>(entry.disc));
}

/// For indices that know centers but no radii: every disc has `search(entry, squared_reach, visit)`
/// call visit(row of an entry) for all centers within twice its own radius, which finds the smaller
/// of every pair.
template <class Search>
void offer_within_diameters(const Discs& discs, const std::vector<DiscEntry>& entries,
                            PairCollector& collector, const Search& search) {
  // A little more: touching is decided by the distance.
  constexpr double two_radii_squared = 4.000001;
  for (const DiscEntry& i : entries) {
    if (i.is_image()) break;  // they follow the discs
    const auto disc = static_cast<std::size_t>(i.disc);
    search(i, two_radii_squared * i.radius * i.radius, [&](std::size_t row) {
      const DiscEntry& j = entries[row];
      if (offers_from_larger(discs, disc, j))
        collector.offer(disc, static_cast<std::size_t>(j.disc), j.image);
    });
  }
}

}  // namespace phytobench
