// SPDX-License-Identifier: MIT
// The contract of every engine that finds which vertices of a terrain are lit.
#pragma once

#include <cstdint>
#include <memory>
#include <numeric>
#include <span>
#include <string_view>
#include <vector>

#include "core/parallel/for_blocks.hpp"
#include "core/terrain/height_field.hpp"
#include "core/terrain/shadow/lit_maps.hpp"
#include "core/terrain/sun/sun_direction.hpp"

namespace phytobench {

struct ShadowSetup {
  int threads = 1;  ///< results are the same for any number
};

/// The same for any number of threads.
struct ShadowWork {
  std::uint64_t samples = 0;  ///< heights of the terrain that a ray, or a line, was compared with
  std::uint64_t blocks = 0;   ///< summaries of many heights that were looked at
  std::uint64_t rays = 0;     ///< rays that were followed one by one
  std::uint64_t stuck = 0;    ///< rays that came to no end, or divided by zero, and were given up

  friend ShadowWork operator+(const ShadowWork& a, const ShadowWork& b) {
    return {a.samples + b.samples, a.blocks + b.blocks, a.rays + b.rays, a.stuck + b.stuck};
  }
  friend bool operator==(const ShadowWork&, const ShadowWork&) = default;
};

class ShadowEngine {
 public:
  virtual ~ShadowEngine() = default;
  /// Overwrites `lit`, one map for each position of the sun. With the sun in the zenith all is lit,
  /// below the horizon all is dark; at the horizon a vertex is lit that nothing higher hides.
  /// Vertices without data cast no shadow and count as lit where the sun is up. May keep its memory
  /// for the next call.
  virtual ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                          const ShadowSetup& setup, LitMaps& lit) = 0;
};

/// One constant of this type per file in engines/, one line in shadow_engines.def.
struct ShadowEngineDescriptor {
  std::string_view name;     ///< that of its file
  std::string_view summary;  ///< one sentence
  std::string_view source;   ///< whom it comes from
  /// Whether its maps are those of exact_traversal, bit by bit. Otherwise it approximates them.
  bool exact = true;
  std::string_view missing_package = {};  ///< empty if built, else the CMake target not found
  std::unique_ptr<ShadowEngine> (*create)() = nullptr;

  bool built() const { return create != nullptr; }
};

/// Calls cast(sun, position), which adds to a map that is dark and says what it took, for each
/// position of the sun where there is something to find: at or above the horizon, outside the
/// zenith. On up to `threads` threads, each position on one.
template <class Cast>
ShadowWork cast_each(const HeightField& field, std::span<const SunDirection> suns, int threads,
                     LitMaps& lit, const Cast& cast) {
  lit.reset(field.columns(), field.rows(), suns.size());
  std::vector<ShadowWork> work(suns.size());
  for_tasks(suns.size(), threads, [&](std::size_t position) {
    if (in_zenith(suns[position]))
      lit.light_all(position);
    else if (suns[position].up >= 0.0)
      work[position] = cast(suns[position], position);
  });
  return std::accumulate(work.begin(), work.end(), ShadowWork{});
}

/// An engine that is one such function and keeps nothing.
template <ShadowWork (*function)(const HeightField&, const SunDirection&, const ShadowSetup&,
                                 std::size_t position, LitMaps&)>
std::unique_ptr<ShadowEngine> shadow_engine_from() {
  struct Engine final : ShadowEngine {
    ShadowWork cast(const HeightField& field, std::span<const SunDirection> suns,
                    const ShadowSetup& setup, LitMaps& lit) override {
      return cast_each(field, suns, 1, lit, [&](const SunDirection& sun, std::size_t position) {
        return function(field, sun, setup, position, lit);
      });
    }
  };
  return std::make_unique<Engine>();
}

}  // namespace phytobench
