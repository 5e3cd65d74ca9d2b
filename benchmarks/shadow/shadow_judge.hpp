// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>

#include "benchmarks/shadow/shadow_workload.hpp"
#include "core/terrain/shadow/lit_maps.hpp"

namespace phytobench {

/// Knows which vertices of a workload are lit: every ray traversed exactly on small maps; on large
/// ones max_pyramid, itself compared with rays of a seeded sample of vertices.
class ShadowJudge {
 public:
  static constexpr std::size_t most_vertices_literally = 2048 * 2048;
  static constexpr std::size_t sampled_rays = 20'000;

  /// Throws ContractViolation if max_pyramid is wrong somewhere in the sample.
  ShadowJudge(const ShadowWorkload& workload, std::uint64_t seed, int threads);

  const std::string& name() const { return name_; }
  const LitMaps& lit() const { return lit_; }

  /// What is wrong with the maps, in one line; empty if they are the right ones bit by bit.
  std::string disagreement(const LitMaps& found) const;
  /// The share of vertex-hours that are.
  double wrong_share(const LitMaps& found) const;

 private:
  const ShadowWorkload& workload_;
  std::string name_;
  LitMaps lit_;
};

/// How many of a seeded sample of vertices are lit or dark against what their rays meet, each
/// traversed on its own.
std::uint64_t wrong_in_sample(const ShadowWorkload& workload, const LitMaps& lit, std::size_t rays,
                              std::uint64_t seed);

}  // namespace phytobench
