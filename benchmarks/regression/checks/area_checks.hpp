// SPDX-License-Identifier: MIT
// Answers on areas of discs, compared with what the oracles say. Each check returns one line that
// says what is wrong; empty if nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "benchmarks/overlap/overlap_workload.hpp"
#include "core/overlap/coverage.hpp"
#include "core/overlap/discs.hpp"

namespace phytobench {

/// Common areas of pairs of discs, each against the textbook's form up to its own rounding. Where
/// that leaves less than nine digits, as near contact, and for a sample chosen with `seed`, against
/// a hundred digits to 1e-14, which lens_area() promises. Radii, distances and areas of equal
/// number.
std::string objection_to_lens_areas(std::span<const double> r, std::span<const double> s,
                                    std::span<const double> distance, std::span<const double> area,
                                    std::uint64_t seed);

/// The same for the overlaps of a scene. OverlapJudge demands the bits of lens_area(): this says
/// whether those are the area. `pairs` in the order of OverlapPairs::sort(), `distance` of centers
/// in that of the pairs, of several images of one pair the nearest first.
std::string objection_to_pair_areas(const OverlapPairs& pairs, std::span<const double> distance,
                                    const OverlapWorkload& workload, std::uint64_t seed);

/// Ground covered by discs on a torus, so small that no two meet more than once: how often it is
/// covered must add up to the torus and to all discs; of a sample of discs chosen with `seed`, what
/// others cover must be what strips say of their neighbours alone.
std::string objection_to_coverage(const Coverage& found, const OverlapWorkload& workload,
                                  std::uint64_t seed);

}  // namespace phytobench
