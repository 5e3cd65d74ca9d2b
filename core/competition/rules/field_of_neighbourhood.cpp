// SPDX-License-Identifier: MIT
#include "core/competition/neighbour_field.hpp"
#include "core/competition/one_zone_rule.hpp"

namespace phytobench::competition_rules {

namespace {

/// What a plant loses is the mean over its zone of all its neighbours' fields.
struct FieldLaw {
  explicit FieldLaw(const CompetitionParameters& parameters) : at_rim(parameters.field_at_rim) {}

  PairLosses operator()(const CompetingPlants& plants, const Discs& zone, const Ground& ground,
                        std::size_t i, std::size_t j, double overlap) const {
    const double distance = distance_of_pair(zone, ground, i, j, overlap);
    const NeighbourField field_i(plants.stem_radius[i], zone.radius[i], at_rim);
    const NeighbourField field_j(plants.stem_radius[j], zone.radius[j], at_rim);
    return {field_j.over_disc(zone.radius[i], distance),
            field_i.over_disc(zone.radius[j], distance)};
  }

  double at_rim;
};

}  // namespace

extern const CompetitionRuleDescriptor field_of_neighbourhood;
constinit const CompetitionRuleDescriptor field_of_neighbourhood{
    .name = "field_of_neighbourhood",
    .summary =
        "Neighbours' fields, which fall from 1 at the stem to F_min at the rim, averaged over a "
        "plant's zone.",
    .source = "Berger and Hildenbrandt 2000",
    .create = one_zone_rule<FieldLaw>,
};

}  // namespace phytobench::competition_rules
