// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <memory>
#include <string_view>

namespace phytobench {

/// A stream of numbers in [0, 1). Samplers take one of these and nothing else, so the same sampler
/// runs on the suite's counter-based numbers and on the generator of the 2019 program.
class UnitStream {
 public:
  virtual ~UnitStream() = default;
  virtual double next_unit() = 0;

  /// Uniform in [low, high); high - low must be finite.
  double next_between(double low, double high) { return low + (high - low) * next_unit(); }
};

enum class StreamKind {
  counter,  ///< Philox 4x32-10, the suite's own: a pure function of (seed, stream, running index)
  subtractive,  ///< the generator of the 2019 thesis' run time; needed to hit published counts
                ///< exactly
};

std::string_view name_of(StreamKind kind);

/// A fresh stream from its start. `stream` separates uses of one seed; the subtractive generator
/// knows no streams, because the 2019 program restarts it from the seed for each use.
std::unique_ptr<UnitStream> make_stream(StreamKind kind, std::uint64_t seed, std::uint64_t stream);

}  // namespace phytobench
