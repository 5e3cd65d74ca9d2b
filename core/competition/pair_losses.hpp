// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <vector>

#include "core/competition/pair_search.hpp"
#include "core/competition/zone_laws.hpp"
#include "core/overlap/discs.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace detail {

/// Which thread adds up the losses of a plant. Blocks of neighbouring indices belong to the threads
/// in turn: wherever pairs are, all threads have some.
class PlantOwners {
 public:
  PlantOwners(std::size_t plants, int threads) : threads_(std::max(threads, 1)) {
    of_block_.resize((plants >> block_bits) + 1);
    for (std::size_t block = 0; block < of_block_.size(); ++block)
      of_block_[block] = static_cast<std::uint16_t>(block % static_cast<std::size_t>(threads_));
  }

  int threads() const { return threads_; }
  std::size_t of(std::size_t plant) const { return of_block_[plant >> block_bits]; }

 private:
  static constexpr int block_bits = 10;
  int threads_;
  std::vector<std::uint16_t> of_block_;  ///< a look-up costs less than a division
};

/// Adds what pairs cost all plants, in the order of the pairs.
template <class Law>
void add_losses(const OverlapPairs& pairs, std::span<double> lost, const Law& law) {
  const auto first = pairs.first(), second = pairs.second();
  const auto area = pairs.area();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto i = static_cast<std::size_t>(first[k]), j = static_cast<std::size_t>(second[k]);
    const PairLosses losses = law(i, j, area[k]);
    lost[i] += losses.first;
    lost[j] += losses.second;
  }
}

/// The same for the plants of one owner among several.
template <class Law>
void add_losses_of_owner(const OverlapPairs& pairs, const PlantOwners& owners, std::size_t owner,
                         std::span<double> lost, const Law& law) {
  const auto first = pairs.first(), second = pairs.second();
  const auto area = pairs.area();
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto i = static_cast<std::size_t>(first[k]), j = static_cast<std::size_t>(second[k]);
    const bool has_i = owners.of(i) == owner, has_j = owners.of(j) == owner;
    if (!has_i && !has_j) continue;
    const PairLosses losses = law(i, j, area[k]);
    if (has_i) lost[i] += losses.first;
    if (has_j) lost[j] += losses.second;
  }
}

}  // namespace detail

/// Overwrites lost[i] with the sum over all pairs of plant i of what `law(i, j, overlap)`, a
/// PairLosses, takes from it. Every thread owns a part of the plants and looks at all pairs: each
/// sum has the order of the pairs, whatever the number of threads, and needs no memory. A pair of
/// two owners is computed twice, which is rare where neighbours have near indices.
template <class Law>
void sum_pair_losses(PairSearch& search, const Discs& zone, const Ground& ground,
                     std::span<double> lost, const Law& law) {
  std::fill(lost.begin(), lost.end(), 0.0);
  const detail::PlantOwners owners(lost.size(), search.threads());
  search.for_each_part(zone, ground, [&](std::span<const OverlapPairs> pieces) {
    if (owners.threads() == 1) {
      for (const OverlapPairs& piece : pieces) detail::add_losses(piece, lost, law);
      return;
    }
    for_tasks(static_cast<std::size_t>(owners.threads()), owners.threads(), [&](std::size_t owner) {
      for (const OverlapPairs& piece : pieces)
        detail::add_losses_of_owner(piece, owners, owner, lost, law);
    });
  });
}

/// loss[i] = factor * lost[i] / area of zone i; a zone without area loses nothing.
inline void divide_by_zone_area(const Discs& zone, double factor, std::span<double> loss,
                                int threads) {
  for_blocks(loss.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const double area = disc_area(zone.radius[i]);
      loss[i] = area > 0.0 ? factor * loss[i] / area : 0.0;
    }
  });
}

}  // namespace phytobench
