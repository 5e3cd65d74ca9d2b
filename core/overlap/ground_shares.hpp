// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/overlap/neighbourhood.hpp"
#include "core/overlap/sharing_law.hpp"

namespace phytobench {

/// What each disc wins when all ground is divided among the discs that cover it: area, 0 to the
/// disc's own. All together win the area that is covered at all. Sums over pairs cannot tell: where
/// three discs overlap they divide the same ground more than once.
///
/// Exact up to rounding: a disc's part is off by some 1e-15 of its radius times the largest radius
/// of its neighbours for each arc within it, and weights relatively by 3e-13 at most, where they
/// are worlds apart. Time grows as the number of overlapping pairs times the
/// mean number of discs at a place. The same bits for any number of threads. Throws InputError
/// beyond most_pairs pairs (on a torus those of images, too); discs must be fit (problem_with()),
/// law.tie_order empty or as long as they are; ContractViolation for a negative exponent.
std::vector<double> ground_shares(const Discs& discs, const Ground& ground, const SharingLaw& law,
                                  int threads = 1,
                                  std::size_t most_pairs = OverlapSetup().most_pairs);

/// The same into `won`, one for each disc, with pairs from elsewhere.
void ground_shares(const Discs& discs, const Ground& ground, const SharingLaw& law, int threads,
                   const PairFinder& find, std::span<double> won);

}  // namespace phytobench
