// SPDX-License-Identifier: MIT
// Draws from other laws than the uniform one. The standard library's distributions are not used:
// their sequences differ between implementations.
#pragma once

#include <array>
#include <cstdint>

#include "core/random/unit_stream.hpp"

namespace phytobench {

/// Exponential with mean 1, in [0, 37): -ln v with v uniform in (0, 1]. One number of the stream.
double random_exponential(UnitStream& stream);

/// Two independent standard normal numbers (Box and Muller 1958), each within +-8.6, as far as 53
/// random bits reach. Two numbers of the stream.
std::array<double, 2> random_normal_pair(UnitStream& stream);

/// The first of a pair: two numbers of the stream for one draw.
double random_normal(UnitStream& stream);

/// The largest mean of random_poisson(): beyond it rounding would show in the acceptance.
inline constexpr double largest_poisson_mean = 1e9;

/// A count with the Poisson law of this mean, 0 to largest_poisson_mean; ContractViolation
/// otherwise. Below 10 the gaps of a unit-rate arrival process are multiplied up (Knuth, The Art of
/// Computer Programming 2, sec. 3.4.1), from 10 on transformed rejection takes about 2.3 numbers of
/// the stream at any mean (Hoermann 1993, Insurance: Mathematics and Economics 12, algorithm PTRS).
std::uint64_t random_poisson(double mean, UnitStream& stream);

}  // namespace phytobench
