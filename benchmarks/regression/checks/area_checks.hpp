// SPDX-License-Identifier: MIT
// Answers on areas of discs, compared with what the oracles say. Each check returns one line that
// says what is wrong; empty if nothing.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "benchmarks/overlap/overlap_workload.hpp"
#include "core/overlap/coverage.hpp"

namespace phytobench {

/// Common areas of pairs of discs, against the textbook's form to 1e-12 of each. All spans have one
/// length. Only for circles that cross well: near contact the textbook's form has no such digits.
std::string objection_to_lens_areas(std::span<const double> r, std::span<const double> s,
                                    std::span<const double> distance, std::span<const double> area);

/// Ground covered by discs on a torus, so small that no two meet more than once: how often it is
/// covered must add up to the torus and to all discs; of a sample of discs chosen with `seed`, what
/// others cover must be what strips say of their neighbours alone.
std::string objection_to_coverage(const Coverage& found, const OverlapWorkload& workload,
                                  std::uint64_t seed);

}  // namespace phytobench
