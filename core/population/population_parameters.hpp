// SPDX-License-Identifier: MIT
// Everything a run of a population is started with. Lengths in metres, rates per step.
#pragma once

#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "core/competition/competition_parameters.hpp"
#include "core/geometry/point2.hpp"
#include "core/population/resource_map.hpp"
#include "core/population/seed_dispersal.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// Radius of a zone of influence, d R^b ([Alsweis] (4.1)); d depends on the resource at the stem.
struct ZoneLaw {
  double poor_factor = 15.0;  ///< d where the resource is 0, m^(1-b), > 0
  double rich_factor = 15.0;  ///< d where it is 1, > 0
  double exponent = 0.5;      ///< b, 0 to 3
};

enum class GrowthLaw {
  basal,     ///< MGR R / R_max (1 - R / R_max), [Alsweis] (5.8)
  richards,  ///< (2.1) with k = MGR / R_max, so that shape 2 is (5.8)
};

/// Seeds, from a threshold of size on ([Alsweis] sec. 4.4), and what becomes of them (sec. 4.6).
struct ReproductionParameters {
  double threshold = std::numeric_limits<double>::infinity();  ///< stem radius, m; inf: no seeds
  double seeds_per_metre = 0.0;  ///< seeds per step and metre of stem radius above the threshold
  DispersalLaw dispersal = DispersalLaw::radial_exponential;
  double dispersal_distance = 5.0;  ///< lambda, m, > 0
  double seed_mortality = 0.0;      ///< pi: part of all seeds that dies in a step, 0 to 1
  double dormant_share = 0.0;       ///< sigma: part of fresh seeds that rests, 0 to 1
  double germination_rate = 0.0;    ///< gamma: part of resting seeds that germinates in a step
  double establishment = 1.0;       ///< p: part of germinating seeds that becomes plants, 0 to 1
  double seedling_radius = 0.001;   ///< stem radius of a new plant, m, > 0
};

enum class MortalityRule {
  none,
  mean_growth,           ///< mean growth over the window is below the threshold, m per step
  mean_relative_growth,  ///< the same divided by the stem radius, 1 per step
  mean_size,             ///< mean radius over the window is below the threshold, m: as printed
};

/// Of any plant, m: below, powers of it lose their digits.
inline constexpr double smallest_stem_radius = 1e-9;

struct Species {
  std::string name;
  std::int64_t count = 0;  ///< plants at the start, besides those of a file
  double start_radius_low = 0.03, start_radius_high = 0.07;  ///< uniform between them, m
  double largest_radius = 0.5;                               ///< R_max, m
  GrowthLaw growth = GrowthLaw::basal;
  double growth_rate = 0.05;  ///< MGR, m per step: four times the largest growth
  double growth_shape = 2.0;  ///< delta of (2.1), for GrowthLaw::richards
  ZoneLaw roots, crown;
  CompetitionTraits traits;
  std::int32_t largest_age = std::numeric_limits<std::int32_t>::max();  ///< steps
  ReproductionParameters reproduction;
};

/// [Alsweis] sec. 4.5; the printed rule kills by size, the work it cites by growth.
struct MortalityParameters {
  MortalityRule rule = MortalityRule::none;
  std::int32_t window = 5;  ///< n: steps to take the mean over, 1 to 100; younger plants live
  double threshold = 0.0;
  /// Plants beyond this part of their largest radius do not die of slow growth.
  double grown_up = 0.95;
};

enum class EventKind {
  disease,  ///< plants fall ill
  removal,  ///< plants are taken out
};

/// At the start of a step, to the named plants, or to the `largest` largest, or to a random `share`
/// of the species (of all, without one). Exactly one of the three selects.
struct PopulationEvent {
  EventKind kind = EventKind::disease;
  std::int32_t step = 0;  ///< before this step is done, 0-based
  std::optional<SpeciesIndex> species = std::nullopt;
  std::vector<PlantId> plants = {};
  std::int64_t largest = 0;
  double share = 0.0;
};

/// T_k of [Alsweis] (7.4), corrected: an ill plant's influence below ground falls from full to
/// none.
struct IllnessParameters {
  std::int32_t duration = 40;  ///< steps until none is left, > 0
  bool is_deadly = false;      ///< it dies then
};

struct PopulationParameters {
  std::uint64_t seed = 0;
  std::int32_t steps = 60;
  Rectangle ground{{0.0, 0.0}, {200.0, 200.0}};
  bool is_torus = true;               ///< else seeds beyond the ground are lost
  std::string rule = "mixture";       ///< of competition_rules.def
  CompetitionParameters competition;  ///< its traits are those of `species`
  std::vector<Species> species;
  MortalityParameters mortality;
  IllnessParameters illness;
  double bad_year_share = 0.0;  ///< steps, at random, in which no seed becomes a plant, 0 to 1
  std::vector<PopulationEvent> events;
  ResourceMap nutrients, light;  ///< uniform 1 if empty
  std::size_t most_plants = 20'000'000;
};

/// Throws InputError, naming the parameter by its key in a file, for values out of range or at odds
/// with each other.
void check_parameters(const PopulationParameters& parameters);

}  // namespace phytobench
