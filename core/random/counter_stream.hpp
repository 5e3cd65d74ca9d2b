// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/random/unit_stream.hpp"

namespace phytobench {

/// The random number at (seed, stream, index), in [0, 1) with 53 random bits. A pure function: the
/// same for any thread count, order or platform (Philox 4x32-10, Salmon et al. 2011, through
/// Random123).
double random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t index);

/// random_unit() at index first_index (0 unless said), and the indices that follow.
class CounterStream final : public UnitStream {
 public:
  CounterStream(std::uint64_t seed, std::uint64_t stream, std::uint64_t first_index = 0)
      : seed_(seed), stream_(stream), index_(first_index) {}
  double next_unit() override { return random_unit(seed_, stream_, index_++); }

 private:
  std::uint64_t seed_;
  std::uint64_t stream_;
  std::uint64_t index_;
};

/// A uniformly random order of 0 ... count-1 (Fisher-Yates).
std::vector<std::size_t> random_order(std::size_t count, UnitStream& stream);

}  // namespace phytobench
