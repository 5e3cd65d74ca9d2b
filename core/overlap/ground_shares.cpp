// SPDX-License-Identifier: MIT
// A disc's share of the ground is constant between arcs, so what it wins is a sum over arcs: share
// inside minus share outside, times the arc's part of Green's integral. Across a circle only two
// things change: its own disc has a share inside and none outside, and all who cover the arc have
// less inside. One walk around a circle therefore serves all discs that it crosses.
#include "core/overlap/ground_shares.hpp"

#include <algorithm>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/overlap/circle_walk.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// Below it, weights beside a disc's own are too small to tell others from each other.
constexpr double smallest_sum = 1e-280;

class SharingWalk {
 public:
  SharingWalk(const Neighbourhood& n, const SharingLaw& law, std::span<const double> disc_radius)
      : n_(n), law_(law), disc_radius_(disc_radius), circle_(n) {}

  /// What the arcs of circle i add to what its own disc wins. What they add to its k-th neighbour
  /// is written to neighbours_won[k].
  double around(std::size_t i, std::span<double> neighbours_won) {
    i_ = i;
    won_ = 0.0;
    neighbours_won_ = neighbours_won;
    std::fill(neighbours_won.begin(), neighbours_won.end(), 0.0);
    weigh_neighbours();
    circle_.begin(i);
    if (circle_.is_uncut()) {
      for (const int met : circle_.at_start()) change(met, +1);
      divide(std::numbers::pi * n_.radius[i] * n_.radius[i], {});
    } else {
      circle_.walk([this](int met, int step) { change(met, step); },
                   [this](const CircleArc& arc) {
                     divide(arc.around_center(), arc.to.local - arc.from.local);
                   });
    }
    return won_;
  }

 private:
  void weigh_neighbours() {
    const std::size_t count = neighbours_won_.size();
    cover_.clear();
    place_.resize(count);
    weight_.resize(count);
    for (std::size_t met = 0; met < count; ++met) weight_[met] = weight_ratio(entry(met), i_);
  }

  void change(int met, int step) {
    const auto m = static_cast<std::size_t>(met);
    if (step > 0) {
      place_[m] = cover_.size();
      cover_.push_back(m);
      return;
    }
    cover_[place_[m]] = cover_.back();
    place_[cover_.back()] = place_[m];
    cover_.pop_back();
  }

  /// An arc amid cover_: its Green integral seen from the circle's center, and the way from its
  /// begin to its end.
  void divide(double area, const Point2& chord) {
    double others = 0.0;  // in units of this disc's weight
    for (const std::size_t met : cover_) others += weight_[met];
    const double share = 1.0 / (1.0 + others);
    won_ += share * area;
    if (share == 0.0 || cover_.empty()) return;
    // Without this disc the others have all: each loses `share` of what it has outside.
    const std::size_t unit = others < smallest_sum ? strongest_of_cover() : i_;
    const auto weight = [&](std::size_t met) {
      return unit == i_ ? weight_[met] : weight_ratio(entry(met), unit);
    };
    if (unit != i_) {
      others = 0.0;
      for (const std::size_t met : cover_) others += weight(met);
    }
    for (const std::size_t met : cover_) {
      const Point2 shift = n_.center[i_] - n_.center[entry(met)];
      neighbours_won_[met] -= share * (weight(met) / others) * (area + 0.5 * cross(shift, chord));
    }
  }

  std::size_t strongest_of_cover() const {
    std::size_t strongest = entry(cover_.front());
    for (const std::size_t met : cover_)
      if (law_.is_before(disc_radius_, disc(entry(met)), disc(strongest))) strongest = entry(met);
    return strongest;
  }

  std::size_t entry(std::size_t met) const {
    return static_cast<std::size_t>(n_.neighbours(i_)[met]);
  }
  std::size_t disc(std::size_t e) const { return static_cast<std::size_t>(n_.disc[e]); }
  double weight_ratio(std::size_t e, std::size_t f) const {
    return law_.weight_ratio(disc_radius_, disc(e), disc(f));
  }

  const Neighbourhood& n_;
  const SharingLaw& law_;
  std::span<const double> disc_radius_;
  CircleWalk circle_;
  std::size_t i_ = 0;
  double won_ = 0.0;
  std::span<double> neighbours_won_;
  std::vector<double> weight_;      ///< of the neighbours, in units of this disc's
  std::vector<std::size_t> cover_;  ///< neighbours that cover the walk's place
  std::vector<std::size_t> place_;  ///< of a neighbour within cover_
};

}  // namespace

void ground_shares(const Discs& discs, const Ground& ground, const SharingLaw& law, int threads,
                   const PairFinder& find, std::span<double> won) {
  PHYTOBENCH_EXPECT(law.is_fit(discs.size()));
  PHYTOBENCH_EXPECT(won.size() == discs.size());
  const Neighbourhood n = neighbourhood_of(discs, ground, {}, find);
  std::vector<double> total(n.size()), neighbours_won(n.neighbour.size());
  for_blocks(n.size(), threads, [&](std::size_t begin, std::size_t end) {
    SharingWalk walk(n, law, discs.radius);
    for (std::size_t i = begin; i < end; ++i)
      total[i] =
          walk.around(i, std::span(neighbours_won).subspan(n.begin[i], n.neighbours(i).size()));
  });
  for (std::size_t k = 0; k < n.neighbour.size(); ++k)
    total[static_cast<std::size_t>(n.neighbour[k])] += neighbours_won[k];
  std::fill(won.begin(), won.end(), 0.0);
  for (std::size_t e = 0; e < n.originals; ++e) {
    const double area = std::numbers::pi * n.radius[e] * n.radius[e];
    won[static_cast<std::size_t>(n.disc[e])] = std::clamp(total[e], 0.0, area);
  }
}

std::vector<double> ground_shares(const Discs& discs, const Ground& ground, const SharingLaw& law,
                                  int threads, std::size_t most_pairs) {
  std::vector<double> won(discs.size());
  ground_shares(discs, ground, law, threads,
                own_pair_finder({.threads = threads, .most_pairs = most_pairs}), won);
  return won;
}

}  // namespace phytobench
