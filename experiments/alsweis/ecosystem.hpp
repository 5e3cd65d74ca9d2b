// SPDX-License-Identifier: MIT
// Plants for the scenes of [Alsweis] sec. 5.5, 5.6 and 7.6. The dissertation prints how many plants
// of each kind there are; their sizes are ours, chosen so that a scene changes within some 30
// steps.
#pragma once

#include <cstdint>
#include <span>
#include <string>

#include "experiments/alsweis/paired_runs.hpp"

namespace phytobench::experiments::alsweis {

/// Beside those of paired_runs.hpp.
inline constexpr Question question_near_tree{51}, question_decline{52}, question_spacing{53},
    question_growth{54}, question_influence{55}, question_light{56}, question_nurses{57},
    question_roots{58}, question_epidemic{59};

/// Lengths in metres, factors d of R_FON = d sqrt(R).
struct PlantKind {
  const char* name;
  double root_factor, crown_factor;
  double largest_radius, growth_rate, start_radius;
};

inline constexpr PlantKind tree{"tree", 12, 10, 0.4, 0.04, 0.25};
inline constexpr PlantKind shrub{"shrub", 8, 6, 0.05, 0.005, 0.01};
inline constexpr PlantKind meadow_plant{"meadow plant", 5, 4, 0.006, 0.0006, 0.0015};
inline constexpr PlantKind flower{"flower", 5, 4, 0.008, 0.0008, 0.0015};

/// A zone of `factor` sqrt(R), on any ground.
ZoneLaw zone_of(double factor);

/// Radius of such a zone around a stem, m.
double zone_radius_of(double factor, double stem_radius);

/// As a species that is sown `count` times, with start radii that differ by up to a fifth.
Species species_of(const PlantKind& kind, std::int64_t count);

/// A square plot with edges, half of the competition above ground, in which plants die whose mean
/// growth over five steps falls below `least_growth` of their radius per step.
PopulationParameters plot_of(double side, double least_growth, std::uint64_t seed);

/// One plant in the middle of such a plot, of the first species.
StartPlant in_the_middle_of(double side, double stem_radius);

/// record_paired(), and `<group>/share_of_wins`: part of the pairs with a difference above 0, which
/// means the same for any number of pairs.
void record_order(ExperimentContext& context, const std::string& group,
                  std::span<const double> more, std::span<const double> less,
                  const std::string& unit = "1");

}  // namespace phytobench::experiments::alsweis
