// SPDX-License-Identifier: MIT
#include "core/nearest_node/node_driven/row_index.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

constexpr double nowhere = std::numeric_limits<double>::infinity();
constexpr PointIndex no_point = -1;

std::int32_t whole_blocks(std::int32_t slots) {
  return (slots + PointBlock::width - 1) / PointBlock::width * PointBlock::width;
}

// Measured on clouds of 1e4 to 1e7 points: thinner rows look at fewer points, but at more rows.
constexpr double row_edge_per_reach = 0.52;
constexpr double cell_per_reach = 0.22;
constexpr double most_chunks_per_point = 0.72;
// Among fewer points, memory lies in tables rather than in points, and no search takes long.
constexpr std::size_t few_points = 1500;
constexpr std::int32_t places_for_few = 2;
constexpr double most_chunks_per_point_for_few = 0.5;
constexpr std::size_t points_worth_slabs = 200'000;
constexpr std::int32_t chunks_per_slab = 16;

double largest_coordinate(const BoundingBox& box) {
  double largest = 0.0;
  for (const Vector3& corner : {box.low(), box.high()})
    largest = std::max({largest, std::abs(corner.x), std::abs(corner.y), std::abs(corner.z)});
  return largest;
}

}  // namespace

RowShape row_shape(const BoundingBox& box, std::size_t count, double reach) {
  RowShape shape;
  if (box.empty()) return shape;
  const Vector3 extent = box.extent();
  shape.low = box.low();
  shape.margin = reach * 0x1p-30 + largest_coordinate(box) * 0x1p-46;
  const double longest = std::max({extent.x, extent.y, extent.z});
  const bool are_few = count < few_points;
  if (are_few) shape.places = places_for_few;
  const double per_point = are_few ? most_chunks_per_point_for_few : most_chunks_per_point;
  const double most_chunks =
      std::min(per_point * static_cast<double>(count) + 16.0, 5e7);  // 32-bit offsets
  // No finer than a double can tell cells apart, and not zero for a single point.
  double edge = std::max(
      {row_edge_per_reach * reach, 0x1p-20 * longest, std::numeric_limits<double>::min() * 0x1p20});
  for (;; edge *= 1.03) {
    shape.row_edge = edge;
    shape.cell_x = edge * (cell_per_reach / row_edge_per_reach);
    const double chunks = std::floor(extent.x / (shape.cell_x * RowShape::chunk_cells)) + 1.0;
    const double rows_y = std::floor(extent.y / edge) + 1.0;
    const double rows_z = std::floor(extent.z / edge) + 1.0;
    if (chunks * rows_y * rows_z > most_chunks) continue;
    shape.chunks = static_cast<std::int32_t>(chunks);
    if (count > points_worth_slabs && shape.chunks > chunks_per_slab) {
      shape.slabs = (shape.chunks + chunks_per_slab - 1) / chunks_per_slab;
      shape.chunks = chunks_per_slab;
    }
    shape.rows_y = static_cast<std::int32_t>(rows_y);
    shape.rows_z = static_cast<std::int32_t>(rows_z);
    return shape;
  }
}

std::int32_t RowIndex::cell_along_x(const Vector3& point) const {
  return std::min(static_cast<std::int32_t>((point.x - shape_.low.x) * inverse_x_),
                  shape_.slabs * shape_.cells() - 1);
}

RowIndex::Cell RowIndex::cell_of(const Vector3& point) const {
  const auto y = std::min(static_cast<std::int32_t>((point.y - shape_.low.y) * inverse_row_),
                          shape_.rows_y - 1);
  const auto z = std::min(static_cast<std::int32_t>((point.z - shape_.low.z) * inverse_row_),
                          shape_.rows_z - 1);
  const std::int32_t x = cell_along_x(point);
  if (shape_.slabs == 1) return {z * shape_.rows_y + y, x};  // dividing would take the most time
  const std::int32_t slab = x / shape_.cells();
  return {(slab * shape_.rows_z + z) * shape_.rows_y + y, x - slab * shape_.cells()};
}

bool RowIndex::reset(std::span<const Vector3> points, const RowShape& shape, double unset,
                     int threads) {
  shape_ = shape;
  inverse_x_ = 1.0 / shape.cell_x;
  inverse_row_ = 1.0 / shape.row_edge;
  if (!count_rows(points, threads)) return false;
  const auto rows = static_cast<std::size_t>(shape.rows());
  blocks_.resize_for_overwrite(original_.size() / PointBlock::width);
  entries_.resize_for_overwrite(rows * static_cast<std::size_t>(shape.row_entries()) + 1);
  for_blocks(rows, threads, [&](std::size_t begin, std::size_t end) {
    std::vector<UnsortedPoint> unsorted;
    for (std::size_t row = begin; row < end; ++row)
      sort_row(points, unset, static_cast<std::int32_t>(row), unsorted);
  });
  return true;
}

/// Sorts point indices by row into original_ and notes where each row begins.
bool RowIndex::count_rows(std::span<const Vector3> points, int threads) {
  const auto rows = static_cast<std::size_t>(shape_.rows());
  LargeArray<std::int32_t> row_of;
  row_of.resize_for_overwrite(points.size());
  for_blocks(points.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) row_of[i] = cell_of(points[i]).row;
  });
  LargeArray<std::int32_t> next;  // first the number of a row's points, then where the next goes
  next.resize_for_overwrite(rows);
  std::fill(next.begin(), next.end(), 0);
  for (const std::int32_t row : std::span(row_of.data(), row_of.size()))
    ++next[static_cast<std::size_t>(row)];
  if (!place_rows(next)) return false;
  original_.resize_for_overwrite(static_cast<std::size_t>(row_begins_[rows]));
  std::fill(original_.begin(), original_.end(), no_point);
  for (std::size_t i = 0; i < points.size(); ++i) {
    std::int32_t& slot = next[static_cast<std::size_t>(row_of[i])];
    original_[static_cast<std::size_t>(slot++)] = static_cast<PointIndex>(i);
  }
  return true;
}

/// Turns numbers of points into places. Each layer of rows begins with a block of its own: layers
/// are searched by different threads, and a block is looked at as a whole.
bool RowIndex::place_rows(LargeArray<std::int32_t>& counts) {
  row_begins_.resize_for_overwrite(counts.size() + 1);
  std::int32_t begin = 0;
  bool fits = true;
  for (std::size_t row = 0; row < counts.size(); ++row) {
    if (row % static_cast<std::size_t>(shape_.rows_y) == 0) begin = whole_blocks(begin);
    const std::int32_t count = counts[row];
    fits &= static_cast<std::size_t>(count) <= most_slots_per_row;
    row_begins_[row] = counts[row] = begin;
    begin += count;
  }
  row_begins_[counts.size()] = whole_blocks(begin);
  return fits;
}

/// Sorts the points of one row into cells: counts, sums, places.
void RowIndex::sort_row(std::span<const Vector3> points, double unset, std::int32_t row,
                        std::vector<UnsortedPoint>& unsorted) {
  const std::int32_t begin = row_begins_[static_cast<std::size_t>(row)];
  std::int32_t end = row_begins_[static_cast<std::size_t>(row) + 1];
  for (; end > begin && original(end - 1) == no_point; --end)  // up to the next layer
    put(end - 1, {nowhere, 0.0, 0.0}, empty_mark, no_point);
  const std::int32_t first_cell = row / shape_.rows_per_slab() * shape_.cells();
  const auto count = static_cast<std::size_t>(shape_.row_entries());
  std::uint16_t* const entries = entries_.data() + static_cast<std::size_t>(row) * count;
  std::fill_n(entries, count, std::uint16_t{0});
  unsorted.clear();
  constexpr std::int32_t ahead = 8;  // the points lie anywhere in memory
  for (std::int32_t slot = begin; slot < end; ++slot) {
    const PointIndex soon = original(std::min(slot + ahead, end - 1));
    __builtin_prefetch(&points[static_cast<std::size_t>(soon)]);
    const PointIndex index = original(slot);
    const Vector3& point = points[static_cast<std::size_t>(index)];
    const std::int32_t entry = RowShape::entry_of(cell_along_x(point) - first_cell);
    unsorted.push_back({point, index, entry});
    ++entries[entry];
  }
  std::uint16_t sum = 0;
  for (std::size_t entry = 0; entry < count; ++entry)
    sum = static_cast<std::uint16_t>(sum + std::exchange(entries[entry], sum));
  for (const UnsortedPoint& p : unsorted)
    put(begin + entries[p.entry]++, p.position, unset, p.index);
  // Each cell's begin has run on to the next cell's.
  std::move_backward(entries, entries + count - 1, entries + count);
  entries[0] = 0;
}

void RowIndex::put(std::int32_t slot, const Vector3& point, double best, PointIndex index) {
  PointBlock& block = block_of(slot);
  const std::int32_t lane = slot % PointBlock::width;
  block.x[lane] = point.x;
  block.y[lane] = point.y;
  block.z[lane] = point.z;
  block.best[lane] = best;
  original_[static_cast<std::size_t>(slot)] = index;
}

std::size_t RowIndex::bytes() const {
  return blocks_.size() * sizeof(PointBlock) + original_.size() * sizeof(PointIndex) +
         entries_.size() * sizeof(std::uint16_t) + row_begins_.size() * sizeof(std::int32_t);
}

void RowIndex::empty(std::int32_t slot, double mark) {
  PointBlock& block = block_of(slot);
  block.x[slot % PointBlock::width] = nowhere;
  block.best[slot % PointBlock::width] = mark;
}

void RowIndex::compact(int threads) {
  // Rows of one layer share blocks, layers do not.
  const auto layers = static_cast<std::size_t>(shape_.slabs * shape_.rows_z);
  for_tasks(layers, threads, [&](std::size_t layer) {
    const auto first = static_cast<std::int32_t>(layer) * shape_.rows_y;
    for (std::int32_t row = first; row < first + shape_.rows_y; ++row) {
      std::uint16_t* const entries =
          entries_.data() +
          static_cast<std::size_t>(row) * static_cast<std::size_t>(shape_.row_entries());
      for (std::int32_t chunk = 0; chunk < shape_.chunks; ++chunk)
        compact_chunk(row, entries + chunk * RowShape::chunk_entries);
    }
  });
}

void RowIndex::compact_chunk(std::int32_t row, std::uint16_t* entry) {
  const std::int32_t row_begin = row_begins_[static_cast<std::size_t>(row)];
  std::int32_t from = row_begin + entry[0];
  const std::int32_t last = row_begin + entry[RowShape::chunk_cells];
  while (from < last && best(from) >= 0.0) ++from;
  if (from == last) return;  // nothing has left
  from = row_begin + entry[0];
  std::int32_t to = from;
  for (std::int32_t cell = 0; cell < RowShape::chunk_cells; ++cell) {
    const std::int32_t end = row_begin + entry[cell + 1];
    entry[cell] = static_cast<std::uint16_t>(to - row_begin);
    for (; from < end; ++from) {
      const PointBlock& block = block_of(from);
      const std::int32_t lane = from % PointBlock::width;
      if (block.best[lane] < 0.0) continue;
      if (from != to)
        put(to, {block.x[lane], block.y[lane], block.z[lane]}, block.best[lane], original(from));
      ++to;
    }
  }
  entry[RowShape::chunk_cells] = static_cast<std::uint16_t>(to - row_begin);
  for (; to < from; ++to) empty(to, empty_mark);
}

}  // namespace phytobench
