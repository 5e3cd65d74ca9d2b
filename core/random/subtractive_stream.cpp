// SPDX-License-Identifier: MIT
#include "core/random/subtractive_stream.hpp"

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::int32_t modulus = 2147483647;     // 2^31 - 1
constexpr std::int32_t start_value = 161803398;  // digits of the golden ratio, after Knuth

/// a - b in wrapping 32-bit arithmetic, a negative result raised by the modulus once. The original
/// runs unchecked, and a negative start (seed above 161803398) really wraps.
std::int32_t raised_difference(std::int32_t a, std::int32_t b) {
  const auto wrapped = static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b);
  const auto difference = static_cast<std::int32_t>(wrapped);
  return difference < 0 ? difference + modulus : difference;
}

}  // namespace

SubtractiveStream::SubtractiveStream(std::uint64_t seed) {
  PHYTOBENCH_EXPECT(seed <= static_cast<std::uint64_t>(modulus));
  // Fill the table in steps of 21, which visits all 55 places.
  std::int32_t current = start_value - static_cast<std::int32_t>(seed);
  std::int32_t next = 1;
  state_[55] = current;
  for (std::size_t i = 1; i < 55; ++i) {
    const std::size_t place = 21 * i % 55;
    state_[place] = next;
    next = raised_difference(current, next);
    current = state_[place];
  }
  // Mix four times.
  for (int round = 0; round < 4; ++round) {
    for (std::size_t i = 1; i < 56; ++i) {
      state_[i] = raised_difference(state_[i], state_[1 + (i + 30) % 55]);
    }
  }
}

double SubtractiveStream::next_unit() {
  first_ = first_ == 55 ? 1 : first_ + 1;
  second_ = second_ == 55 ? 1 : second_ + 1;
  std::int32_t value = state_[first_] - state_[second_];
  if (value == modulus) --value;
  if (value < 0) value += modulus;
  state_[first_] = value;
  return value * (1.0 / modulus);
}

}  // namespace phytobench
