// SPDX-License-Identifier: MIT
#include "core/population/density_laws.hpp"

#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

void expect_valid(const CrowdedFecundity& law) {
  PHYTOBENCH_EXPECT(law.isolation > 0.0 && law.crowding >= 0.0);
  PHYTOBENCH_EXPECT(law.density_exponent > 0.0 && law.root > 0.0);
}

void expect_valid(const SelfThinning& law) {
  PHYTOBENCH_EXPECT(law.factor > 0.0 && law.exponent > 0.0);
}

}  // namespace

double surviving_density(double density, double crowding_mortality) {
  PHYTOBENCH_EXPECT(density >= 0.0 && crowding_mortality >= 0.0);
  return density / (1.0 + crowding_mortality * density);
}

double surviving_density(double density, double crowding_mortality, double survival) {
  PHYTOBENCH_EXPECT(survival >= 0.0 && survival <= 1.0);
  return surviving_density(survival * density, crowding_mortality);
}

double linear_fecundity(double weight, double at_no_weight, double per_weight) {
  PHYTOBENCH_EXPECT(weight >= 0.0);
  return at_no_weight + per_weight * weight;
}

double seeds_per_plant(const CrowdedFecundity& law, double density) {
  expect_valid(law);
  PHYTOBENCH_EXPECT(density >= 0.0);
  return std::pow(law.isolation + law.crowding * std::pow(density, law.density_exponent),
                  -1.0 / law.root);
}

double seeds_per_area(const CrowdedFecundity& law, double density) {
  return density * seeds_per_plant(law, density);
}

std::optional<double> limit_of_seeds_per_area(const CrowdedFecundity& law) {
  expect_valid(law);
  if (law.crowding == 0.0 || law.density_exponent < law.root) return std::nullopt;
  if (law.density_exponent > law.root) return 0.0;
  return std::pow(law.crowding, -1.0 / law.root);
}

std::optional<double> density_of_most_seeds(const CrowdedFecundity& law) {
  expect_valid(law);
  if (law.crowding == 0.0 || law.density_exponent <= law.root) return std::nullopt;
  const double excess = law.density_exponent / law.root - 1.0;
  return std::pow(law.isolation / (law.crowding * excess), 1.0 / law.density_exponent);
}

double thinned_weight(const SelfThinning& law, double density) {
  expect_valid(law);
  PHYTOBENCH_EXPECT(density > 0.0);
  return law.factor * std::pow(density, -law.exponent);
}

double thinned_density(const SelfThinning& law, double weight) {
  expect_valid(law);
  PHYTOBENCH_EXPECT(weight > 0.0);
  return std::pow(weight / law.factor, -1.0 / law.exponent);
}

double thinned_yield(const SelfThinning& law, double density) {
  return density * thinned_weight(law, density);
}

double thinning_constant(double exponent, double weight, double density) {
  PHYTOBENCH_EXPECT(weight > 0.0 && density > 0.0);
  return std::log10(weight) + exponent * std::log10(density);
}

}  // namespace phytobench
