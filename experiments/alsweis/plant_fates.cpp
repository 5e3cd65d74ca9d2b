// SPDX-License-Identifier: MIT
#include "experiments/alsweis/plant_fates.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"

namespace phytobench::experiments::alsweis {

Fates fates_at_start(const Stand& stand) {
  Fates fates{.place = std::vector<Point2>(stand.size()),
              .species = std::vector<SpeciesIndex>(stand.size()),
              .start_radius = std::vector<double>(stand.size()),
              .radius = {}};
  for (std::size_t i = 0; i < stand.size(); ++i) {
    const auto id = static_cast<std::size_t>(stand.id[i]);
    fates.place.at(id) = stand.place(i);
    fates.species.at(id) = stand.species[i];
    fates.start_radius.at(id) = stand.stem_radius[i];
  }
  fates.radius = fates.start_radius;
  return fates;
}

void update_fates(const Stand& stand, Fates& fates) {
  std::fill(fates.radius.begin(), fates.radius.end(), 0.0);
  for (std::size_t i = 0; i < stand.size(); ++i) {
    PHYTOBENCH_EXPECT(stand.id[i] < fates.size());
    fates.radius[static_cast<std::size_t>(stand.id[i])] = stand.stem_radius[i];
  }
}

void Tally::add(double start_radius, double radius) {
  ++plants;
  if (radius <= 0.0) return;
  ++survivors;
  radii += radius;
  grown += radius / start_radius;
}

Tally& Tally::operator+=(const Tally& other) {
  plants += other.plants;
  survivors += other.survivors;
  radii += other.radii;
  grown += other.grown;
  return *this;
}

double standard_errors_between(const Tally& low, const Tally& high) {
  const auto n = static_cast<double>(low.plants), m = static_cast<double>(high.plants);
  const double pooled = static_cast<double>(low.survivors + high.survivors) / (n + m);
  return (high.survival() - low.survival()) /
         std::sqrt(pooled * (1.0 - pooled) * (1.0 / n + 1.0 / m));
}

void record_tally(ExperimentContext& context, const std::string& group, const Tally& tally) {
  const auto record = [&](const char* what, RecordValue value, const char* unit) {
    context.record({.experiment = {},
                    .measurement = group + what,
                    .value = std::move(value),
                    .unit = unit,
                    .sample_size = std::max<std::int64_t>(1, tally.plants),
                    .seed = context.seed()});
  };
  record("/plants", tally.plants, "plants");
  record("/survivors", tally.survivors, "plants");
  if (tally.plants == 0) return;
  record("/survival", tally.survival(), "1");
  if (tally.survivors == 0) return;
  record("/mean_radius", tally.mean_radius(), "m");
  record("/mean_growth", tally.mean_growth(), "1");
}

}  // namespace phytobench::experiments::alsweis
