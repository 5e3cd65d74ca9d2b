// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <span>

#include "core/competition/pair_search.hpp"
#include "core/competition/zone_laws.hpp"
#include "core/overlap/discs.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace detail {

/// Plants belong to threads by blocks of neighbouring indices, turn by turn: wherever pairs are,
/// all threads have some.
constexpr std::size_t owned_block_bits = 10;

/// Adds what pairs cost the plants of one owner among several, in the order of the pairs.
template <class Law>
void add_losses_of_owner(const OverlapPairs& pairs, std::size_t owner, std::size_t owners,
                         std::span<double> lost, const Law& law) {
  const auto first = pairs.first(), second = pairs.second();
  const auto area = pairs.area();
  const auto is_own = [&](std::size_t plant) {
    return owners == 1 || (plant >> owned_block_bits) % owners == owner;
  };
  for (std::size_t k = 0; k < pairs.size(); ++k) {
    const auto i = static_cast<std::size_t>(first[k]), j = static_cast<std::size_t>(second[k]);
    const bool has_i = is_own(i), has_j = is_own(j);
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
  const auto owners = static_cast<std::size_t>(std::max(search.threads(), 1));
  search.for_each_part(zone, ground, [&](std::span<const OverlapPairs> pieces) {
    for_tasks(owners, search.threads(), [&](std::size_t owner) {
      for (const OverlapPairs& piece : pieces)
        detail::add_losses_of_owner(piece, owner, owners, lost, law);
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
