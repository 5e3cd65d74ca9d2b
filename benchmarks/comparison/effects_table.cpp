// SPDX-License-Identifier: MIT
#include "benchmarks/comparison/effects_table.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "benchmarks/comparison/plain_text.hpp"

namespace phytobench {

namespace {

constexpr int half_width = 12;  // characters of the strip on each side of its centre

/// Half the length of the axis, of log ratios: all intervals are on it, but for those that go
/// beyond a factor of two, and never less than twice the tolerance.
double axis_reach(const ComparisonReport& report) {
  const double least = 2.0 * std::log1p(report.verdict_settings.tolerance);
  double reach = least;
  for (const ConcludedBenchmark& benchmark : report.concluded)
    if (benchmark.ratio)
      for (const double end : {benchmark.ratio->low, benchmark.ratio->high})
        if (end > 0.0) reach = std::max(reach, std::abs(std::log(end)));
  return std::min(reach, std::max(std::log(2.0), least));
}

/// Place of a log ratio in the strip; may lie beyond its ends.
int place(double log_ratio, double reach) {
  const double exact = half_width * log_ratio / reach;
  return half_width + static_cast<int>(std::lround(std::clamp(exact, -1e6, 1e6)));
}

std::string strip(const ConcludedBenchmark& benchmark, double tolerance, double reach) {
  std::string text(2 * half_width + 1, ' ');
  const auto put = [&](int at, char c) {
    if (0 <= at && at <= 2 * half_width) text[static_cast<std::size_t>(at)] = c;
  };
  put(place(std::log1p(tolerance), reach), '.');
  put(place(-std::log1p(tolerance), reach), '.');
  put(half_width, ':');
  if (!benchmark.ratio || !(benchmark.ratio->low > 0.0)) return text;
  const int low = place(std::log(benchmark.ratio->low), reach);
  const int high = place(std::log(benchmark.ratio->high), reach);
  for (int at = std::max(low, 0); at <= std::min(high, 2 * half_width); ++at) put(at, '-');
  put(place(std::log(benchmark.ratio->value), reach), 'o');
  if (low < 0) put(0, '<');
  if (high > 2 * half_width) put(2 * half_width, '>');
  return text;
}

std::string row(const ConcludedBenchmark& benchmark, double tolerance, double reach) {
  const std::string name = one_line(benchmark.name);
  if (!benchmark.ratio)
    return fmt::format("{:<16} {:>7} {:>16} {:>8}  [{}]  {}\n", name_of(benchmark.verdict), "-",
                       "-", "-", strip(benchmark, tolerance, reach), name);
  const std::string interval =
      fmt::format("{:.3f} to {:.3f}", benchmark.ratio->low, benchmark.ratio->high);
  return fmt::format("{:<16} {:>7.3f} {:>16} {:>6.1f} %  [{}]  {}\n", name_of(benchmark.verdict),
                     benchmark.ratio->value, interval, 100.0 * benchmark.noise_floor,
                     strip(benchmark, tolerance, reach), name);
}

}  // namespace

EffectsTable effects_table(const ComparisonReport& report) {
  const double reach = axis_reach(report);
  const std::string ends =
      fmt::format("{:<{}}1{:>{}}", fmt::format("{:.2f}", std::exp(-reach)), half_width,
                  fmt::format("{:.2f}", std::exp(reach)), half_width);
  EffectsTable table{.heading = fmt::format("{:<16} {:>7} {:>16} {:>8}   {}   {}\n", "verdict",
                                            "ratio", "95 % interval", "noise", ends, "benchmark"),
                     .rows = {}};
  for (const ConcludedBenchmark* benchmark : by_weight(report))
    table.rows.push_back(row(*benchmark, report.verdict_settings.tolerance, reach));
  return table;
}

}  // namespace phytobench
