// SPDX-License-Identifier: MIT
// A population of plants by the equations of [Alsweis] ch. 4, 5 and 7, plant by plant and pair by
// pair: the judge of faster ones. Corrected unless told to do as printed. Shares no code with
// core/.
#pragma once

#include <cstddef>
#include <limits>
#include <vector>

namespace phytobench::oracles::alsweis::competition {

struct LiteralSpecies {
  double R_max = 0.5, MGR = 0.05;        // (5.8), m, m per step
  double d_root = 15.0, b_root = 0.5;    // (4.1) below ground; the only zone of ch. 4
  double d_crown = 15.0, b_crown = 0.5;  // above ground
  double L = 1.0;                        // L_fac / q of (7.2), of its crown
  double rank = 1.0;                     // T_f / m of (7.3): 0 flat, 0.5 medium, 1 deep roots
  double stress = 0.0;                   // not in the text: loss on open ground, sec. 7.4
  int oldest = std::numeric_limits<int>::max();  // it dies at this age, steps
};

struct LiteralPlant {
  double x, y;  // m
  double R;     // basal radius, m
  std::size_t species = 0;
  int age = 0;         // steps
  int ill_since = -1;  // step, -1: never
  bool is_dead = false;
  std::vector<double> sizes = {};  // R after every step it lived, the start first
};

enum class Zones {
  one,  // (4.2) to (4.4), loss over the area of the circle
  two,  // (5.1) to (5.6), and ch. 7
};

enum class Death {
  never,
  mean_growth,           // mean of the last n growths below the threshold, as the cited work has it
  mean_relative_growth,  // the same over R
  mean_size,             // mean of the last n sizes below it, as printed
};

// Printed forms; death by size is Death::mean_size.
struct AsPrinted {
  bool gain_as_loss = false;        // (4.3): what a plant wins reduces its growth
  bool light_without_size = false;  // (7.2): the larger of two plants loses as much
  bool illness_from_2s = false;     // (7.4): T_k falls from 2 s to 0
  bool roots_of_pair = false;       // (7.3): one T_f for both plants
  bool one_term_more = false;       // (4.8): n + 1 terms over n
};

struct LiteralModel {
  std::vector<LiteralSpecies> species = std::vector<LiteralSpecies>(1);
  double period_x = 0.0, period_y = 0.0;  // of a torus, m; 0: the open plane
  Zones zones = Zones::one;
  double p = 0.5;            // (4.4), (5.5)
  bool has_light = false;    // (7.1), (7.2) instead of (5.3), (5.4)
  double k = 1.0;            // (7.1)
  bool has_roots = false;    // (7.3)
  bool has_illness = false;  // (7.4)
  bool has_stress = false;
  std::vector<int> s1 = {}, s2 = {};  // (5.6) of species j on i at [i * species + j]; empty: all 1
  bool lower_wins = false;            // of equal circles; else both lose half
  double illness_steps = 40.0;        // T_k has run its range by then
  bool illness_kills = false;         // and then
  Death death = Death::never;
  int n = 5;               // (4.8)
  double threshold = 0.0;  // m, m per step, or per step
  double grown_up = 0.95;  // of R_max: no death of slow growth from there on
  AsPrinted as_printed = {};
};

class LiteralStand {
 public:
  LiteralStand(LiteralModel model, std::vector<LiteralPlant> plants);

  void fall_ill(std::size_t plant);
  void remove(std::size_t plant);

  // phi_i of every plant as it stands now; 0 of dead ones.
  std::vector<double> losses() const;

  // Competition, growth of all at once by (5.9), death.
  void step();

  const std::vector<LiteralPlant>& plants() const { return plants_; }
  double root_radius(const LiteralPlant& plant) const;
  double crown_radius(const LiteralPlant& plant) const;

 private:
  struct Meeting;
  template <class Use>
  void for_images(std::size_t i, const Use& use) const;
  double loss_by_one_zone(std::size_t i) const;
  double loss_by_two_zones(std::size_t i) const;
  double sigma_of(const Meeting& meeting) const;
  double alpha_of(const Meeting& meeting) const;
  double beta_of(const Meeting& meeting, double A_i, double A_j, double gamma) const;
  double sign_of(const std::vector<int>& signs, const Meeting& meeting) const;
  bool dies(const LiteralPlant& plant) const;

  LiteralModel model_;
  std::vector<LiteralPlant> plants_;
  int steps_done_ = 0;
};

}  // namespace phytobench::oracles::alsweis::competition
