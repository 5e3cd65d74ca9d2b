// SPDX-License-Identifier: MIT
// Plants that do not know of each other: what every comparison starts from.
#include <algorithm>

#include "core/competition/competition_rule.hpp"

namespace phytobench::competition_rules {

namespace {

struct NoCompetition final : CompetitionRule {
  void assess(const CompetingPlants&, const Ground&, PairSearch&, std::span<double> loss) override {
    std::fill(loss.begin(), loss.end(), 0.0);
  }
};

}  // namespace

extern const CompetitionRuleDescriptor none;
constinit const CompetitionRuleDescriptor none{
    .name = "none",
    .summary = "No plant takes anything from another.",
    .source = "[Alsweis] fig. 5.2 c",
    .uses_below = false,
    .create = [](const CompetitionParameters&) -> std::unique_ptr<CompetitionRule> {
      return std::make_unique<NoCompetition>();
    },
};

}  // namespace phytobench::competition_rules
