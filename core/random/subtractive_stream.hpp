// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>

#include "core/random/unit_stream.hpp"

namespace phytobench {

/// Knuth's subtractive generator (The Art of Computer Programming 2, sec. 3.2.2) as the managed run
/// time of the 2019 thesis has it: the second index starts at 21 instead of 31. Published node
/// counts depend on its exact numbers; with seed 0 the first two are 0.726243269967960 and
/// 0.817325359590969.
class SubtractiveStream final : public UnitStream {
 public:
  /// Seeds up to 2^31 - 1, as the original takes a 32-bit integer; expects that range.
  explicit SubtractiveStream(std::uint64_t seed);
  double next_unit() override;

 private:
  std::array<std::int32_t, 56> state_{};  // index 0 is unused, as in Knuth's text
  std::size_t first_ = 0;
  std::size_t second_ = 21;
};

}  // namespace phytobench
