// SPDX-License-Identifier: MIT
#include "benchmarks/overlap/overlap_judge.hpp"

#include <algorithm>
#include <bit>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/overlap/lens.hpp"
#include "core/random/counter_stream.hpp"
#include "reference/oracles/alsweis_exact_lens.hpp"
#include "reference/oracles/disc_overlap.hpp"

namespace phytobench {

namespace {

constexpr std::size_t sampled_discs = 200;

std::vector<oracles::OracleDisc> oracle_discs(const OverlapWorkload& w) {
  std::vector<oracles::OracleDisc> discs;
  for (std::size_t i = 0; i < w.x.size(); ++i) discs.push_back({w.x[i], w.y[i], w.radius[i]});
  return discs;
}

oracles::OracleGround oracle_ground(const OverlapWorkload& w) {
  return {w.ground.period_x(), w.ground.period_y()};
}

std::string pair_text(const OverlapPairs& pairs, std::size_t p) {
  return fmt::format("discs {} and {} (area {})", pairs.first()[p], pairs.second()[p],
                     pairs.area()[p]);
}

/// -1, 0 or 1 as the pair of `a` comes before, with or after that of `b`.
int order_of(const OverlapPairs& a, const OverlapPairs& b, std::size_t p) {
  if (a.first()[p] != b.first()[p]) return a.first()[p] < b.first()[p] ? -1 : 1;
  if (a.second()[p] != b.second()[p]) return a.second()[p] < b.second()[p] ? -1 : 1;
  return 0;
}

}  // namespace

OverlapJudge::OverlapJudge(const OverlapWorkload& workload, std::uint64_t seed)
    : workload_(workload), seed_(seed) {
  const bool literal = workload.x.size() <= most_discs_literally;
  name_ = literal ? "double loop"
                  : fmt::format("table of centers, itself compared with plain loops for {} discs",
                                sampled_discs);
  const auto discs = oracle_discs(workload);
  const auto overlaps = literal ? oracles::overlaps_literally(discs, oracle_ground(workload))
                                : oracles::overlaps_by_table(discs, oracle_ground(workload));
  for (const oracles::OracleOverlap& o : overlaps) {
    pairs_.push_back(static_cast<DiscIndex>(o.i), static_cast<DiscIndex>(o.j),
                     lens_area(discs[static_cast<std::size_t>(o.i)].r,
                               discs[static_cast<std::size_t>(o.j)].r, o.distance));
    distances_.push_back(o.distance);
  }
  if (!literal) check_sample();
  // Engines sort images by area.
  pairs_.sort(workload.x.size());
}

void OverlapJudge::check_sample() const {
  const auto discs = oracle_discs(workload_);
  CounterStream stream(seed_, 77);
  const auto firsts = pairs_.first();
  for (std::size_t s = 0; s < sampled_discs; ++s) {
    const auto disc =
        static_cast<std::size_t>(stream.next_unit() * static_cast<double>(discs.size()));
    for (const oracles::OracleOverlap& o :
         oracles::overlaps_of(disc, discs, oracle_ground(workload_))) {
      const auto [from, to] =
          std::equal_range(firsts.begin(), firsts.end(), static_cast<DiscIndex>(o.i));
      bool is_there = false;
      for (auto p = from; p != to; ++p) {
        const auto at = static_cast<std::size_t>(p - firsts.begin());
        is_there |= pairs_.second()[at] == o.j && distances_[at] == o.distance;
      }
      PHYTOBENCH_ENSURE(is_there);
    }
  }
}

std::string OverlapJudge::disagreement(OverlapPairs& found) const {
  found.sort(workload_.x.size());
  const std::size_t both = std::min(found.size(), pairs_.size());
  for (std::size_t p = 0; p < both; ++p) {
    const int order = order_of(found, pairs_, p);
    if (order < 0) return "finds " + pair_text(found, p) + ", which do not overlap";
    if (order > 0) return "misses " + pair_text(pairs_, p);
    if (std::bit_cast<std::uint64_t>(found.area()[p]) !=
        std::bit_cast<std::uint64_t>(pairs_.area()[p]))
      return fmt::format("{}: area should be {}", pair_text(found, p), pairs_.area()[p]);
  }
  if (found.size() > both) return "finds " + pair_text(found, both) + " once too often";
  if (pairs_.size() > both) return "misses " + pair_text(pairs_, both);
  return {};
}

double OverlapJudge::largest_area_error(std::size_t sample) const {
  CounterStream stream(seed_, 78);
  double worst = 0.0;
  const auto discs = oracle_discs(workload_);
  const auto overlaps = distances_.size();
  for (std::size_t s = 0; s < sample && overlaps > 0; ++s) {
    const auto p = static_cast<std::size_t>(stream.next_unit() * static_cast<double>(overlaps));
    const double r = workload_.radius[static_cast<std::size_t>(pairs_.first()[p])];
    const double t = workload_.radius[static_cast<std::size_t>(pairs_.second()[p])];
    worst = std::max(worst, oracles::alsweis::lens_relative_error(r, t, distances_[p],
                                                                  lens_area(r, t, distances_[p])));
  }
  return worst;
}

}  // namespace phytobench
