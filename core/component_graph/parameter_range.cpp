// SPDX-License-Identifier: MIT
#include "core/component_graph/parameter_range.hpp"

#include <algorithm>

#include "core/contract/check.hpp"
#include "core/lsystem/expression_parser.hpp"

namespace phytobench {

namespace {

double between(double from, double to, double share) {
  return share == 1.0 ? to : from + share * (to - from);
}

}  // namespace

double NumberSpan::at(const SiblingNumber& number) const {
  PHYTOBENCH_EXPECT(number.i >= 1 && number.i <= number.n);
  if (number.n == 1) return first;
  if (number.i == number.n) return last;
  return first + (number.i - 1.0) * (last - first) / (number.n - 1.0);
}

ParameterRange ParameterRange::of(double value) {
  ParameterRange range;
  range.frames.push_back({.time = 0.0, .value = {value, value}});
  return range;
}

NumberSpan ParameterRange::at_time(double time) const {
  PHYTOBENCH_EXPECT(!frames.empty());
  const auto after =
      std::upper_bound(frames.begin(), frames.end(), time,
                       [](double t, const KeyFrame& frame) { return t < frame.time; });
  if (after == frames.begin()) return frames.front().value;
  if (after == frames.end()) return frames.back().value;
  const KeyFrame& before = *(after - 1);
  const double share = (time - before.time) / (after->time - before.time);
  return {between(before.value.first, after->value.first, share),
          between(before.value.last, after->value.last, share)};
}

double ParameterRange::resolved(const InstancePlace& place) const {
  const double value = at_time(place.time).at(place.number);
  if (!function) return value;
  const double parameters[] = {value, static_cast<double>(place.number.i),
                               static_cast<double>(place.number.n),
                               static_cast<double>(place.depth), place.time};
  return function->evaluate(
      parameters,
      {.seed = place.seed, .stream = place.identity, .index = random_stream * most_random_calls});
}

bool ParameterRange::varies() const {
  const bool spans = std::any_of(frames.begin(), frames.end(), [](const KeyFrame& frame) {
    return frame.value.first != frame.value.last;
  });
  if (!function) return spans;
  using Operation = Expression::Operation;
  const auto& program = function->program();
  constexpr std::uint16_t of_value = 0, of_time = 4;
  return std::any_of(program.begin(), program.end(), [&](const Expression::Instruction& step) {
    if (step.operation == Operation::random) return true;
    if (step.operation != Operation::parameter) return false;
    return step.index == of_value ? spans : step.index != of_time;
  });
}

}  // namespace phytobench
