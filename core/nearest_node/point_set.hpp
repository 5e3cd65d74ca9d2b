// SPDX-License-Identifier: MIT
#pragma once

#include <bit>
#include <cstdint>
#include <vector>

namespace phytobench {

using PointIndex = std::int32_t;  ///< in the order of the points handed to an engine's reset()

/// A set of points, one bit each. Walking it gives ascending indices without sorting, which keeps
/// sums over the points of a node independent of the order in which an engine found them.
class PointSet {
 public:
  /// Empty, for points 0 ... count - 1.
  void reset(std::size_t count) { words_.assign((count + 63) / 64, 0); }

  void insert(PointIndex point) { words_[word_of(point)] |= bit_of(point); }
  void erase(PointIndex point) { words_[word_of(point)] &= ~bit_of(point); }
  bool contains(PointIndex point) const { return (words_[word_of(point)] & bit_of(point)) != 0; }
  void clear() { words_.assign(words_.size(), 0); }

  std::size_t size() const {
    std::size_t count = 0;
    for (const std::uint64_t word : words_) count += static_cast<std::size_t>(std::popcount(word));
    return count;
  }

  std::size_t bytes() const { return words_.size() * sizeof(std::uint64_t); }

  /// Appends the elements of the set to `points`, ascending.
  void append_to(std::vector<PointIndex>& points) const { append_part_to(points, 0, 1); }

  /// The same for part `part` of `parts` parts that one after the other make up the set.
  void append_part_to(std::vector<PointIndex>& points, std::size_t part, std::size_t parts) const {
    const std::size_t end = words_.size() * (part + 1) / parts;
    for (std::size_t w = words_.size() * part / parts; w < end; ++w)
      for (std::uint64_t word = words_[w]; word != 0; word &= word - 1)
        points.push_back(static_cast<PointIndex>(64 * w) + std::countr_zero(word));
  }

 private:
  static std::size_t word_of(PointIndex point) { return static_cast<std::size_t>(point) / 64; }
  static std::uint64_t bit_of(PointIndex point) {
    return std::uint64_t{1} << (static_cast<std::uint32_t>(point) % 64);
  }

  std::vector<std::uint64_t> words_;
};

}  // namespace phytobench
