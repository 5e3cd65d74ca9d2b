// SPDX-License-Identifier: MIT
#include "benchmarks/shadow/shadow_judge.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"
#include "core/terrain/shadow/ray_pattern.hpp"
#include "core/terrain/shadow/shadow_registry.hpp"

namespace phytobench {

namespace {

bool is_lit_by_definition(const HeightField& field, const RayPattern& pattern, int column,
                          int row) {
  const double* from = field.row(row) + column;
  const auto on_map = pattern.crossings().first(pattern.on_map(column, row));
  return std::none_of(on_map.begin(), on_map.end(), [&](const RayCrossing& crossing) {
    return height_at(crossing, from) > *from + crossing.rise;
  });
}

bool has_shadows(const SunDirection& sun) {
  return sun.up >= 0.0 && !in_zenith(sun);
}

}  // namespace

ShadowJudge::ShadowJudge(const ShadowWorkload& workload, std::uint64_t seed, int threads)
    : workload_(workload) {
  const bool is_literal = workload.field.size() <= most_vertices_literally;
  name_ = is_literal
              ? "exact traversal of every ray"
              : fmt::format("max_pyramid, itself compared with {} rays of a sample", sampled_rays);
  shadow_engine_named(is_literal ? "exact_traversal" : "max_pyramid")
      .create()
      ->cast(workload.field, workload.suns, {.threads = threads}, lit_);
  PHYTOBENCH_ENSURE(wrong_in_sample(workload, lit_, sampled_rays, seed) == 0);
}

std::string ShadowJudge::disagreement(const LitMaps& found) const {
  if (found.columns() != lit_.columns() || found.rows() != lit_.rows() ||
      found.positions() != lit_.positions())
    return fmt::format("gives {} maps of {} x {} instead of {} of {} x {}", found.positions(),
                       found.columns(), found.rows(), lit_.positions(), lit_.columns(),
                       lit_.rows());
  const std::uint64_t differing = differing_bits(found, lit_);
  if (differing == 0) return {};
  for (std::size_t position = 0; position < lit_.positions(); ++position)
    for (int row = 0; row < lit_.rows(); ++row)
      for (int column = 0; column < lit_.columns(); ++column)
        if (const bool is_lit = found.is_lit(position, column, row);
            is_lit != lit_.is_lit(position, column, row))
          return fmt::format("{} of {} vertex-hours; in hour {} column {}, row {} is {}", differing,
                             workload_.vertex_hours(), position + 1, column, row,
                             is_lit ? "lit, but hidden" : "dark, but in the sun");
  return fmt::format("{} bits beyond the last column are set", differing);
}

double ShadowJudge::wrong_share(const LitMaps& found) const {
  return static_cast<double>(differing_bits(found, lit_)) /
         static_cast<double>(workload_.vertex_hours());
}

std::uint64_t wrong_in_sample(const ShadowWorkload& workload, const LitMaps& lit, std::size_t rays,
                              std::uint64_t seed) {
  std::uint64_t wrong = 0;
  const std::size_t for_each_sun = rays / std::max<std::size_t>(workload.suns.size(), 1) + 1;
  for (std::size_t s = 0; s < workload.suns.size(); ++s) {
    if (!has_shadows(workload.suns[s])) continue;
    const RayPattern pattern(workload.field, workload.suns[s]);
    CounterStream stream(seed, 500 + s);
    for (std::size_t k = 0; k < for_each_sun; ++k) {
      const int column = static_cast<int>(stream.next_unit() * workload.field.columns());
      const int row = static_cast<int>(stream.next_unit() * workload.field.rows());
      wrong +=
          is_lit_by_definition(workload.field, pattern, column, row) != lit.is_lit(s, column, row);
    }
  }
  return wrong;
}

}  // namespace phytobench
