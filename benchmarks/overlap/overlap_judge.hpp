// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "benchmarks/overlap/overlap_workload.hpp"
#include "core/overlap/overlap_engine.hpp"

namespace phytobench {

/// Knows which discs of a workload overlap, from oracles that share no code with any engine: the
/// double loop for small ones; a table of centers for large ones, itself compared with plain loops
/// over everything for a seeded sample of discs.
class OverlapJudge {
 public:
  static constexpr std::size_t most_discs_literally = 5'000;

  OverlapJudge(const OverlapWorkload& workload, std::uint64_t seed);

  const std::string& name() const { return name_; }
  const std::vector<double>& distances() const { return distances_; }
  const OverlapPairs& pairs() const { return pairs_; }  ///< sorted, images apart

  /// What is wrong with what an engine found, in one line; empty if every pair is there once with
  /// the bits of lens_area(). Sorts `found` in place, images apart.
  std::string disagreement(OverlapPairs& found) const;

  /// Largest relative error of a seeded sample of areas against a hundred digits.
  double largest_area_error(std::size_t sample) const;

 private:
  void check_sample() const;

  const OverlapWorkload& workload_;
  std::uint64_t seed_;
  std::string name_;
  OverlapPairs pairs_;
  std::vector<double> distances_;
};

}  // namespace phytobench
