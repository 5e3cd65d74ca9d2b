// SPDX-License-Identifier: MIT
// Attraction points in rows of cells along x, so that what a node can reach is a handful of
// contiguous runs. Built once; afterwards points only leave.
#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "core/geometry/bounding_box.hpp"
#include "core/memory/large_array.hpp"
#include "core/nearest_node/engine.hpp"

namespace phytobench {

/// Four points and the squared distance of each to its nearest node so far: two cache lines. A slot
/// without a live point has x = infinity, so that it is out of everyone's reach, and a negative
/// best.
struct alignas(64) PointBlock {
  static constexpr std::int32_t width = 4;
  double x[width];
  double y[width];
  double z[width];
  double best[width];
};

/// The cells: rows along x with a square cross-section. Eight cells are a chunk. Where there are
/// many points the box is cut into slabs across x, so that neighbouring rows lie close together in
/// memory.
struct RowShape {
  static constexpr std::int32_t chunk_cells = 8;
  static constexpr std::int32_t chunk_entries = chunk_cells + 1;

  Vector3 low;            ///< corner of the points' box
  double cell_x = 1.0;    ///< length of a cell along x
  double row_edge = 1.0;  ///< length of a cell along y and z
  std::int32_t slabs = 1;
  std::int32_t chunks = 1;  ///< of a row in one slab
  std::int32_t rows_y = 1;
  std::int32_t rows_z = 1;
  double margin = 0.0;  ///< more than the rounding of any coordinate
  /// Of a node in its row's cross-section, along y and along z, that RowStencil tells apart.
  std::int32_t places = 4;

  std::int32_t cells() const { return chunks * chunk_cells; }
  std::int32_t rows_per_slab() const { return rows_y * rows_z; }
  std::int32_t rows() const { return slabs * rows_per_slab(); }
  std::int32_t row_entries() const { return chunks * chunk_entries; }
  /// Where cell x begins, counted from the first entry of its row.
  static constexpr std::int32_t entry_of(std::int32_t cell) { return cell + cell / chunk_cells; }
};

/// Shape for searches within `reach` among `count` points in `box`. Fine enough that few points
/// outside the reach are looked at, coarse enough that entries do not outweigh points.
RowShape row_shape(const BoundingBox& box, std::size_t count, double reach);

/// Points sorted by row, then by cell. A chunk has nine entries: where each of its cells begins,
/// counted in slots from the start of the row, and where its live points end; from there to the
/// next chunk nothing lives. So the live points of neighbouring cells are one run of slots.
class RowIndex {
 public:
  /// Entries are 16 bits wide: no row may hold more slots.
  static constexpr std::size_t most_slots_per_row = 65535;

  /// Sorts the points on up to `threads` threads; each starts with the squared distance `unset`.
  /// False if a row would be too long, which is left to an index of another kind.
  bool reset(std::span<const Vector3> points, const RowShape& shape, double unset, int threads);

  const RowShape& shape() const { return shape_; }
  const std::uint16_t* entries() const { return entries_.data(); }
  const std::int32_t* row_begins() const { return row_begins_.data(); }
  PointBlock* blocks() { return blocks_.data(); }
  const PointBlock* blocks() const { return blocks_.data(); }
  PointIndex original(std::int32_t slot) const { return original_[static_cast<std::size_t>(slot)]; }

  double& best(std::int32_t slot) { return block_of(slot).best[slot % PointBlock::width]; }

  /// Bytes held, all told.
  std::size_t bytes() const;

  /// Takes a point out. Its slot stays in its run until compact().
  void remove(std::int32_t slot) { empty(slot, removed_mark); }

  /// Forgets that there was a point.
  void settle(std::int32_t slot) { best(slot) = empty_mark; }

  /// Whether a live point is in the slot, or one that was removed and not settled yet.
  bool holds_point(std::int32_t slot) { return best(slot) >= 0.0 || best(slot) == removed_mark; }

  /// Moves the live points of each chunk together. Slots change.
  void compact(int threads);

 private:
  static constexpr double empty_mark = -1.0;
  static constexpr double removed_mark = -2.0;
  void empty(std::int32_t slot, double mark);
  void compact_chunk(std::int32_t row, std::uint16_t* entry);

  struct Cell {
    std::int32_t row, x;
  };
  std::int32_t cell_along_x(const Vector3& point) const;  ///< counted through all slabs
  Cell cell_of(const Vector3& point) const;
  PointBlock& block_of(std::int32_t slot) {
    return blocks_[static_cast<std::size_t>(slot / PointBlock::width)];
  }
  bool count_rows(std::span<const Vector3> points, int threads);
  bool place_rows(LargeArray<std::int32_t>& counts);
  struct UnsortedPoint {
    Vector3 position;
    PointIndex index;
    std::int32_t entry;  ///< of its cell, counted in its row
  };
  void sort_row(std::span<const Vector3> points, double unset, std::int32_t row,
                std::vector<UnsortedPoint>& unsorted);
  void put(std::int32_t slot, const Vector3& point, double best, PointIndex index);

  RowShape shape_;
  double inverse_x_ = 1.0;
  double inverse_row_ = 1.0;
  LargeArray<PointBlock> blocks_;
  LargeArray<PointIndex> original_;      // per slot
  LargeArray<std::uint16_t> entries_;    // chunk_entries per chunk
  LargeArray<std::int32_t> row_begins_;  // slots, one more than rows
};

}  // namespace phytobench
