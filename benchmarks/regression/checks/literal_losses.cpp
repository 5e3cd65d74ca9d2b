// SPDX-License-Identifier: MIT
#include "benchmarks/regression/checks/literal_losses.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/regression/checks/field_over_disc.hpp"
#include "core/contract/check.hpp"
#include "reference/oracles/alsweis_competition_zones.hpp"
#include "reference/oracles/alsweis_stand.hpp"
#include "reference/oracles/disc_shares.hpp"

namespace phytobench {

namespace {

namespace literal = oracles::alsweis::competition;
using literal::disc_area_of;
using literal::LiteralModel;
using literal::LiteralPlant;
using literal::LiteralStand;
using literal::Zones;

/// Loss of the first plant of a stand of neighbours.
using Law = double (*)(const LiteralStand& near, const CompetitionParameters& parameters);

double literal_loss(const LiteralStand& near, const CompetitionParameters&) {
  return near.losses().front();
}

oracles::OracleDisc root_disc(const LiteralStand& near, std::size_t plant) {
  const LiteralPlant& one = near.plants()[plant];
  return {one.x, one.y, near.root_radius(one)};
}

/// Part of its zone that the first of the discs does not win.
double lost_share(const std::vector<oracles::OracleDisc>& discs, double exponent) {
  const double won = oracles::disc_shares_by_strips(discs, {}, exponent).front();
  return 1.0 - won / disc_area_of(discs.front().r);
}

double lost_to_each_alone(const LiteralStand& near, const CompetitionParameters& parameters) {
  double lost = 0.0;
  for (std::size_t j = 1; j < near.plants().size(); ++j)
    lost += lost_share({root_disc(near, 0), root_disc(near, j)}, parameters.asymmetry_exponent);
  return lost;
}

double lost_to_all_together(const LiteralStand& near, const CompetitionParameters& parameters) {
  std::vector<oracles::OracleDisc> discs;
  for (std::size_t j = 0; j < near.plants().size(); ++j) discs.push_back(root_disc(near, j));
  return lost_share(discs, parameters.asymmetry_exponent);
}

double lost_to_fields(const LiteralStand& near, const CompetitionParameters& parameters) {
  const double radius = root_disc(near, 0).r;
  double lost = 0.0;
  for (std::size_t j = 1; j < near.plants().size(); ++j) {
    const oracles::OracleDisc other = root_disc(near, j);
    const double stem = near.plants()[j].R;
    lost += field_over_disc({.stem = stem, .zone = other.r, .at_rim = parameters.field_at_rim},
                            radius, std::hypot(other.x, other.y));
  }
  return lost / disc_area_of(radius);
}

/// A rule in the oracles' terms.
struct LiteralRule {
  std::string_view name;
  Zones zones = Zones::two;
  std::optional<double> p = std::nullopt;  ///< without one that of the parameters
  bool has_light = false, has_roots = false, has_illness = false, has_stress = false;
  bool has_signs = false;
  bool roots_help = false;  ///< where no table says otherwise
  Law law = literal_loss;
  double tolerance = 1e-10;
};

constexpr auto literal_rules = std::to_array<LiteralRule>({
    {.name = "symmetric", .zones = Zones::one, .p = 0.0},
    {.name = "asymmetric", .zones = Zones::one, .p = 1.0},
    {.name = "mixture", .zones = Zones::one},
    {.name = "above_below"},
    {.name = "influence_signs", .has_signs = true},
    {.name = "light", .has_light = true},
    {.name = "roots", .has_roots = true},
    {.name = "disease", .has_illness = true},
    {.name = "nurse", .has_stress = true, .has_signs = true, .roots_help = true},
    {.name = "combined",
     .has_light = true,
     .has_roots = true,
     .has_illness = true,
     .has_stress = true,
     .has_signs = true},
    {.name = "asymmetry_exponent", .zones = Zones::one, .law = lost_to_each_alone},
    {.name = "exact_shares", .zones = Zones::one, .law = lost_to_all_together},
    {.name = "field_of_neighbourhood",
     .zones = Zones::one,
     .law = lost_to_fields,
     .tolerance = 1e-9},
});

const LiteralRule* literal_rule(std::string_view name) {
  for (const LiteralRule& rule : literal_rules)
    if (rule.name == name) return &rule;
  return nullptr;
}

std::vector<int> signs_of(const std::vector<Influence>& influence) {
  std::vector<int> signs;
  for (const Influence one : influence) signs.push_back(static_cast<int>(one));
  return signs;
}

LiteralModel model_of(const LiteralRule& rule, const PopulationParameters& parameters) {
  const CompetitionParameters& competition = parameters.competition;
  LiteralModel model{.species = {},
                     .zones = rule.zones,
                     .p = rule.p.value_or(competition.above_share),
                     .has_light = rule.has_light,
                     .k = competition.light_constant,
                     .has_roots = rule.has_roots,
                     .has_illness = rule.has_illness,
                     .has_stress = rule.has_stress};
  for (const Species& one : parameters.species)
    model.species.push_back({.d_root = one.roots.rich_factor,
                             .b_root = one.roots.exponent,
                             .d_crown = one.crown.rich_factor,
                             .b_crown = one.crown.exponent,
                             .L = one.traits.crown_opacity,
                             .rank = one.traits.root_rank,
                             .stress = one.traits.open_ground_stress});
  if (!rule.has_signs) return model;
  model.s1 = signs_of(competition.influence_above);
  model.s2 = signs_of(competition.influence_below);
  if (model.s2.empty() && rule.roots_help)
    model.s2.assign(model.species.size() * model.species.size(), -1);
  return model;
}

/// Plants around each plant on a torus.
class Neighbourhoods {
 public:
  Neighbourhoods(LiteralModel model, const PopulationParameters& parameters, const Stand& stand)
      : model_(std::move(model)),
        width_(parameters.ground.width()),
        height_(parameters.ground.height()) {
    for (std::size_t i = 0; i < stand.size(); ++i)
      plants_.push_back({stand.x[i], stand.y[i], stand.stem_radius[i], stand.species[i]});
    const LiteralStand radii(model_, plants_);
    for (const LiteralPlant& plant : plants_) {
      root_.push_back(radii.root_radius(plant));
      crown_.push_back(radii.crown_radius(plant));
      PHYTOBENCH_EXPECT(4.0 * std::max(root_.back(), crown_.back()) < std::min(width_, height_));
    }
  }

  /// Plant i at the origin, and behind it all whose zones meet its own.
  LiteralStand around(std::size_t i) const {
    std::vector<LiteralPlant> near;
    LiteralPlant own = plants_[i];
    own.x = own.y = 0.0;
    near.push_back(own);
    for (std::size_t j = 0; j < plants_.size(); ++j) {
      LiteralPlant other = plants_[j];
      other.x = shortest(other.x - plants_[i].x, width_);
      other.y = shortest(other.y - plants_[i].y, height_);
      const double reach = std::max(root_[i] + root_[j], crown_[i] + crown_[j]);
      if (j != i && std::hypot(other.x, other.y) < reach) near.push_back(other);
    }
    return {model_, std::move(near)};
  }

 private:
  static double shortest(double difference, double period) {
    return difference - period * std::round(difference / period);
  }

  LiteralModel model_;
  double width_, height_;
  std::vector<LiteralPlant> plants_;
  std::vector<double> root_, crown_;
};

}  // namespace

std::string objection_to_rule_losses(std::span<const double> found,
                                     const PopulationParameters& parameters, const Stand& stand) {
  PHYTOBENCH_EXPECT(parameters.is_torus && parameters.competition.ties == TieRule::share);
  PHYTOBENCH_EXPECT(parameters.nutrients.is_uniform() && parameters.light.is_uniform());
  if (found.size() != stand.size())
    return fmt::format("{} losses of {} plants", found.size(), stand.size());
  const LiteralRule* const rule = literal_rule(parameters.rule);
  if (rule == nullptr) return fmt::format("no oracle knows the rule '{}'", parameters.rule);
  const Neighbourhoods neighbourhoods(model_of(*rule, parameters), parameters, stand);
  for (std::size_t i = 0; i < found.size(); ++i) {
    const double expected = rule->law(neighbourhoods.around(i), parameters.competition);
    if (!(std::abs(found[i] - expected) <= rule->tolerance * std::max(1.0, std::abs(expected))))
      return fmt::format("plant {} loses {:.17g}, by the literal formulae {:.17g}", i, found[i],
                         expected);
  }
  return {};
}

}  // namespace phytobench
