// SPDX-License-Identifier: MIT
// The worked examples and properties of the equations behind Table 1, computed by core.
#include <algorithm>
#include <cmath>

#include "core/colonization/growth_direction.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

using std::abs;

Vector3 random_vector(UnitStream& stream) {
  const double x = stream.next_between(-1.0, 1.0);
  const double y = stream.next_between(-1.0, 1.0);
  const double z = stream.next_between(-1.0, 1.0);
  return {x, y, z};
}

Vector3 direction_of(const Vector3& sum) {
  return growth_direction(sum, {}, TropismOrder::before_normalising).value_or(Vector3{});
}

std::int64_t grows(const Vector3& sum, const Vector3& tropism, TropismOrder order) {
  return growth_direction(sum, tropism, order).has_value() ? 1 : 0;
}

/// Eq. 9 on two points at distances 1 and 10, summed as unit vectors and as they are.
void record_equation_9(ExperimentContext& context) {
  for (const AttractionSum kind : {AttractionSum::unit_vectors, AttractionSum::raw_vectors}) {
    const Vector3 sum = attraction({}, {1, 0, 0}, kind) + attraction({}, {0, 10, 0}, kind);
    const std::string name = kind == AttractionSum::unit_vectors ? "unit" : "raw";
    context.record("equation-9/" + name + "_sum_x", direction_of(sum).x);
    context.record("equation-9/" + name + "_sum_y", direction_of(sum).y);
  }
  const Vector3 opposite = attraction({}, {0.3, 0, 0}, AttractionSum::unit_vectors) +
                           attraction({}, {-0.3, 0, 0}, AttractionSum::unit_vectors);
  context.record("equation-9/zero_sum_grows",
                 grows(opposite, {}, TropismOrder::before_normalising));
}

void record_equation_10(ExperimentContext& context) {
  CounterStream stream(context.seed(), 10);
  double length_error = 0.0, zero_error = 0.0, weights_error = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const Vector3 sum = random_vector(stream);
    const Vector3 tropism = random_vector(stream);
    for (const auto order : {TropismOrder::before_normalising, TropismOrder::after_normalising}) {
      if (const auto n = growth_direction(sum, tropism, order))
        length_error = std::max(length_error, abs(norm(*n) - 1.0));
      const Vector3 without = growth_direction(sum, {}, order).value_or(Vector3{});
      zero_error = std::max(zero_error, norm(without - direction_of(sum)));
    }
    TreeParameters parameters;
    parameters.cloud_density = 0.01;
    parameters.tropism_damping = TropismDamping::none;
    parameters.tropism_direction = sum;
    parameters.tropism_weights = tropism;
    const Vector3 effective = make_seedling(parameters).growth.tropism;
    weights_error =
        std::max({weights_error, abs(effective.x - sum.x * tropism.x),
                  abs(effective.y - sum.y * tropism.y), abs(effective.z - sum.z * tropism.z)});
  }
  context.record("equation-10/length_error", length_error);
  context.record("equation-10/zero_tropism_error", zero_error);
  context.record("equation-10/weights_error", weights_error);
  context.record("equation-10/opposite_tropism_grows",
                 grows({0, 2, 0}, {0, -1, 0}, TropismOrder::after_normalising));
}

/// Figure 33 over the interval of eq. 17's worked example, and that example.
void draw_kill_distance(ExperimentContext& context, const KillDistanceSchedule& schedule, int n) {
  PlotCurve curve{.name = "sigmoid", .x = {}, .y = {}};
  for (int i = 0; i <= 120; ++i) {
    curve.x.push_back(schedule.sigmoid_begin +
                      (schedule.sigmoid_end - schedule.sigmoid_begin) * i / 120.0);
    curve.y.push_back(sigmoid(curve.x.back()));
  }
  PlotCurve distance{.name = "kill distance", .x = {}, .y = {}, .style = PlotStyle::points};
  for (int i = 0; i < n; ++i) {
    distance.x.push_back(i);
    distance.y.push_back(schedule.at(i, n));
  }
  add_plot(context, "figure-33",
           {.title = "Figure 33: the sigmoid, and a kill distance that follows it",
            .description = "Left, the sigmoid rises from almost 0 to almost 1 over the interval of "
                           "the worked example. Right, the kill distance of that example falls "
                           "along it from 2 to 1.2 over 30 iterations.",
            .panels = {{.curves = {curve},
                        .caption = "a) sigmoid",
                        .x_label = "argument x",
                        .y_label = "sig(x)",
                        .x_range = AxisRange{schedule.sigmoid_begin, schedule.sigmoid_end},
                        .y_range = AxisRange{0.0, 1.0}},
                       {.curves = {distance},
                        .caption = "b) equation 17, worked example",
                        .x_label = "iteration i",
                        .y_label = "kill distance, length units",
                        .x_range = AxisRange{0.0, n - 1.0}}}});
}

/// The worked example of eq. 18-20 and what follows from eq. 17's form.
void record_equation_17(ExperimentContext& context) {
  const TomlTable example = thesis_parameters().table("equation").table("17");
  const KillDistanceSchedule schedule{.begin = example.number("begin"),
                                      .end = example.number("end"),
                                      .sigmoid_begin = example.number("sigmoid_begin"),
                                      .sigmoid_end = example.number("sigmoid_end"),
                                      .interpolation = KillInterpolation::linear};
  const int n = static_cast<int>(example.number("iterations"));
  for (const double step : example.numbers("steps")) {
    const int i = static_cast<int>(step);
    context.record("equation-17/i-" + std::to_string(i), schedule.at(i, n));
  }
  const double argument =
      schedule.sigmoid_begin + (schedule.sigmoid_end - schedule.sigmoid_begin) / (n - 1) * 14;
  context.record("equation-17/argument-14", argument);
  context.record("equation-17/sigmoid-14", sigmoid(argument));
  context.record("equation-17/middle_offset",
                 schedule.at(14, n) - 0.5 * (schedule.begin + schedule.end));
  std::int64_t increases = 0;
  double asymmetry = 0.0;
  for (int i = 0; i < n; ++i) {
    if (i > 0 && schedule.at(i, n) > schedule.at(i - 1, n)) ++increases;
    const double pair = schedule.at(i, n) + schedule.at(n - 1 - i, n);
    asymmetry = std::max(asymmetry, abs(pair - (schedule.begin + schedule.end)));
  }
  context.record("equation-17/increases", increases);
  context.record("equation-17/symmetry_error", asymmetry);
  context.record("equation-17/single_iteration", schedule.at(0, 1));
  context.record("sigmoid/at_minus_8", sigmoid(-8.0));
  context.record("sigmoid/at_8", sigmoid(8.0));
  draw_kill_distance(context, schedule, n);
}

void record_gnarliness(ExperimentContext& context) {
  for (const int gnarliness : {0, 1}) {
    const GnarlinessCoupling coupling = couple_to_gnarliness(gnarliness);
    const std::string name = "gnarliness-" + std::to_string(gnarliness) + "/";
    context.record(name + "influence_distance", coupling.influence_distance);
    context.record(name + "kill_distance_min", coupling.kill_distance_min);
    context.record(name + "kill_distance_max", coupling.kill_distance_max);
    context.record(name + "cloud_density", coupling.cloud_density);
    context.record(name + "kill_distance_at_density_0", coupling.kill_distance(0.0));
    context.record(name + "kill_distance_at_density_1", coupling.kill_distance(1.0));
  }
}

/// Eq. 23 and 24: the same nearest node with and without the root, except where rounding makes two
/// roots equal.
void record_distances(ExperimentContext& context) {
  constexpr int queries = 1000000;
  constexpr int nodes = 16;
  context.progress("comparing a million nearest nodes with and without the root");
  CounterStream stream(context.seed(), 24);
  std::vector<Vector3> node(nodes);
  std::int64_t differences = 0, shared_roots = 0;
  double largest_error = 0.0;
  for (int query = 0; query < queries; ++query) {
    if (query % 1000 == 0)
      for (Vector3& position : node) position = random_vector(stream);
    const Vector3 point = random_vector(stream);
    int by_root = 0, by_square = 0;
    double best_root = norm(point - node[0]), best_square = squared_distance(point, node[0]);
    bool shared = false;
    for (int i = 1; i < nodes; ++i) {
      const double square = squared_distance(point, node[static_cast<std::size_t>(i)]);
      const double root = std::sqrt(square);
      shared |= root == best_root && square != best_square;
      if (root < best_root) best_root = root, by_root = i;
      if (square < best_square) best_square = square, by_square = i;
    }
    differences += by_root != by_square;
    shared_roots += shared;
    const Vector3 offset = point - node[0];
    largest_error =
        std::max(largest_error, abs(norm(offset) - std::hypot(offset.x, offset.y, offset.z)));
  }
  context.record("equation-23/max_error", largest_error);
  context.record("equation-24/queries", std::int64_t{queries});
  context.record("equation-24/argmin_differences", differences);
  context.record("equation-24/shared_roots", shared_roots);
}

void run(ExperimentContext& context) {
  record_equation_9(context);
  record_equation_10(context);
  record_equation_17(context);
  record_gnarliness(context);
  record_distances(context);
}

}  // namespace

extern const ExperimentDescriptor equations;
constinit const ExperimentDescriptor equations{
    .id = "brzoska2019/equations",
    .question = "Do the equations behind Table 1 give the values the thesis works out?",
    .source = "[Brzoska2019] eq. 8-10, 17-20, 23, 24",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
