// SPDX-License-Identifier: MIT
// The contract of every engine that finds which discs overlap, and by how much.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <span>
#include <string_view>

#include "core/overlap/discs.hpp"

namespace phytobench {

struct OverlapSetup {
  int threads = 1;  ///< results are the same for any number
  /// Gives up with an InputError beyond: all discs at one place would fill any memory.
  std::size_t most_pairs = 100'000'000;
};

struct OverlapWork {
  std::uint64_t candidates = 0;  ///< pairs whose distance was looked at
  std::uint64_t places = 0;  ///< cells, tree nodes or boxes looked up, as the engine counts them
};

/// Gets pairs piece by piece.
using TakePairs = std::function<void(std::span<const OverlapPairs>)>;

class OverlapEngine {
 public:
  virtual ~OverlapEngine() = default;

  /// Overwrites `pairs` with every pair (first < second) for which lens_area() of both radii and
  /// their center_distance() is more than 0, each with exactly that area, once for every image, in
  /// any order that is the same for any number of threads. Discs must be fit (problem_with()). May
  /// keep its memory for the next call.
  virtual OverlapWork find(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                           OverlapPairs& pairs) = 0;

  /// The same pairs in the same order, for those who need each only once: calls `take` in this
  /// thread with some of them after the other, in one or more pieces. Where an engine can, each
  /// call brings few enough to stay in a cache. `scratch` may hold them.
  virtual OverlapWork find_in_parts(const Discs& discs, const Ground& ground,
                                    const OverlapSetup& setup, OverlapPairs& scratch,
                                    const TakePairs& take) {
    const OverlapWork work = find(discs, ground, setup, scratch);
    take(std::span(&scratch, 1));
    return work;
  }
};

/// One constant of this type per file in engines/, one line in overlap_engines.def.
struct OverlapEngineDescriptor {
  std::string_view name;                  ///< that of its file
  std::string_view summary;               ///< one sentence
  std::string_view source;                ///< whom it comes from
  std::string_view library = {};          ///< with version; empty: nobody's
  bool uses_threads = false;              ///< false: runs on one, whatever it is given
  std::string_view missing_package = {};  ///< empty if built, else the CMake target not found
  std::unique_ptr<OverlapEngine> (*create)() = nullptr;

  bool built() const { return create != nullptr; }
};

/// An engine that is one function and keeps nothing.
template <OverlapWork (*function)(const Discs&, const Ground&, const OverlapSetup&, OverlapPairs&)>
std::unique_ptr<OverlapEngine> overlap_engine_from() {
  struct Engine final : OverlapEngine {
    OverlapWork find(const Discs& discs, const Ground& ground, const OverlapSetup& setup,
                     OverlapPairs& pairs) override {
      return function(discs, ground, setup, pairs);
    }
  };
  return std::make_unique<Engine>();
}

}  // namespace phytobench
