// SPDX-License-Identifier: MIT
#include "reference/oracles/alsweis_stand.hpp"

#include <cmath>

#include "reference/oracles/alsweis_competition_extended.hpp"
#include "reference/oracles/alsweis_competition_shares.hpp"
#include "reference/oracles/alsweis_competition_zones.hpp"
#include "reference/oracles/alsweis_overlap.hpp"

namespace phytobench::oracles::alsweis::competition {

namespace {

// (4.8): mean of the last n values, the newest last; as printed n + 1 of them over n.
double equation_4_8(const std::vector<double>& values, int n, bool as_printed) {
  double sum = 0.0;
  for (int l = 0; l < n + (as_printed ? 1 : 0); ++l)
    sum += values[values.size() - 1 - static_cast<std::size_t>(l)];
  return sum / n;
}

}  // namespace

// Plant i and one image of plant j.
struct LiteralStand::Meeting {
  const LiteralPlant& own;
  const LiteralPlant& other;
  double root_i, root_j;  // radii of the zones
  double crown_i, crown_j;
  double distance;
  double of_equals;  // what i loses of the overlap where the circles are equal
};

LiteralStand::LiteralStand(LiteralModel model, std::vector<LiteralPlant> plants)
    : model_(std::move(model)), plants_(std::move(plants)) {
  for (LiteralPlant& plant : plants_) plant.sizes = {plant.R};
}

void LiteralStand::fall_ill(std::size_t plant) {
  if (plants_[plant].ill_since < 0) plants_[plant].ill_since = steps_done_;
}

void LiteralStand::remove(std::size_t plant) {
  plants_[plant].is_dead = true;
}

double LiteralStand::root_radius(const LiteralPlant& plant) const {
  const LiteralSpecies& species = model_.species[plant.species];
  return equation_4_1(species.d_root, plant.R, species.b_root);
}

double LiteralStand::crown_radius(const LiteralPlant& plant) const {
  const LiteralSpecies& species = model_.species[plant.species];
  return equation_4_1(species.d_crown, plant.R, species.b_crown);
}

// Every other living plant; on a torus each of its nine copies is a neighbour of its own.
template <class Use>
void LiteralStand::for_images(std::size_t i, const Use& use) const {
  const int reach_x = model_.period_x > 0.0 ? 1 : 0, reach_y = model_.period_y > 0.0 ? 1 : 0;
  const double root_i = root_radius(plants_[i]), crown_i = crown_radius(plants_[i]);
  for (std::size_t j = 0; j < plants_.size(); ++j) {
    if (j == i || plants_[j].is_dead) continue;
    const double root_j = root_radius(plants_[j]), crown_j = crown_radius(plants_[j]);
    const double of_equals = !model_.lower_wins ? 0.5 : i < j ? 0.0 : 1.0;
    for (int kx = -reach_x; kx <= reach_x; ++kx)
      for (int ky = -reach_y; ky <= reach_y; ++ky) {
        const double dx = plants_[j].x + kx * model_.period_x - plants_[i].x;
        const double dy = plants_[j].y + ky * model_.period_y - plants_[i].y;
        use(Meeting{plants_[i], plants_[j], root_i, root_j, crown_i, crown_j,
                    std::sqrt(dx * dx + dy * dy), of_equals});
      }
  }
}

// Sum over j of (4.4), over the area of the circle: without that it would have a unit.
double LiteralStand::loss_by_one_zone(std::size_t i) const {
  double sum = 0.0;
  for_images(i, [&](const Meeting& meeting) {
    const double r_i = meeting.root_i, r_j = meeting.root_j;
    const double f_i = disc_area_of(r_i), f_j = disc_area_of(r_j);
    const double gamma = equation_a4_corrected(r_i, r_j, meeting.distance);
    const double alpha = model_.as_printed.gain_as_loss
                             ? equation_4_3_as_printed(f_i, f_j, gamma, 1.0 - meeting.of_equals)
                             : equation_4_3_corrected(f_i, f_j, gamma, 1.0 - meeting.of_equals);
    sum += equation_4_4(model_.p, alpha, equation_4_2(gamma)) / f_i;
  });
  return sum;
}

double LiteralStand::sign_of(const std::vector<int>& signs, const Meeting& meeting) const {
  if (signs.empty()) return 1.0;
  return signs[meeting.own.species * model_.species.size() + meeting.other.species];
}

// (5.1), (7.3), (7.4): one neighbour below ground.
double LiteralStand::sigma_of(const Meeting& meeting) const {
  const double r_i = meeting.root_i, r_j = meeting.root_j;
  const double A_i = disc_area_of(r_i);
  double sigma = equation_5_1(equation_a4_corrected(r_i, r_j, meeting.distance), A_i);
  if (model_.has_roots) {
    const double own = model_.species[meeting.own.species].rank;
    const double other = model_.species[meeting.other.species].rank;
    sigma *= 1.0 + (model_.as_printed.roots_of_pair ? T_f_as_printed(own, other, 1.0)
                                                    : T_f_corrected(other, 1.0));
  }
  if (model_.has_illness && meeting.other.ill_since >= 0) {
    const double since = steps_done_ - meeting.other.ill_since;
    sigma *=
        1.0 + (model_.as_printed.illness_from_2s ? T_k_as_printed(1.0, since, model_.illness_steps)
                                                 : T_k_corrected(1.0, since, model_.illness_steps));
  }
  return sigma;
}

double LiteralStand::beta_of(const Meeting& meeting, double A_i, double A_j, double gamma) const {
  if (!model_.has_light) return equation_5_2(A_i, A_j, gamma, meeting.of_equals);
  const LiteralSpecies& larger =
      model_.species[A_i >= A_j ? meeting.own.species : meeting.other.species];
  return model_.as_printed.light_without_size
             ? equation_7_2_as_printed(1.0, larger.L, gamma)
             : equation_7_2_corrected(1.0, larger.L, gamma, A_i, A_j, meeting.of_equals);
}

// (5.2) to (5.4), or (7.1) and (7.2): one neighbour above ground.
double LiteralStand::alpha_of(const Meeting& meeting) const {
  const double r_i = meeting.crown_i, r_j = meeting.crown_j;
  const double A_i = disc_area_of(r_i), A_j = disc_area_of(r_j);
  const double gamma = equation_a4_corrected(r_i, r_j, meeting.distance);
  const int F = zone_index_F(meeting.distance, r_i, r_j);
  const double beta = beta_of(meeting, A_i, A_j, gamma);
  return model_.has_light ? equation_7_1(model_.k, beta, F, A_i)
                          : equations_5_3_and_5_4(beta, F, A_i);
}

// (5.6) with signs for each neighbour; (5.5) where all are 1.
double LiteralStand::loss_by_two_zones(std::size_t i) const {
  double phi = 0.0;
  for_images(i, [&](const Meeting& meeting) {
    phi += equation_5_6(sign_of(model_.s1, meeting), sign_of(model_.s2, meeting), model_.p,
                        alpha_of(meeting), sigma_of(meeting));
  });
  return model_.has_stress ? phi + model_.species[plants_[i].species].stress : phi;
}

std::vector<double> LiteralStand::losses() const {
  std::vector<double> phi(plants_.size(), 0.0);
  for (std::size_t i = 0; i < plants_.size(); ++i)
    if (!plants_[i].is_dead)
      phi[i] = model_.zones == Zones::one ? loss_by_one_zone(i) : loss_by_two_zones(i);
  return phi;
}

void LiteralStand::step() {
  const std::vector<double> phi = losses();
  for (std::size_t i = 0; i < plants_.size(); ++i) {
    LiteralPlant& plant = plants_[i];
    if (plant.is_dead) continue;
    const LiteralSpecies& species = model_.species[plant.species];
    plant.R +=
        equation_5_9(equation_5_8(species.MGR, plant.R, species.R_max), equation_5_7(phi[i]));
    plant.sizes.push_back(plant.R);
    ++plant.age;
  }
  for (LiteralPlant& plant : plants_)
    if (!plant.is_dead) plant.is_dead = dies(plant);
  ++steps_done_;
}

bool LiteralStand::dies(const LiteralPlant& plant) const {
  const LiteralSpecies& species = model_.species[plant.species];
  if (plant.age >= species.oldest) return true;
  if (model_.illness_kills && plant.ill_since >= 0 &&
      steps_done_ + 1 - plant.ill_since >= model_.illness_steps)
    return true;
  if (model_.death == Death::never || plant.age < model_.n) return false;
  const bool more = model_.as_printed.one_term_more;
  if (model_.death == Death::mean_size)
    return equation_4_8(plant.sizes, model_.n, more) < model_.threshold;
  if (plant.R >= model_.grown_up * species.R_max) return false;
  std::vector<double> growths;
  for (std::size_t t = 1; t < plant.sizes.size(); ++t)
    growths.push_back(plant.sizes[t] - plant.sizes[t - 1]);
  if (more && plant.age < model_.n + 1) return false;
  const double least =
      model_.death == Death::mean_growth ? model_.threshold : model_.threshold * plant.R;
  return equation_4_8(growths, model_.n, more) < least;
}

}  // namespace phytobench::oracles::alsweis::competition
