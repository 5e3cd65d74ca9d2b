// SPDX-License-Identifier: MIT
// The horizon of every vertex once for each heading, whatever the number of hours: a vertex is lit
// when the sun is not below its horizon.
#include <cmath>
#include <map>
#include <utility>
#include <vector>

#include "core/terrain/shadow/horizon.hpp"
#include "core/terrain/shadow/shadow_engine.hpp"

namespace phytobench::shadow_engines {

namespace {

using Positions = std::vector<std::size_t>;

/// Positions of the sun that share a heading.
std::vector<Positions> by_heading(std::span<const SunDirection> suns) {
  std::map<std::pair<double, double>, Positions> headings;
  for (std::size_t i = 0; i < suns.size(); ++i) {
    const double horizontal = std::hypot(suns[i].east, suns[i].south);
    if (horizontal == 0.0 || suns[i].up < 0.0) continue;
    headings[{suns[i].east / horizontal, suns[i].south / horizontal}].push_back(i);
  }
  std::vector<Positions> result;
  for (auto& [heading, positions] : headings) result.push_back(std::move(positions));
  return result;
}

void light(const std::vector<double>& horizon, const SunDirection& sun, std::size_t position,
           LitMaps& lit) {
  const double tangent = sun.up / std::hypot(sun.east, sun.south);
  const auto columns = static_cast<std::size_t>(lit.columns());
  for (int row = 0; row < lit.rows(); ++row) {
    const double* in_row = horizon.data() + static_cast<std::size_t>(row) * columns;
    std::uint64_t* words = lit.row(position, row);
    for (std::size_t column = 0; column < columns; ++column)
      words[column / 64] |= std::uint64_t{!(in_row[column] > tangent)} << (column % 64);
  }
}

class Engine final : public ShadowEngine {
 public:
  ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                  const ShadowSetup& setup, LitMaps& lit) override {
    lit.reset(field.columns(), field.rows(), suns.size());
    for (std::size_t i = 0; i < suns.size(); ++i)
      if (in_zenith(suns[i])) lit.light_all(i);
    const std::vector<Positions> headings = by_heading(suns);
    for_tasks(headings.size(), setup.threads, [&](std::size_t h) {
      const SunDirection& any = suns[headings[h].front()];
      const std::vector<double> horizon = horizon_tangents(field, {any.east, any.south});
      for (const std::size_t position : headings[h]) light(horizon, suns[position], position, lit);
    });
    return {.samples = headings.size() * field.size()};
  }
};

std::unique_ptr<ShadowEngine> create() {
  return std::make_unique<Engine>();
}

}  // namespace

extern const ShadowEngineDescriptor horizon_hull;
constinit const ShadowEngineDescriptor horizon_hull{
    .name = "horizon_hull",
    .summary = "Finds every vertex's horizon by the upper hulls of lines, once for each heading.",
    .source = "Timonen and Westerholm 2010",
    .exact = false,
    .create = create,
};

}  // namespace phytobench::shadow_engines
