// SPDX-License-Identifier: MIT
// Terrains to try [Lesser2019] on: value noise whose numbers are those of Python's
// random.seed(seed), so that a few lines of Python find the same counts. Shares no code with core/.
#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

#include "reference/oracles/lesser2019_terrain.hpp"

namespace phytobench::oracles::lesser2019 {

// random.random() of Python: the Mersenne twister, set up by an array of one number.
class PythonRandom {
 public:
  explicit PythonRandom(std::uint32_t seed) {
    set_up(19650218u);
    std::uint32_t i = 1;
    for (int k = 0; k < n; ++k, next(i))
      state_[i] = (state_[i] ^ (mixed(i) * 1664525u)) + seed;  // and 0, the place in the array
    for (int k = 0; k < n - 1; ++k, next(i)) state_[i] = (state_[i] ^ (mixed(i) * 1566083941u)) - i;
    state_[0] = 0x80000000u;
  }
  double random() {
    const std::uint32_t a = bits() >> 5, b = bits() >> 6;
    return (a * 67108864.0 + b) / 9007199254740992.0;
  }

 private:
  static constexpr int n = 624, m = 397;

  void set_up(std::uint32_t seed) {
    state_[0] = seed;
    for (std::uint32_t i = 1; i < n; ++i) state_[i] = 1812433253u * mixed(i) + i;
  }
  std::uint32_t mixed(std::uint32_t i) const { return state_[i - 1] ^ (state_[i - 1] >> 30); }
  void next(std::uint32_t& i) {
    if (++i < n) return;
    state_[0] = state_[n - 1];
    i = 1;
  }
  std::uint32_t bits() {
    if (at_ == n) {
      for (std::size_t k = 0; k < n; ++k) {
        const std::uint32_t y = (state_[k] & 0x80000000u) | (state_[(k + 1) % n] & 0x7fffffffu);
        state_[k] = state_[(k + m) % n] ^ (y >> 1) ^ ((y & 1u) != 0 ? 0x9908b0dfu : 0u);
      }
      at_ = 0;
    }
    std::uint32_t y = state_[at_++];
    y ^= y >> 11;
    y ^= (y << 7) & 0x9d2c5680u;
    y ^= (y << 15) & 0xefc60000u;
    return y ^ (y >> 18);
  }

  std::array<std::uint32_t, n> state_{};
  std::size_t at_ = n;
};

// Octaves of smoothed noise on lattices of n/4, n/8, ... 1 pixels, each half as high as the one
// before, between 0 and `relief`.
inline Heights value_noise(int n, std::uint32_t seed, double relief, double ps) {
  PythonRandom numbers(seed);
  Heights map = flat(n, ps);
  double amplitude = 1;
  for (int step = n / 4; step >= 1; step /= 2, amplitude /= 2) {
    const int m = n / step + 2;
    Heights lattice = flat(m, 1);
    for (double& value : lattice.h) value = numbers.random() * amplitude;
    for (int y = 0; y < n; ++y)
      for (int x = 0; x < n; ++x) {
        const int a = x / step, b = y / step;
        double f = static_cast<double>(x) / step - a, q = static_cast<double>(y) / step - b;
        f = f * f * (3 - 2 * f);
        q = q * q * (3 - 2 * q);
        map.at(x, y) += (lattice.at(a, b) * (1 - f) + lattice.at(a + 1, b) * f) * (1 - q) +
                        (lattice.at(a, b + 1) * (1 - f) + lattice.at(a + 1, b + 1) * f) * q;
      }
  }
  const auto [low, high] = std::minmax_element(map.h.begin(), map.h.end());
  const double lowest = *low, range = *high - *low;
  for (double& height : map.h) height = (height - lowest) / range * relief;
  return map;
}

// The higher of each pixel and its mirror image: the same seen from the east and from the west.
inline Heights mirror_symmetric(const Heights& map) {
  Heights both = map;
  for (int j = 0; j < map.n_y; ++j)
    for (int i = 0; i < map.n_x; ++i)
      both.at(i, j) = std::max(map.at(i, j), map.at(map.n_x - 1 - i, j));
  return both;
}

}  // namespace phytobench::oracles::lesser2019
