// SPDX-License-Identifier: MIT
#include "core/random/counter_stream.hpp"

#include <Random123/philox.h>

#include <numeric>
#include <utility>

namespace phytobench {

double random_unit(std::uint64_t seed, std::uint64_t stream, std::uint64_t index) {
  using Philox = r123::Philox4x32;
  const auto low = [](std::uint64_t word) { return static_cast<std::uint32_t>(word); };
  const auto high = [](std::uint64_t word) { return static_cast<std::uint32_t>(word >> 32); };
  const Philox::ctr_type counter{{low(index), high(index), low(stream), high(stream)}};
  const Philox::key_type key{{low(seed), high(seed)}};
  const Philox::ctr_type block = Philox()(counter, key);
  // 53 bits from two words: a single 32-bit word would leave visible gaps.
  const std::uint64_t bits = (std::uint64_t{block[0]} << 32 | block[1]) >> 11;
  return static_cast<double>(bits) * 0x1p-53;
}

std::vector<std::size_t> random_order(std::size_t count, UnitStream& stream) {
  std::vector<std::size_t> order(count);
  std::iota(order.begin(), order.end(), std::size_t{0});
  for (std::size_t left = count; left > 1; --left) {
    const auto pick = static_cast<std::size_t>(stream.next_unit() * static_cast<double>(left));
    std::swap(order[left - 1], order[pick]);
  }
  return order;
}

}  // namespace phytobench
