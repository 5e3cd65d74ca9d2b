// SPDX-License-Identifier: MIT
#include "core/population/reproduction.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/population/population_streams.hpp"
#include "core/population/seed_dispersal.hpp"
#include "core/population/seed_production.hpp"
#include "core/random/distributions.hpp"

namespace phytobench {

namespace {

/// Each takes up to six random numbers of the 2^24 that a plant has in a step.
constexpr double most_seeds_of_a_plant = 1e6;

class SeedYear {
 public:
  SeedYear(PopulationState& state, const PopulationParameters& parameters)
      : state_(state), parameters_(parameters), is_bad_(is_bad_year(parameters, state.step)) {}

  void wake_resting() {
    std::vector<DormantSeed> resting;
    resting.swap(state_.seeds);
    for (std::size_t place = 0; place < resting.size(); ++place) {
      const DormantSeed& seed = resting[place];
      CounterStream stream =
          draws_of(parameters_.seed, PopulationDraw::germination, place, state_.step);
      const ReproductionParameters& p = parameters_.species[seed.species].reproduction;
      if (stream.next_unit() < p.seed_mortality) continue;
      if (stream.next_unit() < p.germination_rate)
        germinate(seed, stream);
      else
        state_.seeds.push_back(seed);
    }
  }

  void shed_fresh() {
    // Seedlings of this step bear no seeds yet.
    const std::size_t parents = state_.stand.size();
    for (std::size_t i = 0; i < parents; ++i) shed(i);
  }

 private:
  void shed(std::size_t i) {
    const Stand& stand = state_.stand;
    const SpeciesIndex index = stand.species[i];
    const Species& species = parameters_.species[index];
    const ReproductionParameters& p = species.reproduction;
    if (!(stand.stem_radius[i] > p.threshold)) return;
    const SeedProduction production{p.threshold, p.seeds_per_metre, species.largest_radius};
    const double mean = production.expected_seeds(stand.stem_radius[i]);
    if (!(mean > 0.0)) return;
    if (mean > most_seeds_of_a_plant)
      throw InputError(
          fmt::format("a plant of radius {:.6g} m would shed {:.3g} seeds in a step; lower "
                      "species.reproduction.seeds_per_metre, so that it sheds at most {:g}",
                      stand.stem_radius[i], mean, most_seeds_of_a_plant));
    const SeedDispersal dispersal{p.dispersal, p.dispersal_distance};
    const Point2 mother = stand.place(i);
    CounterStream stream =
        draws_of(parameters_.seed, PopulationDraw::fruiting, stand.id[i], state_.step);
    for (std::uint64_t left = random_poisson(mean, stream); left > 0; --left) {
      const Point2 offset = dispersal.draw(stream);
      const double fate = stream.next_unit(), rest = stream.next_unit();
      const std::optional<Point2> place = on_the_ground(mother + offset);
      if (!place || fate < p.seed_mortality) continue;
      if (rest < p.dormant_share)
        keep({*place, index});
      else
        germinate({*place, index}, stream);
    }
  }

  void germinate(const DormantSeed& seed, CounterStream& stream) {
    const ReproductionParameters& p = parameters_.species[seed.species].reproduction;
    const bool takes_root = stream.next_unit() < p.establishment;
    if (is_bad_ || !takes_root) return;
    check_room();
    add_plant(state_, seed.place, p.seedling_radius, seed.species);
  }

  void keep(const DormantSeed& seed) {
    check_room();
    state_.seeds.push_back(seed);
  }

  void check_room() const {
    if (state_.stand.size() + state_.seeds.size() >= parameters_.most_plants)
      throw InputError(fmt::format(
          "more than {} plants and resting seeds in step {}; lower species.reproduction."
          "seeds_per_metre or establishment, or raise mortality",
          parameters_.most_plants, state_.step));
  }

  /// Round the torus; nothing where a seed falls off a plot with borders.
  std::optional<Point2> on_the_ground(const Point2& place) const {
    const Rectangle& ground = parameters_.ground;
    if (!parameters_.is_torus) return ground.contains(place) ? std::optional(place) : std::nullopt;
    const auto wrapped = [](double value, double low, double width) {
      const double share = (value - low) / width;
      return low + (share - std::floor(share)) * width;
    };
    return Point2{wrapped(place.x, ground.low.x, ground.width()),
                  wrapped(place.y, ground.low.y, ground.height())};
  }

  PopulationState& state_;
  const PopulationParameters& parameters_;
  bool is_bad_;
};

}  // namespace

bool is_bad_year(const PopulationParameters& parameters, std::int32_t step) {
  return draws_of(parameters.seed, PopulationDraw::season, 0, step).next_unit() <
         parameters.bad_year_share;
}

void reproduce(PopulationState& state, const PopulationParameters& parameters) {
  const bool bears_any = std::any_of(
      parameters.species.begin(), parameters.species.end(),
      [](const Species& species) { return std::isfinite(species.reproduction.threshold); });
  if (!bears_any && state.seeds.empty()) return;
  SeedYear year(state, parameters);
  year.wake_resting();
  year.shed_fresh();
}

}  // namespace phytobench
