// SPDX-License-Identifier: MIT
// No timing without agreement: an engine's answers are compared with the literal oracle in every
// iteration before any time is taken, and every timed tree is compared once more by its hash.
#pragma once

#include <memory>
#include <optional>
#include <string>

#include "benchmarks/nearest_node/growth_judge.hpp"
#include "core/colonization/growth.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench {

struct CheckedGrowth;

/// An engine and a run that agreed with the oracle in every iteration. Only grow_checked() makes
/// one, and only one of these can be timed.
class VerifiedRun {
 public:
  /// Grows once more and returns the tree with its times. Throws ContractViolation if it is another
  /// tree than the one that was checked: then its time is worth nothing. An engine from outside is
  /// no bug of ours: it throws PluginMisbehaved.
  GrowthResult grow() const;

  const EngineDescriptor& engine() const { return *engine_; }
  const std::string& hash() const { return hash_; }

 private:
  friend CheckedGrowth grow_checked(const EngineDescriptor&, const Seedling&, GrowthJudge&,
                                    const GrowthRun&);
  VerifiedRun(const EngineDescriptor& engine, const Seedling& seedling, std::string hash,
              GrowthRun run)
      : engine_(&engine), seedling_(&seedling), hash_(std::move(hash)), run_(std::move(run)) {}

  const EngineDescriptor* engine_;
  const Seedling* seedling_;
  std::string hash_;
  GrowthRun run_;
};

/// What a checked growth found: a verified run, or the first difference from the oracle.
struct CheckedGrowth {
  GrowthResult result;                  ///< meaningful only if verified
  std::optional<VerifiedRun> verified;  ///< must not outlive the seedling
  std::string disagreement;  ///< iteration, point, both nodes, both distances; empty if verified
};

/// Grows with an engine and stops at its first answer that differs from the judge's. Distances are
/// recomputed here: an engine cannot vouch for itself.
CheckedGrowth grow_checked(const EngineDescriptor& engine, const Seedling& seedling,
                           GrowthJudge& judge, const GrowthRun& run);

/// The same with the literal oracle.
CheckedGrowth grow_checked(const EngineDescriptor& engine, const Seedling& seedling,
                           const GrowthOracle& oracle, const GrowthRun& run);

}  // namespace phytobench
