// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>

namespace phytobench {

/// Names an instance by its way from the root, so that its random numbers stay what they are when
/// something else in the plant changes. Two instances of one plant share a name with a probability
/// of about (instances squared) / 2^65.
inline constexpr std::uint64_t identity_of_root = 1;
/// Stands for the link where a parent draws numbers for its i-th child on any link.
inline constexpr std::uint32_t any_link = 0xffffffff;

/// A bijection that spreads every bit over all of them (the finaliser of SplitMix64, Steele, Lea
/// and Flood 2014).
constexpr std::uint64_t mixed(std::uint64_t bits) {
  bits = (bits ^ (bits >> 30)) * 0xbf58476d1ce4e5b9ULL;
  bits = (bits ^ (bits >> 27)) * 0x94d049bb133111ebULL;
  return bits ^ (bits >> 31);
}

/// The i-th instance (1 ... n) that link number `link` makes below `parent`.
constexpr std::uint64_t identity_of_child(std::uint64_t parent, std::uint32_t link,
                                          std::uint32_t i) {
  const std::uint64_t edge = (static_cast<std::uint64_t>(link) << 32) | i;
  return mixed(mixed(parent) + 0x9e3779b97f4a7c15ULL * (edge + 1));
}

}  // namespace phytobench
