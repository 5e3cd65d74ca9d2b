// SPDX-License-Identifier: MIT
// No timing without agreement: an engine's answers are compared with the literal oracle in every iteration
// before any time is taken, and every timed tree is compared once more by its hash.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "core/colonization/growth.hpp"
#include "core/nearest_node/engine.hpp"
#include "reference/oracles/brzoska2019_space_colonization.hpp"

namespace phytobench {

/// The oracle's problem for a seedling: the same inputs in the oracle's own words.
oracles::brzoska2019::GrowthProblem oracle_problem(const Seedling& seedling);

/// The literal answer for one seedling, computed once.
class GrowthOracle {
 public:
  explicit GrowthOracle(const Seedling& seedling);

  const oracles::brzoska2019::GrownTree& tree() const { return tree_; }

  /// Hash of the whole skeleton, stem included, as tree_hash() would give it.
  const std::string& hash() const { return hash_; }

 private:
  oracles::brzoska2019::GrownTree tree_;
  std::string hash_;
};

/// What a checked growth found.
struct CheckedGrowth {
  GrowthResult result;                      ///< meaningful only without a disagreement
  std::optional<std::string> disagreement;  ///< iteration, point, both nodes, both distances
};

/// Grows with an engine and stops at its first answer that differs from the oracle's. Distances are
/// recomputed here: an engine cannot vouch for itself.
CheckedGrowth grow_checked(const EngineDescriptor& engine, const Seedling& seedling,
                           const GrowthOracle& oracle, const GrowthRun& run);

/// Grows and times with an engine that has been checked. Throws ContractViolation if the tree's hash is
/// not the oracle's: then its time is worth nothing.
GrowthResult grow_timed(const EngineDescriptor& engine, const Seedling& seedling,
                        const GrowthOracle& oracle, const GrowthRun& run);

}  // namespace phytobench
