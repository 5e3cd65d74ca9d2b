// SPDX-License-Identifier: MIT
// What becomes of plants in different parts of a plot.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/population/stand.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

/// What the plants of a population were when it began, and what became of them, by id.
struct Fates {
  std::vector<Point2> place;
  std::vector<SpeciesIndex> species;
  std::vector<double> start_radius;
  std::vector<double> radius;  ///< now, m; 0 of the dead

  std::size_t size() const { return place.size(); }
};

/// Of a population in which nothing has happened yet.
Fates fates_at_start(const Stand& stand);
/// Brings `radius` up to date. ContractViolation if plants have been born.
void update_fates(const Stand& stand, Fates& fates);

/// Plants of one part of a plot, over one run or many.
struct Tally {
  std::int64_t plants = 0, survivors = 0;
  double radii = 0.0;  ///< sum over the survivors, m
  double grown = 0.0;  ///< sum over the survivors of radius over start radius

  /// A radius of 0 is that of a dead plant.
  void add(double start_radius, double radius);
  void add(const Fates& fates, std::size_t plant) {
    add(fates.start_radius[plant], fates.radius[plant]);
  }
  Tally& operator+=(const Tally& other);

  double survival() const { return static_cast<double>(survivors) / static_cast<double>(plants); }
  double mean_radius() const { return radii / static_cast<double>(survivors); }
  double mean_growth() const { return grown / static_cast<double>(survivors); }
};

/// How many standard errors the first survival lies below the second, as proportions of plants that
/// die independently.
double standard_errors_between(const Tally& low, const Tally& high);

/// `<group>/plants`, `/survivors`, and what there is a mean of: `/survival`, and `/mean_radius` and
/// `/mean_growth` (radius over start radius) of the survivors.
void record_tally(ExperimentContext& context, const std::string& group, const Tally& tally);

}  // namespace phytobench::experiments::alsweis
