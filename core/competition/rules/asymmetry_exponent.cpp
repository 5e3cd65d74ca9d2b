// SPDX-License-Identifier: MIT
#include <cmath>

#include "core/competition/one_zone_rule.hpp"

namespace phytobench::competition_rules {

namespace {

/// Shares area^a over the sum of both: 0 is the symmetric, infinity the asymmetric rule.
struct ExponentLaw {
  explicit ExponentLaw(const CompetitionParameters& parameters)
      : exponent(parameters.asymmetry_exponent), ties(parameters.ties) {}

  PairLosses operator()(const CompetingPlants& plants, const Discs& zone, const Ground&,
                        std::size_t i, std::size_t j, double overlap) const {
    const double first = won_by_second(plants, zone, i, j);
    return {first * overlap, (1.0 - first) * overlap};
  }

  /// Equal zones share equally for any finite exponent.
  double won_by_second(const CompetingPlants& plants, const Discs& zone, std::size_t i,
                       std::size_t j) const {
    if (std::isinf(exponent)) return lost_by_first(plants, zone, ties, i, j);
    const double ratio = zone.radius[i] / zone.radius[j];
    return 1.0 / (1.0 + std::pow(ratio, 2.0 * exponent));
  }

  double exponent;
  TieRule ties;
};

}  // namespace

extern const CompetitionRuleDescriptor asymmetry_exponent;
constinit const CompetitionRuleDescriptor asymmetry_exponent{
    .name = "asymmetry_exponent",
    .summary =
        "Each plant wins the overlap by its area to a power, from equal shares (0) to all for "
        "the larger (inf).",
    .source = "influence functions of siplab (Garcia 2014), for pairs",
    .create = one_zone_rule<ExponentLaw>,
};

}  // namespace phytobench::competition_rules
