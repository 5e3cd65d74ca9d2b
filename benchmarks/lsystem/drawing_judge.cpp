// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/drawing_judge.hpp"

#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "benchmarks/lsystem/literal_turtle.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

bool is_whole(double number) {
  return std::floor(number) == number;
}

/// What doubles may do to a coordinate. Each move rounds it, to half a unit in the last place of at
/// most `extent`, and goes a step in a direction that is off by a few units; where turns round,
/// that grows with their number. Degrees that are added up round if they have many digits.
double rounding_of(const LSystem& system, const LiteralDrawer& turtle) {
  const TurtleSettings& settings = system.turtle;
  const double eps = std::numeric_limits<double>::epsilon();
  constexpr double short_fraction = 1024.0;
  const bool exact_sums = is_whole(settings.step * short_fraction);
  if (is_whole(settings.angle_deg / 90.0) && exact_sums) return 0.0;
  const bool exact_headings = turtle.planar() && is_whole(settings.angle_deg * short_fraction);
  const double turns = static_cast<double>(turtle.most_turns());
  const double direction =
      4.0 * eps + (exact_headings ? 0.0 : 2.0 * std::numbers::pi * eps * turns);
  return static_cast<double>(turtle.most_moves()) *
         (eps * static_cast<double>(turtle.extent()) + settings.step * direction);
}

bool is_near(const DrawingDigest::Ends& found, const DrawingDigest::Ends& right,
             long double bound) {
  for (std::size_t k = 0; k < right.size(); ++k)
    if (!(std::abs(found[k] - right[k]) <= bound)) return false;  // not a number is not near
  return true;
}

std::string text_of(const DrawingDigest::Ends& e) {
  const auto number = [&](std::size_t k) { return static_cast<double>(e[k]); };
  return fmt::format("({:.9g}, {:.9g}, {:.9g}) to ({:.9g}, {:.9g}, {:.9g})", number(0), number(1),
                     number(2), number(3), number(4), number(5));
}

}  // namespace

DrawingJudge::DrawingJudge(const LSystemWorkload& workload) : workload_(workload) {
  LiteralDrawer turtle(workload.system);
  turtle.draw(workload.steps, [&](const LiteralDrawer::Vector& a, const LiteralDrawer::Vector& b) {
    right_.add({a[0], a[1], a[2], b[0], b[1], b[2]});
  });
  // The two know nothing of each other.
  PHYTOBENCH_ENSURE(right_.count() == workload.segments);
  bound_ = rounding_of(workload.system, turtle);
  planar_ = turtle.planar();
}

std::string DrawingJudge::disagreement(const DrawingDigest& found) const {
  if (found.count() != right_.count())
    return fmt::format("{} segments instead of {}", found.count(), right_.count());
  for (std::size_t i = 0; i < right_.first().size(); ++i)
    if (!is_near(found.first()[i], right_.first()[i], bound_))
      return fmt::format("segment {} goes from {} instead of {}", i, text_of(found.first()[i]),
                         text_of(right_.first()[i]));
  for (std::size_t i = 0; i < right_.last().size(); ++i)
    if (!is_near(found.last()[i], right_.last()[i], bound_))
      return fmt::format("one of the last segments goes from {} instead of {}",
                         text_of(found.last()[i]), text_of(right_.last()[i]));
  // Of each sum: as many terms, each off by the bound times its weight at most.
  const long double bound_of_sums =
      static_cast<long double>(bound_) * DrawingDigest::chunk_segments * DrawingDigest::most_weight;
  for (std::size_t c = 0; c < right_.sums().size(); ++c)
    if (!is_near(found.sums()[c], right_.sums()[c], bound_of_sums))
      return fmt::format("segments from {} on lie elsewhere",
                         c * std::size_t{DrawingDigest::chunk_segments});
  return "";
}

}  // namespace phytobench
