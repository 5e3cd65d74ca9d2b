// SPDX-License-Identifier: MIT
// Plants that compete, grow, die and reproduce, step by step ([Alsweis] sec. 4.2 to 4.7, 5.4).
#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "core/competition/competition_rule.hpp"
#include "core/competition/pair_search.hpp"
#include "core/population/population_parameters.hpp"
#include "core/population/stand.hpp"

namespace phytobench {

/// A place, a size and a species: what a plant starts with.
struct StartPlant {
  Point2 place;
  double stem_radius = 0.0;
  SpeciesIndex species = 0;
};

/// The state before the first step: the plants given, then those that each species' `count` sows at
/// random, with ids in this order. Throws InputError for a plant off the ground or of a size that
/// is none.
PopulationState sow(const PopulationParameters& parameters,
                    std::span<const StartPlant> plants = {});

/// Overlaps that one step may have; beyond, it gives up with an InputError.
inline constexpr std::size_t most_pairs_of_a_step = 2'000'000'000;

/// One step is: events, competition, growth of all plants at once (explicit Euler), death, seeds.
/// Random numbers are a function of (seed, step, plant): the same bits for any number of threads,
/// and for a state that was saved and taken up again.
class Population {
 public:
  /// Throws InputError for parameters that check_parameters() refuses.
  Population(PopulationParameters parameters, PopulationState state,
             const OverlapEngineDescriptor& engine, int threads = 1);

  const PopulationParameters& parameters() const { return parameters_; }
  const PopulationState& state() const { return state_; }
  const Stand& stand() const { return state_.stand; }

  /// Throws InputError where the population grows beyond parameters().most_plants, or a zone of a
  /// plant meets itself round the torus; the object is then good for nothing but state().
  void step();

  /// phi of every plant as it stands now, in the stand's order. The next step need not find them
  /// again.
  const std::vector<double>& losses();
  /// Radii of the zones as they are now, in the stand's order.
  std::vector<double> root_radii() const;
  std::vector<double> crown_radii() const;

  /// Pairs of overlapping zones over all steps of this object.
  std::uint64_t pairs_found() const { return pairs_found_; }

 private:
  void assess();
  void update_weakening();
  void grow();
  void remove_dead();

  PopulationParameters parameters_;
  PopulationState state_;
  PairSearch search_;
  std::unique_ptr<CompetitionRule> rule_;
  bool reads_above_ = false;
  bool is_assessed_ = false;  ///< loss_ belongs to the state as it is
  std::uint64_t pairs_now_ = 0;
  std::uint64_t pairs_found_ = 0;
  int threads_;
  std::vector<double> root_radius_, crown_radius_, weakening_, loss_;  ///< when last assessed
  std::vector<std::uint8_t> is_dead_;
};

}  // namespace phytobench
