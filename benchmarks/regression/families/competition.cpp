// SPDX-License-Identifier: MIT
// What plants lose to their neighbours in one step, under every rule.
#include <fmt/format.h>

#include "benchmarks/competition/step_race.hpp"
#include "benchmarks/regression/checks/literal_losses.hpp"
#include "benchmarks/regression/families/kernel_digest.hpp"
#include "benchmarks/regression/watched_benchmarks.hpp"
#include "core/competition/competition_registry.hpp"
#include "core/overlap/overlap_registry.hpp"
#include "core/population/population.hpp"

namespace phytobench::families {

namespace {

constexpr std::int64_t plant_count = 1500;
constexpr double pairs_per_plant = 5.0;
constexpr std::uint64_t seed = 8;

PopulationParameters parameters_with(const CompetitionRuleDescriptor& rule) {
  PopulationParameters parameters = stepping_population(plant_count, pairs_per_plant, seed);
  parameters.rule = rule.name;
  return parameters;
}

/// As a step finds it: neighbours on the ground are neighbours in memory.
PopulationState ordered_state(const PopulationParameters& parameters) {
  PopulationState state = sow(parameters);
  order_by_place(state, parameters.ground);
  return state;
}

CompetitionParameters competition_of(const PopulationParameters& parameters) {
  CompetitionParameters competition = parameters.competition;
  competition.species.clear();
  for (const Species& species : parameters.species) competition.species.push_back(species.traits);
  return competition;
}

/// A population remembers its losses until it has grown; here they are found anew in every run, for
/// plants that stay as they are.
class LossKernel final : public WatchedKernel {
 public:
  explicit LossKernel(const CompetitionRuleDescriptor& rule)
      : parameters_(parameters_with(rule)),
        population_(parameters_, ordered_state(parameters_), engine()),
        root_radius_(population_.root_radii()),
        crown_radius_(population_.crown_radii()),
        competition_(competition_of(parameters_)),
        rule_(rule.create(competition_)),
        search_(engine(), {.most_pairs = most_pairs_of_a_step}) {
    ground_.torus = parameters_.ground;
    loss_.resize(plants().size());
  }

  std::string inputs() const override {
    const Stand& stand = population_.stand();
    KernelDigest digest;
    digest.add(stand.x).add(stand.y).add(stand.stem_radius).add(stand.species).add(stand.id);
    digest.add(root_radius_).add(crown_radius_).add(parameters_.rule);
    digest.add({ground_.period_x(), ground_.period_y(), competition_.above_share,
                competition_.asymmetry_exponent, digest_number(competition_.ties),
                competition_.light_constant, competition_.field_at_rim});
    digest.add(competition_.influence_above).add(competition_.influence_below);
    for (const CompetitionTraits& traits : competition_.species)
      digest.add({traits.crown_opacity, traits.root_rank, traits.open_ground_stress});
    return digest.hex();
  }

  void run() override {
    const std::uint64_t pairs = search_.pairs_found(), candidates = search_.candidates();
    rule_->assess(plants(), ground_, search_, loss_);
    pairs_ = search_.pairs_found() - pairs;
    candidates_ = search_.candidates() - candidates;
  }

  std::string answer() const override { return KernelDigest().add(loss_).hex(); }

  WorkCounts work() const override { return {{"pairs", pairs_}, {"candidates", candidates_}}; }

  std::string objection() override {
    Population again(parameters_, population_.state(), overlap_engine_named("all_pairs"));
    const std::string wrong = objection_to_losses(loss_, again.losses());
    if (!wrong.empty()) return wrong + " than with all pairs tried";
    return objection_to_rule_losses(loss_, parameters_, population_.stand());
  }

 private:
  static const OverlapEngineDescriptor& engine() { return overlap_engine_named("layered_grid"); }

  CompetingPlants plants() const {
    const Stand& stand = population_.stand();
    return {.below = {stand.x, stand.y, root_radius_},
            .above = {stand.x, stand.y, crown_radius_},
            .stem_radius = stand.stem_radius,
            .species = stand.species,
            .id = stand.id};
  }

  PopulationParameters parameters_;
  Population population_;
  std::vector<double> root_radius_, crown_radius_;
  CompetitionParameters competition_;
  std::unique_ptr<CompetitionRule> rule_;
  PairSearch search_;
  Ground ground_;
  std::vector<double> loss_;
  std::uint64_t pairs_ = 0, candidates_ = 0;
};

std::vector<WatchedBenchmark> list_losses(const FamilyRequest&) {
  std::vector<WatchedBenchmark> all;
  for (const CompetitionRuleDescriptor* rule : all_competition_rules()) {
    const bool reads_neighbours = rule->uses_below || rule->uses_above;
    if (!rule->built() || !reads_neighbours) continue;
    all.push_back({.name = fmt::format("competition/{}", rule->name),
                   .summary = fmt::format("Losses of {} plants with {} pairs each. {}", plant_count,
                                          pairs_per_plant, rule->summary),
                   .is_own = true,
                   .prepare = [rule] { return std::make_unique<LossKernel>(*rule); }});
  }
  return all;
}

}  // namespace

extern const BenchmarkFamily competition;
constinit const BenchmarkFamily competition{
    .name = "competition",
    .summary = "One step's losses under every rule of competition.",
    .list = list_losses,
};

}  // namespace phytobench::families
