// SPDX-License-Identifier: MIT
#include "core/overlap/layered_grid/size_classes.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <numbers>

namespace phytobench {

namespace {

/// What it takes to begin a row of cells, in candidates looked at. Measured roughly; whatever it
/// is, the pairs found are the same.
constexpr double row_cost = 12.0;

/// So many classes are compared in all ways; more are merged before that.
constexpr std::size_t most_classes = 32;

struct Octave {
  std::uint32_t count = 0;
  double largest = 0.0;
};

/// In `ways` parts, so that neighbours in the list do not wait for each other.
std::vector<SizeClass> octaves_of(std::span<const double> radii) {
  constexpr std::size_t ways = 4;
  std::vector<std::array<Octave, ways>> octaves(exponent_count);
  for (std::size_t i = 0; i < radii.size(); ++i) {
    Octave& part = octaves[exponent_of(radii[i])][i % ways];
    ++part.count;
    part.largest = std::max(part.largest, radii[i]);
  }
  std::vector<SizeClass> classes;
  for (std::size_t e = exponent_count; e-- > 0;) {
    SizeClass c{e, e};
    for (const Octave& part : octaves[e]) {
      c.count += part.count;
      c.largest = std::max(c.largest, part.largest);
    }
    if (c.largest > 0.0) classes.push_back(c);
  }
  return classes;
}

double cell_edge(const SizeClass& c, double area) {
  return std::max(2.0 * c.largest, std::sqrt(area / static_cast<double>(c.count)));
}

/// What the discs of `large` find in the grid of `small`, which may be their own.
double search_cost(const SizeClass& large, const SizeClass& small, double area) {
  const double edge = cell_edge(small, area);
  const double reach = large.largest + small.largest;
  const double per_area = static_cast<double>(small.count) / area;
  double rows = 2.0 * reach / edge + 1.0;
  double searched = std::numbers::pi * reach * reach + edge * (2.0 * reach + edge);
  if (&large == &small) {  // half of nine cells
    rows = 2.0;
    searched = 4.5 * edge * edge;
  }
  const double everything = static_cast<double>(small.count);
  return static_cast<double>(large.count) * (row_cost * std::min(rows, std::sqrt(everything)) +
                                             std::min(everything, per_area * searched));
}

double cost_of(const std::vector<SizeClass>& classes, double area) {
  double cost = 0.0;
  for (std::size_t a = 0; a < classes.size(); ++a)
    for (std::size_t b = a; b < classes.size(); ++b)
      cost += search_cost(classes[a], classes[b], area);
  return cost;
}

/// With class `a` and the next smaller one in one.
std::vector<SizeClass> merged(std::vector<SizeClass> classes, std::size_t a) {
  SizeClass& large = classes[a];
  large.first_exponent = classes[a + 1].first_exponent;
  large.count += classes[a + 1].count;
  classes.erase(classes.begin() + static_cast<std::ptrdiff_t>(a) + 1);
  return classes;
}

std::size_t fewest_discs(const std::vector<SizeClass>& classes) {
  std::size_t best = 0;
  const auto discs = [&](std::size_t a) { return classes[a].count + classes[a + 1].count; };
  for (std::size_t a = 1; a + 1 < classes.size(); ++a)
    if (discs(a) < discs(best)) best = a;
  return best;
}

}  // namespace

std::size_t exponent_of(double radius) {
  return static_cast<std::size_t>(std::bit_cast<std::uint64_t>(radius) >> 52);
}

std::vector<SizeClass> size_classes(std::span<const double> radii, double area) {
  std::vector<SizeClass> classes = octaves_of(radii);
  while (classes.size() > most_classes) classes = merged(std::move(classes), fewest_discs(classes));
  if (!(area > 0.0)) return classes;
  // Merge what saves most, as long as something does.
  for (double cost = cost_of(classes, area);;) {
    std::vector<SizeClass> best;
    for (std::size_t a = 0; a + 1 < classes.size(); ++a) {
      std::vector<SizeClass> tried = merged(classes, a);
      const double tried_cost = cost_of(tried, area);
      if (tried_cost >= cost) continue;
      cost = tried_cost;
      best = std::move(tried);
    }
    if (best.empty()) return classes;
    classes = std::move(best);
  }
}

}  // namespace phytobench
