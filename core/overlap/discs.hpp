// SPDX-License-Identifier: MIT
// What every overlap engine is given, and what all of them must return.
#pragma once

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/geometry/point2.hpp"
#include "core/memory/large_array.hpp"

namespace phytobench {

using DiscIndex = std::int32_t;

/// Plants on the ground: centers and radii, views of equal size. All finite, radii >= 0.
struct Discs {
  std::span<const double> x;
  std::span<const double> y;
  std::span<const double> radius;

  std::size_t size() const { return x.size(); }
  Discs first(std::size_t count) const {
    return {x.first(count), y.first(count), radius.first(count)};
  }
};

/// Where the discs lie: on the open plane, or on a rectangle whose opposite sides are joined.
struct Ground {
  std::optional<Rectangle> torus = std::nullopt;

  double period_x() const { return torus ? torus->width() : 0.0; }
  double period_y() const { return torus ? torus->height() : 0.0; }
};

/// How many periods the image of a disc lies away; 0, 0 on the open plane.
struct TorusImage {
  int x = 0;
  int y = 0;

  friend constexpr bool operator==(const TorusImage&, const TorusImage&) = default;
};

/// The one distance of the suite between centers i and j (its image): every engine rounds so. The
/// same to the last bit with i and j exchanged and the image turned round.
inline double center_distance(const Discs& discs, const Ground& ground, std::size_t i,
                              std::size_t j, TorusImage image) {
  const double dx = (discs.x[j] - discs.x[i]) + image.x * ground.period_x();
  const double dy = (discs.y[j] - discs.y[i]) + image.y * ground.period_y();
  return std::sqrt(dx * dx + dy * dy);
}

/// Pairs of discs that have an area in common. Three arrays instead of one of structs: 16 bytes
/// each.
class OverlapPairs {
 public:
  std::size_t size() const { return size_; }
  std::span<const DiscIndex> first() const { return {first_.data(), size_}; }
  std::span<const DiscIndex> second() const { return {second_.data(), size_}; }
  std::span<const double> area() const { return {area_.data(), size_}; }

  void clear() { size_ = 0; }
  /// Room for `count` more behind the last; write there, then add_written().
  void make_room(std::size_t count);
  DiscIndex* first_end() { return first_.data() + size_; }
  DiscIndex* second_end() { return second_.data() + size_; }
  double* area_end() { return area_.data() + size_; }
  void add_written(std::size_t count) { size_ += count; }

  void push_back(DiscIndex first, DiscIndex second, double area) {
    make_room(1);
    first_[size_] = first;
    second_[size_] = second;
    area_[size_] = area;
    ++size_;
  }
  /// All of them behind the last, one after the other.
  void append_all(std::span<const OverlapPairs> parts, int threads);

  /// By first, then by second disc, then by area: what engines found in any order is the same
  /// afterwards. Time n + pairs.
  void sort(std::size_t disc_count);
  /// Sorts, then makes one pair of all images of a pair, with the sum of their areas.
  void sort_and_merge(std::size_t disc_count);

 private:
  LargeArray<DiscIndex> first_;
  LargeArray<DiscIndex> second_;
  LargeArray<double> area_;
  std::size_t size_ = 0;
};

/// What is wrong with the discs, with the place of the first that is (0-based); nothing if they are
/// fit for every engine: coordinates up to 1e60, radii 0 or 1e-60 to 1e60; on a torus centers
/// inside it and diameters shorter than both of its sides, so that no disc meets itself.
struct DiscProblem {
  std::size_t disc = 0;
  std::string what;
};
std::optional<DiscProblem> problem_with(const Discs& discs, const Ground& ground);

}  // namespace phytobench
