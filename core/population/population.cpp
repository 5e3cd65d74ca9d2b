// SPDX-License-Identifier: MIT
#include "core/population/population.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/competition/competition_registry.hpp"
#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/population/mortality.hpp"
#include "core/population/population_events.hpp"
#include "core/population/reproduction.hpp"
#include "core/population/size_growth.hpp"

namespace phytobench {

namespace {

/// Every so many steps seedlings are put among their neighbours.
constexpr std::int32_t steps_between_orders = 8;

CompetitionParameters with_traits(const PopulationParameters& parameters) {
  CompetitionParameters competition = parameters.competition;
  competition.species.clear();
  for (const Species& species : parameters.species) competition.species.push_back(species.traits);
  return competition;
}

void find_zone_radii(const PopulationParameters& parameters, const Stand& stand,
                     ZoneLaw Species::*zone, const ResourceMap& resource, int threads,
                     std::vector<double>& radii) {
  radii.resize(stand.size());
  for_blocks(stand.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      radii[i] = zone_radius(parameters.species[stand.species[i]].*zone, stand.stem_radius[i],
                             resource.at(stand.place(i)));
  });
}

/// A zone that meets itself round the torus has no overlap that rules know.
void check_zones(const PopulationParameters& parameters, const std::vector<double>& radii,
                 const char* which, std::int32_t step) {
  if (radii.empty() || !parameters.is_torus) return;
  const double largest = *std::max_element(radii.begin(), radii.end());
  const double side = std::min(parameters.ground.width(), parameters.ground.height());
  if (!(2.0 * largest < side))
    throw InputError(fmt::format(
        "in step {} a {} zone of radius {:.6g} m meets itself round a torus of {:.6g} m; enlarge "
        "ground.size, lower species.{}_factor, or set ground.torus = false",
        step, which, largest, side, which));
}

}  // namespace

Population::Population(PopulationParameters parameters, PopulationState state,
                       const OverlapEngineDescriptor& engine, int threads)
    : parameters_(std::move(parameters)),
      state_(std::move(state)),
      search_(engine, {.threads = threads, .most_pairs = most_pairs_of_a_step}),
      threads_(threads) {
  check_parameters(parameters_);
  PHYTOBENCH_EXPECT(state_.born.size() == parameters_.species.size());
  PHYTOBENCH_EXPECT(state_.recent_growth.size() ==
                    static_cast<std::size_t>(parameters_.mortality.window));
  const CompetitionRuleDescriptor& rule = competition_rule_named(parameters_.rule);
  rule_ = rule.create(with_traits(parameters_));
  reads_above_ = rule.uses_above;
}

std::vector<double> Population::root_radii() const {
  std::vector<double> radii;
  find_zone_radii(parameters_, state_.stand, &Species::roots, parameters_.nutrients, threads_,
                  radii);
  return radii;
}

std::vector<double> Population::crown_radii() const {
  std::vector<double> radii;
  find_zone_radii(parameters_, state_.stand, &Species::crown, parameters_.light, threads_, radii);
  return radii;
}

const std::vector<double>& Population::losses() {
  if (!is_assessed_) assess();
  return loss_;
}

void Population::step() {
  if (state_.step % steps_between_orders == 0 && order_by_place(state_, parameters_.ground))
    is_assessed_ = false;
  if (apply_events(state_, parameters_)) is_assessed_ = false;
  losses();
  pairs_found_ += pairs_now_;
  is_assessed_ = false;
  grow();
  remove_dead();
  reproduce(state_, parameters_);
  ++state_.step;
}

void Population::assess() {
  const Stand& stand = state_.stand;
  find_zone_radii(parameters_, stand, &Species::roots, parameters_.nutrients, threads_,
                  root_radius_);
  check_zones(parameters_, root_radius_, "root", state_.step);
  if (reads_above_) {
    find_zone_radii(parameters_, stand, &Species::crown, parameters_.light, threads_,
                    crown_radius_);
    check_zones(parameters_, crown_radius_, "crown", state_.step);
  }
  update_weakening();
  loss_.resize(stand.size());
  const CompetingPlants plants{.below = {stand.x, stand.y, root_radius_},
                               .above = {stand.x, stand.y, crown_radius_},
                               .stem_radius = stand.stem_radius,
                               .species = stand.species,
                               .weakening = weakening_,
                               .id = stand.id};
  Ground ground;
  if (parameters_.is_torus) ground.torus = parameters_.ground;
  const std::uint64_t before = search_.pairs_found();
  rule_->assess(plants, ground, search_, loss_);
  pairs_now_ = search_.pairs_found() - before;
  is_assessed_ = true;
}

void Population::update_weakening() {
  const std::vector<std::int32_t>& ill_since = state_.stand.ill_since;
  weakening_.clear();
  const bool can_be_ill =
      std::any_of(parameters_.events.begin(), parameters_.events.end(),
                  [](const PopulationEvent& event) { return event.kind == EventKind::disease; });
  if (!can_be_ill || std::all_of(ill_since.begin(), ill_since.end(),
                                 [](std::int32_t since) { return since == healthy; }))
    return;
  const double duration = parameters_.illness.duration;
  weakening_.resize(ill_since.size(), 0.0);
  for (std::size_t i = 0; i < ill_since.size(); ++i)
    if (ill_since[i] != healthy)
      weakening_[i] = std::min(1.0, (state_.step - ill_since[i]) / duration);
}

void Population::grow() {
  Stand& stand = state_.stand;
  std::vector<float>& recent =
      state_.recent_growth[static_cast<std::size_t>(state_.step) % state_.recent_growth.size()];
  is_dead_.resize(stand.size());
  // Death follows in the same pass: what it reads is then at hand.
  for_blocks(stand.size(), threads_, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const Species& species = parameters_.species[stand.species[i]];
      const double radius = stand.stem_radius[i];
      const double grown = growth_rate(species, radius) * growth_factor(loss_[i]);
      // A long step under strong help must not carry it beyond its largest size.
      const double next = std::min(radius + grown, std::max(species.largest_radius, radius));
      recent[i] = static_cast<float>(next - radius);
      stand.stem_radius[i] = next;
      ++stand.age[i];
      is_dead_[i] = dies(state_, parameters_, i) ? 1 : 0;
    }
  });
}

void Population::remove_dead() {
  if (std::find(is_dead_.begin(), is_dead_.end(), 1) != is_dead_.end())
    remove_plants(state_, is_dead_);
}

}  // namespace phytobench
