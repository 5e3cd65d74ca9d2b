// SPDX-License-Identifier: MIT
#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/growth_counter.hpp"

namespace phytobench {

std::optional<GrowthForecast> growth_forecast(const LSystem& system, int steps) {
  PHYTOBENCH_EXPECT(steps >= 0);
  if (!kind_of(system).has_fixed_successors()) return std::nullopt;
  constexpr std::size_t most_numbers = std::size_t{1} << 27;  // a gigabyte
  if (static_cast<std::size_t>(steps) >= most_numbers / system.symbols.size())
    throw InputError(
        fmt::format("{}: a forecast over {} steps does not fit into memory (take "
                    "fewer steps)",
                    system.source, steps));
  GrowthForecast forecast;
  GrowthCounter counter(system);
  for (int step = 0; step <= steps; ++step) {
    if (step > 0) counter.advance();
    GrowthForecast::Step now;
    now.modules = counter.modules();
    now.parameters = counter.parameters();
    now.symbols = counter.symbols();
    now.saturated = counter.saturated();
    forecast.steps.push_back(std::move(now));
  }
  return forecast;
}

}  // namespace phytobench
