// SPDX-License-Identifier: MIT
#include "core/population/stand_statistics.hpp"

#include <algorithm>
#include <numbers>

#include "core/contract/check.hpp"
#include "core/point_pattern/hopkins.hpp"
#include "core/point_pattern/nearest_neighbour_index.hpp"
#include "core/statistics/gini.hpp"

namespace phytobench {

namespace {

/// Sums over plants, in the order in which they are added.
class PlantSums {
 public:
  void add(double radius, double loss) {
    radii_ += radius;
    largest_ = std::max(largest_, radius);
    basal_areas_.push_back(std::numbers::pi * radius * radius);
    losses_ += loss;
    if (is_oppressed(loss)) ++oppressed_;
  }

  PlantStatistics statistics(double ground_area) const {
    PlantStatistics result;
    result.plants = basal_areas_.size();
    const auto count = static_cast<double>(result.plants);
    result.density = count / ground_area;
    if (basal_areas_.empty()) return result;
    for (const double area : basal_areas_) result.basal_area += area;
    result.mean_radius = radii_ / count;
    result.largest_radius = largest_;
    result.gini = gini_coefficient(basal_areas_);
    result.mean_loss = losses_ / count;
    result.oppressed_share = static_cast<double>(oppressed_) / count;
    return result;
  }

 private:
  std::vector<double> basal_areas_;
  double radii_ = 0.0, largest_ = 0.0, losses_ = 0.0;
  std::size_t oppressed_ = 0;
};

}  // namespace

StandStatistics stand_statistics(const Stand& stand, std::span<const double> loss,
                                 std::size_t species, double ground_area) {
  PHYTOBENCH_EXPECT(loss.size() == stand.size() && ground_area > 0.0);
  std::vector<PlantSums> by_species(species);
  PlantSums all;
  for (std::size_t i = 0; i < stand.size(); ++i) {
    PHYTOBENCH_EXPECT(stand.species[i] < species);
    by_species[stand.species[i]].add(stand.stem_radius[i], loss[i]);
    all.add(stand.stem_radius[i], loss[i]);
  }
  StandStatistics result;
  for (const PlantSums& sums : by_species) result.species.push_back(sums.statistics(ground_area));
  result.all = all.statistics(ground_area);
  return result;
}

StandPattern stand_pattern(const Stand& stand, const Rectangle& ground, bool is_torus,
                           int threads) {
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (stand.size() < 2) return {none, none, none};
  // In the order of ids: how plants lie in memory is nothing to the pattern.
  std::vector<Point2> places;
  for (const std::size_t i : order_of_ids(stand)) places.push_back(stand.place(i));
  const Window window = is_torus ? Window::torus(ground) : Window::rectangle(ground);
  const ClarkEvansIndex index = clark_evans(places, window, threads);
  return {index.ratio, hopkins_exact(places, window, threads).mean_ratio, index.mean_distance};
}

}  // namespace phytobench
