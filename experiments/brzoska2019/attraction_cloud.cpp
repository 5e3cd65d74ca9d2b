// SPDX-License-Identifier: MIT
// The cloud of attraction points: volumes, counts, uniformity and bounds.
#include "core/colonization/attraction_cloud.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/brzoska2019_equations.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

namespace printed = oracles::brzoska2019;

struct Cut {
  const char* name;
  double bottom;
  double top;
};
constexpr Cut cuts[] = {
    {"uncut", 0, 0}, {"default", 0.15, 0.05}, {"half", 0.5, 0}, {"figure-42", 0.6, 0}};

/// z score of a volume estimated from random points of the cube around the unit sphere.
double monte_carlo_z(const Cut& cut, std::uint64_t seed, std::uint64_t stream_index) {
  constexpr int samples = 200000;
  CounterStream stream(seed, stream_index);
  int hits = 0;
  for (int i = 0; i < samples; ++i) {
    const double x = stream.next_between(-1, 1);
    const double y = stream.next_between(-1, 1);
    const double z = stream.next_between(-1, 1);
    hits += x * x + y * y + z * z <= 1 && y >= -1 + 2 * cut.bottom && y <= 1 - 2 * cut.top;
  }
  const double p = unit_segment_volume(cut.bottom, cut.top) / 8.0;
  return (hits - samples * p) / std::sqrt(samples * p * (1 - p));
}

void record_base_volumes(ExperimentContext& context) {
  double formula_difference = 0.0, largest_z = 0.0;
  std::uint64_t stream = 100;
  for (const Cut& cut : cuts) {
    const double base = unit_segment_volume(cut.bottom, cut.top);
    context.record(std::string("base_volume/") + cut.name, base);
    formula_difference =
        std::max(formula_difference, std::abs(base - printed::base_volume(cut.bottom, cut.top)));
    largest_z = std::max(largest_z, std::abs(monte_carlo_z(cut, context.seed(), stream++)));
  }
  context.record("base_volume/formula_difference", formula_difference);
  context.record({.experiment = {},
                  .measurement = "base_volume/monte_carlo_z",
                  .value = largest_z,
                  .sample_size = 4 * 200000,
                  .seed = context.seed()});
}

std::int64_t points_of(const CutEllipsoid& shape, double density) {
  return static_cast<std::int64_t>(attraction_point_count(shape, density));
}

void record_counts(ExperimentContext& context) {
  for (const char* figure : {"figure-40", "figure-42", "figure-51"}) {
    const TreeParameters tree = thesis_tree(figure);
    context.record(std::string("points/") + figure, points_of(tree.cloud, tree.cloud_density));
  }
  const TreeParameters tree = thesis_tree("figure-51");
  const double target = volume(tree.cloud);
  context.record("volume/figure-51", target);
  context.record("points/figure-51-double-density", points_of(tree.cloud, 2 * tree.cloud_density));
  context.record("points_as_printed/figure-51",
                 printed::equation_22_as_printed(target, tree.cloud_density));
  context.record("points_as_printed/figure-51-double-density",
                 printed::equation_22_as_printed(target, 2 * tree.cloud_density));

  CutEllipsoid stretched = tree.cloud;
  stretched.radii.y *= 2.0;
  const double before = static_cast<double>(points_of(tree.cloud, tree.cloud_density)) / target;
  const double after =
      static_cast<double>(points_of(stretched, tree.cloud_density)) / volume(stretched);
  context.record("density_invariance/relative_difference", std::abs(after - before) / before);
  context.record("density_invariance/bound",
                 1.0 / static_cast<double>(points_of(tree.cloud, tree.cloud_density)));
}

int slice_of(double value, int slices) {
  return std::clamp(static_cast<int>(value * slices), 0, slices - 1);
}

double azimuth_share(const Vector3& p) {
  return std::atan2(p.z, p.x) / (2.0 * std::numbers::pi) + 0.5;
}

/// Full unit sphere in 4 x 4 x 4 cells of equal volume: shells of r^3, zones of y / r, sectors.
double p_value_in_unit_sphere(std::uint64_t seed) {
  CounterStream stream(seed, 110);
  const CutEllipsoid sphere{.radii = {1, 1, 1}, .cutoff_bottom = 0, .cutoff_top = 0};
  std::vector<std::int64_t> counts(64, 0);
  for (const Vector3& p : attraction_points(sphere, 64000, {0, -1, 0}, stream)) {
    const double r = norm(p);
    const int shell = slice_of(r * r * r, 4);
    const int zone = slice_of(0.5 * (p.y / r + 1.0), 4);
    ++counts[static_cast<std::size_t>((shell * 4 + zone) * 4 + slice_of(azimuth_share(p), 4))];
  }
  return uniformity_p_value(counts);
}

/// Cut, scaled and moved ellipsoid in 4 layers x 8 sectors of equal volume.
double p_value_in_cut_ellipsoid(std::uint64_t seed) {
  CounterStream stream(seed, 111);
  const CutEllipsoid shape;
  const Vector3 root{3, 5, -2};
  const double whole = unit_segment_volume(shape.cutoff_bottom, shape.cutoff_top);
  const double centre_y = root.y + shape.radii.y * (1.0 - 2.0 * shape.cutoff_bottom);
  std::vector<std::int64_t> counts(32, 0);
  for (const Vector3& p : attraction_points(shape, 32000, root, stream)) {
    const Vector3 unit{(p.x - root.x) / shape.radii.x, (p.y - centre_y) / shape.radii.y,
                       (p.z - root.z) / shape.radii.z};
    // Volume below the point's height, as a share: equal layers of it are equal volumes.
    const double top_share = std::max(0.5 * (1.0 - unit.y), shape.cutoff_top);
    const double below = unit_segment_volume(shape.cutoff_bottom, std::min(top_share, 0.8499999));
    const int layer = slice_of(below / whole, 4);
    ++counts[static_cast<std::size_t>(layer * 8 + slice_of(azimuth_share(unit), 8))];
  }
  return uniformity_p_value(counts);
}

void record_bounds(ExperimentContext& context) {
  const CutEllipsoid unit{.radii = {1, 1, 1}};
  context.record("height/default", 2.0 * (1.0 - unit.cutoff_top - unit.cutoff_bottom));
  double height_error = 0.0;
  std::int64_t violations = 0;
  const Vector3 root{0.5, 2.0, -1.0};
  for (const Cut& cut : cuts) {
    const CutEllipsoid shape{
        .radii = {2, 3, 4}, .cutoff_bottom = cut.bottom, .cutoff_top = cut.top};
    CounterStream stream(context.seed(), 120);
    const auto points = attraction_points(shape, 20000, root, stream);
    const double top = root.y + 2.0 * shape.radii.y * (1.0 - cut.top - cut.bottom);
    for (const Vector3& p : points) violations += p.y < root.y - 1e-6 || p.y > top + 1e-6;
    height_error = std::max(height_error, extent_of(points).extent().y - (top - root.y));
  }
  context.record("height/largest_error", height_error);
  context.record("bounds/violations", violations);
}

/// Whether cut-offs that leave nothing are refused instead of giving a volume of zero or less.
std::int64_t rejects_empty_cut() {
  try {
    unit_segment_volume(0.6, 0.4);
  } catch (const ContractViolation&) {
    return 1;
  }
  return 0;
}

void run(ExperimentContext& context) {
  context.progress("sampling clouds");
  record_base_volumes(context);
  record_counts(context);
  context.record({.experiment = {},
                  .measurement = "uniformity/p_value_unit",
                  .value = p_value_in_unit_sphere(context.seed()),
                  .sample_size = 64000,
                  .seed = context.seed()});
  context.record({.experiment = {},
                  .measurement = "uniformity/p_value_scaled",
                  .value = p_value_in_cut_ellipsoid(context.seed()),
                  .sample_size = 32000,
                  .seed = context.seed()});
  record_bounds(context);
  context.record("cutoff_limits/rejected", rejects_empty_cut());
}

}  // namespace

extern const ExperimentDescriptor attraction_cloud;
constinit const ExperimentDescriptor attraction_cloud{
    .id = "brzoska2019/attraction-cloud",
    .question =
        "Does the cloud of attraction points have the volume, number and distribution described?",
    .source = "[Brzoska2019] sec. 5.2.1, eq. 21, 22",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
