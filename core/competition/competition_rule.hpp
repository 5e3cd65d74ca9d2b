// SPDX-License-Identifier: MIT
// The contract of every rule that says what neighbours cost a plant.
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <string_view>

#include "core/competition/competition_parameters.hpp"
#include "core/competition/pair_search.hpp"
#include "core/overlap/discs.hpp"

namespace phytobench {

/// Plants as a rule sees them: views of equal size. All radii are positive lengths in one unit.
struct CompetingPlants {
  Discs below;  ///< root zones; the one zone (FON) of [Alsweis] ch. 4
  Discs above;  ///< crown zones, around the same centers
  std::span<const double> stem_radius;
  std::span<const SpeciesIndex> species;  ///< into CompetitionParameters::species
  /// Part of its influence below ground that illness has taken from a plant, 0 (healthy) to 1.
  /// Empty: all are healthy.
  std::span<const double> weakening = {};
  /// Decides ties under TieRule::lower_id_wins. Empty: the index.
  std::span<const std::uint64_t> id = {};

  std::size_t size() const { return below.size(); }
};

class CompetitionRule {
 public:
  virtual ~CompetitionRule() = default;

  /// Overwrites loss[i] with phi_i, the share of its growth space that plant i loses: 0 without
  /// neighbours, negative where they help, beyond 1 where several take the same ground. The same
  /// bits for any number of threads of `search`, the same up to rounding for any order of plants.
  virtual void assess(const CompetingPlants& plants, const Ground& ground, PairSearch& search,
                      std::span<double> loss) = 0;
};

/// One constant of this type per file in rules/, one line in competition_rules.def.
struct CompetitionRuleDescriptor {
  std::string_view name;                  ///< that of its file
  std::string_view summary;               ///< one sentence
  std::string_view source;                ///< "[Key] where", or whom it comes from
  bool uses_below = true;                 ///< reads root zones
  bool uses_above = false;                ///< reads crown zones
  std::string_view missing_package = {};  ///< empty if built
  /// Throws InputError for parameters the rule cannot have (check_parameters() has passed).
  std::unique_ptr<CompetitionRule> (*create)(const CompetitionParameters&) = nullptr;

  bool built() const { return create != nullptr; }
};

}  // namespace phytobench
