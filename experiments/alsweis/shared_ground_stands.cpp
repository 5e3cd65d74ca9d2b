// SPDX-License-Identifier: MIT
// Random stands of growing density: by how much sums over pairs exceed what plants lose. And the
// family of sharing laws between equal shares and all for the largest.
#include <algorithm>
#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/overlap/lens.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/running_moments.hpp"
#include "experiments/alsweis/zone_stand.hpp"
#include "experiments/experiment.hpp"
#include "experiments/plot_artifacts.hpp"

namespace phytobench::experiments::alsweis {

namespace {

constexpr std::size_t plants = 400;
constexpr double covers[] = {0.25, 0.5, 1, 1.5, 2, 3, 4, 6, 8};

/// Independent uniform places on a torus of 1 x 1; radii from one to three, the same in all stands
/// of a cover, which is the sum of their areas.
ZoneStand random_stand(double cover, std::uint64_t seed, std::uint64_t number) {
  ZoneStand stand;
  stand.ground.torus = Rectangle{{0, 0}, {1, 1}};
  CounterStream stream(seed, number);
  double areas = 0.0;
  for (std::size_t i = 0; i < plants; ++i) {
    const double x = stream.next_unit();
    stand.add(x, stream.next_unit(), 1.0 + 2.0 * static_cast<double>(i) / (plants - 1));
    areas += stand.area(i);
  }
  for (double& r : stand.radius) r *= std::sqrt(cover / areas);
  return stand;
}

/// What theory expects of the mean plant. Another plant of area p covers a place with probability
/// p, wherever it is.
struct Expectation {
  double pairs = 0.0, exact = 0.0;
};

/// All to the largest: a place is kept if none of the larger covers it.
Expectation expected_winner(const ZoneStand& stand) {
  Expectation mean;
  double kept = 1.0, pairs = 0.0;
  for (std::size_t i = stand.size(); i-- > 0;) {  // from the largest down
    mean.exact += (1.0 - kept) / plants;
    mean.pairs += pairs / plants;
    kept *= 1.0 - stand.area(i);
    pairs += stand.area(i);
  }
  return mean;
}

/// Equal shares: E[1 / (1 + K)] is the integral of E[t^K] over t from 0 to 1, and E[t^K] a product
/// over the others. Simpson's rule; the integrand is smooth.
Expectation expected_equal(const ZoneStand& stand) {
  Expectation mean;
  double areas = 0.0;
  for (std::size_t i = 0; i < stand.size(); ++i) areas += stand.area(i);
  for (std::size_t i = 0; i < stand.size(); ++i)
    mean.pairs += 0.5 * (areas - stand.area(i)) / plants;
  constexpr int steps = 400;
  double kept = 0.0;
  for (int k = 0; k <= steps; ++k) {
    const double t = static_cast<double>(k) / steps;
    const auto factor = [&](std::size_t i) { return 1.0 - stand.area(i) * (1.0 - t); };
    double product = 1.0, sum = 0.0;
    for (std::size_t i = 0; i < stand.size(); ++i) product *= factor(i);
    for (std::size_t i = 0; i < stand.size(); ++i) sum += product / factor(i);
    const double weight = k == 0 || k == steps ? 1.0 : k % 2 == 1 ? 4.0 : 2.0;
    kept += weight * sum / plants / (3.0 * steps);
  }
  mean.exact = 1.0 - kept;
  return mean;
}

struct StandMeans {
  RunningMoments pairs, exact, beyond;
};

void record_mean(ExperimentContext& context, const std::string& name, const RunningMoments& mean,
                 double expected) {
  const auto record = [&](const char* what, double value) {
    context.record({.experiment = {},
                    .measurement = name + what,
                    .value = value,
                    .sample_size = mean.count(),
                    .seed = context.seed()});
  };
  record("", mean.mean());
  record("_expected", expected);
  record("_deviation", (mean.mean() - expected) / mean.standard_error());
}

StandMeans measure(const ExperimentContext& context, double cover, double exponent, int stands) {
  StandMeans means;
  for (int s = 0; s < stands; ++s) {
    const ZoneStand stand = random_stand(cover, context.seed(), static_cast<std::uint64_t>(s));
    const auto pairs = stand.losses("asymmetry_exponent", exponent, context.threads());
    const auto exact = stand.losses("exact_shares", exponent, context.threads());
    double pair_sum = 0.0, exact_sum = 0.0;
    int beyond = 0;
    for (std::size_t i = 0; i < plants; ++i) {
      pair_sum += pairs[i] / plants;
      exact_sum += exact[i] / plants;
      beyond += pairs[i] > 1.0;
    }
    means.pairs.add(pair_sum);
    means.exact.add(exact_sum);
    means.beyond.add(static_cast<double>(beyond) / plants);
  }
  return means;
}

void record_stands(ExperimentContext& context) {
  const int stands = context.tier() == Tier::full ? 200 : context.tier() == Tier::quick ? 40 : 10;
  PlotPanel losses{.caption = "a) mean loss",
                   .x_label = "areas of all zones over the ground",
                   .y_label = "share of the zone"};
  PlotPanel beyond{.caption = "b) plants that lose more than all",
                   .x_label = "areas of all zones over the ground",
                   .y_label = "share of plants"};
  for (const Division& division : divisions) {
    const bool equal = division.exponent == 0.0;
    const std::string words = equal ? "equal shares" : "all to the largest";
    PlotCurve pairs{words + ", by pairs", {}, {}, PlotStyle::dashed, equal ? 0 : 1};
    PlotCurve exact{words + ", exact", {}, {}, PlotStyle::solid, equal ? 0 : 1};
    PlotCurve share{pairs};
    for (const double cover : covers) {
      context.progress(fmt::format("{}, cover {}", words, cover));
      const StandMeans means = measure(context, cover, division.exponent, stands);
      const ZoneStand stand = random_stand(cover, 0, 0);
      const Expectation expected = equal ? expected_equal(stand) : expected_winner(stand);
      const std::string name = fmt::format("stands/{}/cover-{}", division.name, cover);
      record_mean(context, name + "/pairs", means.pairs, expected.pairs);
      record_mean(context, name + "/exact", means.exact, expected.exact);
      context.record(name + "/excess", means.pairs.mean() - means.exact.mean());
      context.record(name + "/plants_beyond_all", means.beyond.mean());
      for (PlotCurve* curve : {&pairs, &exact, &share}) curve->x.push_back(cover);
      pairs.y.push_back(means.pairs.mean());
      exact.y.push_back(means.exact.mean());
      share.y.push_back(means.beyond.mean());
    }
    losses.curves.insert(losses.curves.end(), {pairs, exact});
    beyond.curves.push_back(share);
  }
  add_plot(context, "pair-sums",
           {.title = "Losses of random stands, exact and by sums over pairs",
            .description = "Mean loss, and share of plants that would lose more than all, over the "
                           "areas of all zones: sums over pairs count ground twice where more than "
                           "two zones meet.",
            .panels = {losses, beyond}});
}

/// Two plants: losses as the exponent grows from equal shares to all for the larger.
void record_family(ExperimentContext& context) {
  ZoneStand two;
  two.add(0, 0, 0.6);
  two.add(1.0, 0, 1.0);
  const double overlap = lens_area(0.6, 1.0, 1.0);
  const auto symmetric = two.losses("symmetric"), asymmetric = two.losses("asymmetric");
  double limits = 0.0, sum_error = 0.0;
  const auto add_limit = [&](double exponent, const std::vector<double>& expected) {
    const auto loss = two.losses("exact_shares", exponent);
    for (std::size_t i = 0; i < 2; ++i) limits = std::max(limits, std::abs(loss[i] - expected[i]));
  };
  add_limit(0.0, symmetric);
  add_limit(winner_takes_all, asymmetric);
  add_limit(1000.0, asymmetric);
  PlotCurve smaller{.name = "smaller plant", .x = {}, .y = {}};
  PlotCurve larger{.name = "larger plant", .x = {}, .y = {}};
  for (int k = -8; k <= 8; ++k) {
    const double exponent = std::pow(2.0, 0.5 * k);
    const auto loss = two.losses("exact_shares", exponent);
    sum_error =
        std::max(sum_error, std::abs(loss[0] * two.area(0) + loss[1] * two.area(1) - overlap));
    smaller.x.push_back(exponent);
    larger.x.push_back(exponent);
    smaller.y.push_back(loss[0]);
    larger.y.push_back(loss[1]);
    if (k % 2 != 0) continue;
    context.record(fmt::format("family/exponent-{}/smaller", exponent), loss[0]);
    context.record(fmt::format("family/exponent-{}/larger", exponent), loss[1]);
  }
  context.record("family/symmetric/smaller", symmetric[0]);
  context.record("family/symmetric/larger", symmetric[1]);
  context.record("family/asymmetric/smaller", asymmetric[0]);
  context.record("family/asymmetric/larger", asymmetric[1]);
  context.record("family/largest_difference_from_limits", limits);
  context.record("family/largest_sum_error", sum_error, "area");
  constexpr double no_line = std::numeric_limits<double>::quiet_NaN();
  const auto limits_of = [&](const char* name, std::size_t i) {
    const double left = smaller.x.front(), right = smaller.x.back();
    return PlotCurve{name,
                     {left, right, right, left, right},
                     {symmetric[i], symmetric[i], no_line, asymmetric[i], asymmetric[i]},
                     PlotStyle::dotted,
                     i};
  };
  add_plot(context, "exponents",
           {.title = "Losses of two plants against the exponent by which they share",
            .description = "Loss of the smaller and of the larger plant over the exponent, between "
                           "the dotted limits of equal shares and of all to the larger.",
            .panels = {{.curves = {smaller, larger, limits_of("limits of the smaller", 0),
                                   limits_of("limits of the larger", 1)},
                        .caption = "radii 0.6 and 1, distance 1",
                        .x_label = "exponent of the area",
                        .y_label = "loss",
                        .log_x = true}}});
}

void run(ExperimentContext& context) {
  record_stands(context);
  record_family(context);
}

}  // namespace

extern const ExperimentDescriptor shared_ground_stands;
constinit const ExperimentDescriptor shared_ground_stands{
    .id = "alsweis/shared-ground-stands",
    .question = "By how much do sums over pairs exceed what the plants of a stand lose?",
    .source = "[Alsweis] eq. 4.2-4.4, 5.1",
    .seconds = {1, 1, 8},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
