// SPDX-License-Identifier: MIT
#include "core/point_pattern/envelope_tests.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>

#include "core/contract/check.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/point_pattern/special_values.hpp"

namespace phytobench {

namespace {

/// The curves one below the other, the observed one first, and the distances that count.
struct Table {
  std::vector<const std::vector<double>*> curves;
  std::vector<std::size_t> distances;

  double at(std::size_t curve, std::size_t k) const { return (*curves[curve])[k]; }
};

Table table_of(const Curves& curves) {
  Table table;
  table.curves.push_back(&curves.observed);
  for (const auto& curve : curves.simulated) {
    PHYTOBENCH_EXPECT(curve.size() == curves.observed.size());
    table.curves.push_back(&curve);
  }
  for (std::size_t k = 0; k < curves.observed.size(); ++k) {
    const bool known = std::all_of(table.curves.begin(), table.curves.end(),
                                   [k](const auto* curve) { return std::isfinite((*curve)[k]); });
    if (known) table.distances.push_back(k);
  }
  return table;
}

EnvelopeTest test_with_centre(const Table& table) {
  const std::size_t length = table.curves[0]->size();
  EnvelopeTest test;
  test.centre = test.low = test.high = std::vector<double>(length, unknown_value);
  std::vector<double> values(table.curves.size());
  for (const std::size_t k : table.distances) {
    for (std::size_t i = 0; i < values.size(); ++i) values[i] = table.at(i, k);
    // In ascending order, so that not even rounding tells which curve is the observed one; from the
    // lowest, so that equal curves have exactly their own mean.
    std::sort(values.begin(), values.end());
    double sum = 0.0;
    for (const double value : values) sum += value - values[0];
    test.centre[k] = values[0] + sum / static_cast<double>(values.size());
  }
  return test;
}

/// How many curves may be called extreme at this level.
std::size_t allowed_extremes(double level, std::size_t curves) {
  PHYTOBENCH_EXPECT(level > 0.0 && level < 1.0);
  // Levels such as 0.05 have no exact binary value: 0.05 * 20 must allow one.
  const double allowed = level * static_cast<double>(curves) * (1.0 + 1e-12);
  return std::min(static_cast<std::size_t>(allowed), curves - 1);
}

/// Replaces the values of all curves at one distance by two-sided ranks: 1 for the lowest and the
/// highest; equal values share their mean rank.
void add_ranks(const Table& table, std::size_t k, std::vector<std::vector<double>>& ranks) {
  const std::size_t count = table.curves.size();
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return table.at(a, k) < table.at(b, k); });
  for (std::size_t begin = 0, end = 0; begin < count; begin = end) {
    while (end < count && table.at(order[end], k) == table.at(order[begin], k)) ++end;
    const double rank = 0.5 * static_cast<double>(begin + end + 1);
    const double two_sided = std::min(rank, static_cast<double>(count + 1) - rank);
    for (std::size_t i = begin; i < end; ++i) ranks[order[i]].push_back(two_sided);
  }
}

/// For each curve how many are at least as extreme, itself among them; ranks as sorted lists.
std::vector<std::size_t> extremity(const std::vector<std::vector<double>>& ranks) {
  std::vector<std::size_t> order(ranks.size()), extremes(ranks.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(),
            [&](std::size_t a, std::size_t b) { return ranks[a] < ranks[b]; });
  for (std::size_t begin = 0, end = 0; begin < order.size(); begin = end) {
    while (end < order.size() && ranks[order[end]] == ranks[order[begin]]) ++end;
    for (std::size_t i = begin; i < end; ++i) extremes[order[i]] = end;
  }
  return extremes;
}

double share_of(std::size_t count, std::size_t curves) {
  return static_cast<double>(count) / static_cast<double>(curves);
}

}  // namespace

Curves curves_with_simulations(std::vector<double> observed, std::size_t count,
                               const SimulatedCurve& curve, int threads) {
  Curves curves{std::move(observed), std::vector<std::vector<double>>(count)};
  for_tasks(count, threads, [&](std::size_t index) { curves.simulated[index] = curve(index); });
  return curves;
}

EnvelopeTest mad_test(const Curves& curves, double level) {
  const Table table = table_of(curves);
  EnvelopeTest test = test_with_centre(table);
  std::vector<double> deviations(table.curves.size(), 0.0);
  for (std::size_t i = 0; i < deviations.size(); ++i)
    for (const std::size_t k : table.distances)
      deviations[i] = std::max(deviations[i], std::abs(table.at(i, k) - test.centre[k]));

  const double observed = deviations[0];
  const auto extremes = std::count_if(deviations.begin(), deviations.end(),
                                      [observed](double value) { return value >= observed; });
  test.p_value = share_of(static_cast<std::size_t>(extremes), deviations.size());

  // The widest curve that is not one of the allowed extremes sets the width.
  std::vector<double> widest = deviations;
  std::sort(widest.begin(), widest.end(), std::greater<>());
  const double width = widest[allowed_extremes(level, widest.size())];
  for (const std::size_t k : table.distances) {
    test.low[k] = test.centre[k] - width;
    test.high[k] = test.centre[k] + width;
    // Rounding must not leave a curve outside that touches it.
    for (std::size_t i = 0; i < deviations.size(); ++i) {
      if (deviations[i] > width) continue;
      test.low[k] = std::min(test.low[k], table.at(i, k));
      test.high[k] = std::max(test.high[k], table.at(i, k));
    }
  }
  return test;
}

EnvelopeTest extreme_rank_length_test(const Curves& curves, double level) {
  const Table table = table_of(curves);
  EnvelopeTest test = test_with_centre(table);
  std::vector<std::vector<double>> ranks(table.curves.size());
  for (const std::size_t k : table.distances) add_ranks(table, k, ranks);
  for (auto& list : ranks) std::sort(list.begin(), list.end());
  const std::vector<std::size_t> extremes = extremity(ranks);
  test.p_value = share_of(extremes[0], extremes.size());

  // The envelope encloses all curves that are not among the allowed extremes.
  const std::size_t allowed = allowed_extremes(level, extremes.size());
  for (const std::size_t k : table.distances) {
    test.low[k] = std::numeric_limits<double>::infinity();
    test.high[k] = -test.low[k];
    for (std::size_t i = 0; i < extremes.size(); ++i) {
      if (extremes[i] <= allowed) continue;
      test.low[k] = std::min(test.low[k], table.at(i, k));
      test.high[k] = std::max(test.high[k], table.at(i, k));
    }
  }
  return test;
}

}  // namespace phytobench
