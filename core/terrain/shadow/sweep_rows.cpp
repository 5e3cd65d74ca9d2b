// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/sweep_rows.hpp"

#include <cstring>
#include <limits>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "core/terrain/shadow/sweep_rows.cpp"
#include <hwy/foreach_target.h>
// foreach_target.h must come first.
#include <hwy/highway.h>

HWY_BEFORE_NAMESPACE();
namespace phytobench {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;
// No more than a byte of bits at a time.
using Tag = hn::CappedTag<double, 8>;
using Doubles = hn::Vec<Tag>;
constexpr std::size_t lanes = hn::MaxLanes(Tag());
constexpr std::size_t word_bits = 64;

HWY_INLINE Doubles key_at(const SweepRow& row, std::size_t column) {
  const Tag d;
  const auto rise = hn::Add(hn::LoadU(d, row.column_rise + column), hn::Set(d, row.rise));
  return hn::Sub(hn::LoadU(d, row.heights + column), rise);
}

HWY_INLINE double scalar_key(const SweepRow& row, std::size_t column) {
  return row.heights[column] - (row.column_rise[column] + row.rise);
}

HWY_INLINE std::uint64_t bits_of(hn::Mask<Tag> mask) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(Tag(), mask, bytes);
  return bytes[0];
}

/// The greater one; `so_far` where the key is NaN, which is what a vertex without data has.
HWY_INLINE Doubles greater(Doubles so_far, Doubles key) {
  return hn::IfThenElse(hn::Lt(so_far, key), key, so_far);
}

HWY_INLINE double greater(double so_far, double key) {
  return so_far < key ? key : so_far;
}

/// Runs whole(column) for `lanes` columns at a time and one(column) for the rest; both give the
/// bits of what they looked at. Writes word by word.
template <class Whole, class One>
HWY_INLINE void write_bits(std::size_t columns, std::uint64_t* bits, const Whole& whole,
                           const One& one) {
  for (std::size_t first = 0; first < columns; first += word_bits) {
    const std::size_t end = columns < first + word_bits ? columns : first + word_bits;
    std::uint64_t word = 0;
    std::size_t column = first;
    for (; column + lanes <= end; column += lanes) word |= whole(column) << (column - first);
    for (; column < end; ++column) word |= std::uint64_t{one(column)} << (column - first);
    *bits++ = word;
  }
}

void lines_of_row(const SweepRow& row, double* HWY_RESTRICT lines,
                  std::uint64_t* HWY_RESTRICT lit) {
  const Tag d;
  write_bits(
      row.columns, lit,
      [&](std::size_t column) {
        const auto key = key_at(row, column), so_far = hn::LoadU(d, lines + column);
        hn::StoreU(greater(so_far, key), d, lines + column);
        return bits_of(hn::Not(hn::Gt(so_far, key)));
      },
      [&](std::size_t column) {
        const double key = scalar_key(row, column), so_far = lines[column];
        lines[column] = greater(so_far, key);
        return !(so_far > key);
      });
}

/// What reaches a vertex from the lines on both its sides.
HWY_INLINE void sheared_bits(const SweepRow& row, double aside, const double* lines,
                             std::uint64_t* HWY_RESTRICT lit) {
  const Tag d;
  write_bits(
      row.columns, lit,
      [&](std::size_t column) {
        const auto a = hn::LoadU(d, lines + column), b = hn::LoadU(d, lines + column + 1);
        const auto reaching = hn::Add(a, hn::Mul(hn::Set(d, aside), hn::Sub(b, a)));
        return bits_of(hn::Not(hn::Gt(reaching, key_at(row, column))));
      },
      [&](std::size_t column) {
        const double a = lines[column], b = lines[column + 1];
        return !(a + aside * (b - a) > scalar_key(row, column));
      });
}

void sheared_row(const SweepRow& row, double aside, double* HWY_RESTRICT lines,
                 std::uint64_t* HWY_RESTRICT lit) {
  const Tag d;
  sheared_bits(row, aside, lines, lit);
  // The line before the first vertex is not on the map yet.
  for (std::size_t column = 1; column < row.columns;) {
    if (column + lanes <= row.columns) {
      const auto key = key_at(row, column), before = key_at(row, column - 1);
      const auto met = hn::Add(key, hn::Mul(hn::Set(d, aside), hn::Sub(before, key)));
      hn::StoreU(greater(hn::LoadU(d, lines + column), met), d, lines + column);
      column += lanes;
    } else {
      const double key = scalar_key(row, column);
      const double met = key + aside * (scalar_key(row, column - 1) - key);
      lines[column] = greater(lines[column], met);
      ++column;
    }
  }
}

/// Which vertices no line of `lines` hides; `margin` is added to their keys.
HWY_INLINE void bits_against(const SweepRow& row, const double* lines, double margin,
                             std::uint64_t* HWY_RESTRICT lit) {
  const Tag d;
  write_bits(
      row.columns, lit,
      [&](std::size_t column) {
        const auto key = hn::Add(key_at(row, column), hn::Set(d, margin));
        return bits_of(hn::Not(hn::Gt(hn::LoadU(d, lines + column), key)));
      },
      [&](std::size_t column) { return !(lines[column] > scalar_key(row, column) + margin); });
}

/// Greatest and least key of the vertices at most one column away. -infinity as the least where a
/// ray may have met none: beside a border, or a vertex without data.
HWY_INLINE void add_neighbours(const SweepRow& row, const SweepBounds& bounds, std::size_t column) {
  double most = -std::numeric_limits<double>::infinity();
  double least = std::numeric_limits<double>::infinity();
  const std::size_t first = column == 0 ? 0 : column - 1;
  const std::size_t last = column + 1 == row.columns ? column : column + 1;
  bool is_sure = last == first + 2;
  for (std::size_t c = first; c <= last; ++c) {
    const double key = scalar_key(row, c);
    most = greater(most, key);
    least = key < least ? key : least;
    is_sure = is_sure && key == key;
  }
  bounds.greatest[column] = greater(bounds.greatest[column], most);
  if (is_sure) bounds.least[column] = greater(bounds.least[column], least);
}

HWY_INLINE void add_neighbours_of_many(const SweepRow& row, const SweepBounds& bounds,
                                       std::size_t column) {
  const Tag d;
  const auto none = hn::Set(d, -std::numeric_limits<double>::infinity());
  const auto a = key_at(row, column - 1), b = key_at(row, column), c = key_at(row, column + 1);
  const auto most = greater(greater(greater(none, a), b), c);
  const auto low = hn::IfThenElse(hn::Lt(b, a), b, a);
  const auto lowest = hn::IfThenElse(hn::Lt(c, low), c, low);
  const auto is_sure = hn::And(hn::And(hn::Eq(a, a), hn::Eq(b, b)), hn::Eq(c, c));
  const auto least = hn::IfThenElse(is_sure, lowest, none);
  hn::StoreU(greater(hn::LoadU(d, bounds.greatest + column), most), d, bounds.greatest + column);
  hn::StoreU(greater(hn::LoadU(d, bounds.least + column), least), d, bounds.least + column);
}

void bounds_of_row(const SweepRow& row, const SweepBounds& bounds, std::uint64_t* surely,
                   std::uint64_t* maybe) {
  bits_against(row, bounds.greatest, -bounds.margin, surely);
  bits_against(row, bounds.least, bounds.margin, maybe);
  // A ray may cross the border of the map where its line has left it.
  double& before = *(bounds.greatest - 1);
  before = greater(before, scalar_key(row, 0));
  double& after = bounds.greatest[row.columns];
  after = greater(after, scalar_key(row, row.columns - 1));
  std::size_t column = 0;
  add_neighbours(row, bounds, column++);
  for (; column + lanes < row.columns; column += lanes) add_neighbours_of_many(row, bounds, column);
  for (; column < row.columns; ++column) add_neighbours(row, bounds, column);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace phytobench
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace phytobench {

HWY_EXPORT(lines_of_row);
HWY_EXPORT(sheared_row);
HWY_EXPORT(bounds_of_row);

void sweep_lines(const SweepRow& row, double* lines, std::uint64_t* lit) {
  HWY_DYNAMIC_DISPATCH(lines_of_row)(row, lines, lit);
}

void sweep_sheared_lines(const SweepRow& row, double aside, double* lines, std::uint64_t* lit) {
  HWY_DYNAMIC_DISPATCH(sheared_row)(row, aside, lines, lit);
}

void sweep_bounds(const SweepRow& row, const SweepBounds& bounds, std::uint64_t* surely_lit,
                  std::uint64_t* maybe_lit) {
  HWY_DYNAMIC_DISPATCH(bounds_of_row)(row, bounds, surely_lit, maybe_lit);
}

}  // namespace phytobench
#endif
