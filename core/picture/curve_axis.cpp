// SPDX-License-Identifier: MIT
#include "core/picture/curve_axis.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// Part of a logarithmic axis that one label needs for itself: some five letters below a plot.
constexpr double room_of_a_label = 0.12;

/// digit * 10^power.
struct Step {
  int digit;
  int power;
  double value() const { return digit * std::pow(10.0, power); }
};

/// Of 1, 2, 5, 10, ... the one whose ratio to an even division is nearest to 1.
Step step_of(double length, int wanted) {
  const double even = length / (wanted - 1);
  const int power = static_cast<int>(std::floor(std::log10(even)));
  const double ratio = even / std::pow(10.0, power);
  if (ratio * ratio >= 50.0) return {1, power + 1};
  return {ratio * ratio >= 10.0 ? 5 : ratio * ratio >= 2.0 ? 2 : 1, power};
}

/// With the digits that tell a tick from its neighbours: 0.25, 50, 2e+07.
std::string tick_label(double value, int power) {
  if (value == 0.0) return "0";
  const double size = std::abs(value);
  if (size >= 1e6 || size < 1e-3) return fmt::format("{:.4g}", value);
  return fmt::format("{:.{}f}", value, std::max(0, -power));
}

}  // namespace

CurveAxis::CurveAxis(AxisRange range, AxisScale scale) : range_(range), scale_(scale) {
  PHYTOBENCH_EXPECT(std::isfinite(range.high - range.low) && range.low < range.high);
  PHYTOBENCH_EXPECT(scale == AxisScale::linear || range.low > 0.0);
}

double CurveAxis::position(double value) const {
  if (scale_ == AxisScale::logarithmic)
    return std::log(value / range_.low) / std::log(range_.high / range_.low);
  return (value - range_.low) / (range_.high - range_.low);
}

std::vector<AxisTick> CurveAxis::ticks(int wanted) const {
  PHYTOBENCH_EXPECT(wanted >= 2);
  return scale_ == AxisScale::linear ? linear_ticks(wanted) : logarithmic_ticks(wanted);
}

std::vector<AxisTick> CurveAxis::linear_ticks(int wanted) const {
  const Step step = step_of(range_.high - range_.low, wanted);
  // A tick at an end must not be lost to rounding.
  const double slack = 1e-9;
  const double first = std::ceil(range_.low / step.value() - slack);
  const double last = std::floor(range_.high / step.value() + slack);
  std::vector<AxisTick> all;
  for (double i = first; i <= last; ++i) {
    const double value = i * step.value();
    all.push_back({std::clamp(value, range_.low, range_.high), tick_label(value, step.power)});
  }
  return all;
}

std::vector<AxisTick> CurveAxis::with_room(std::vector<AxisTick> ticks) const {
  const auto is_power = [](const AxisTick& tick) {
    const double power = std::log10(tick.value);
    return std::abs(power - std::round(power)) < 1e-9;
  };
  std::vector<double> taken;
  // Powers of ten have the first choice.
  for (const bool powers : {true, false})
    for (AxisTick& tick : ticks) {
      if (tick.label.empty() || is_power(tick) != powers) continue;
      const double own = position(tick.value);
      const bool is_free = std::all_of(taken.begin(), taken.end(), [&](double other) {
        return std::abs(own - other) >= room_of_a_label;
      });
      if (is_free)
        taken.push_back(own);
      else
        tick.label.clear();
    }
  return ticks;
}

std::vector<AxisTick> CurveAxis::logarithmic_ticks(int wanted) const {
  const double decades = std::log10(range_.high / range_.low);
  if (decades < 1.0) return with_room(linear_ticks(wanted));
  std::vector<AxisTick> all;
  for (int power = static_cast<int>(std::floor(std::log10(range_.low))) - 1;
       power <= std::log10(range_.high) + 1.0; ++power)
    for (int digit = 1; digit <= (decades <= 8.0 ? 9 : 1); ++digit) {
      const double value = Step{digit, power}.value();
      if (value < range_.low || value > range_.high) continue;
      const bool named = digit == 1 || (decades < 3.0 && (digit == 2 || digit == 5));
      all.push_back({value, named ? tick_label(value, power) : ""});
    }
  return decades < 3.0 ? with_room(std::move(all)) : all;
}

AxisRange range_of(const std::vector<double>& values, AxisScale scale) {
  PHYTOBENCH_EXPECT(!values.empty());
  const auto [lowest, highest] = std::minmax_element(values.begin(), values.end());
  if (*lowest < *highest) return {*lowest, *highest};
  if (scale == AxisScale::logarithmic) return {*lowest / 2.0, *highest * 2.0};
  const double room = *lowest == 0.0 ? 1.0 : 0.5 * std::abs(*lowest);
  return {*lowest - room, *highest + room};
}

AxisRange rounded_outwards(AxisRange range, AxisScale scale, int wanted) {
  if (scale == AxisScale::logarithmic) {
    const double room = std::pow(range.high / range.low, 0.05);
    return {range.low / room, range.high * room};
  }
  const double step = step_of(range.high - range.low, wanted).value();
  const double slack = 1e-9;
  return {std::floor(range.low / step + slack) * step, std::ceil(range.high / step - slack) * step};
}

}  // namespace phytobench
