// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

namespace phytobench {

/// Which vertices of a height field are lit, one bit each for every position of the sun.
class LitMaps {
 public:
  LitMaps() = default;
  LitMaps(int columns, int rows, std::size_t positions) { reset(columns, rows, positions); }

  /// All dark; keeps its memory.
  void reset(int columns, int rows, std::size_t positions);

  int columns() const { return columns_; }
  int rows() const { return rows_; }
  std::size_t positions() const { return positions_; }
  std::size_t words_per_row() const { return words_per_row_; }

  bool is_lit(std::size_t position, int column, int row) const {
    return (this->row(position, row)[static_cast<std::size_t>(column) / 64] >>
            (static_cast<std::size_t>(column) % 64)) &
           1;
  }
  void set_lit(std::size_t position, int column, int row) {
    this->row(position, row)[static_cast<std::size_t>(column) / 64] |=
        std::uint64_t{1} << (static_cast<std::size_t>(column) % 64);
  }
  /// Bits of columns 0 to 63, 64 to 127, ...; those beyond the last column are 0.
  std::uint64_t* row(std::size_t position, int row) { return words_.data() + word(position, row); }
  const std::uint64_t* row(std::size_t position, int row) const {
    return words_.data() + word(position, row);
  }
  void light_all(std::size_t position);

  std::uint64_t lit(std::size_t position) const;  ///< how many vertices are lit then
  std::uint64_t lit() const;                      ///< at all positions together
  std::size_t bytes() const { return words_.capacity() * sizeof(std::uint64_t); }

  friend bool operator==(const LitMaps&, const LitMaps&) = default;

 private:
  std::size_t word(std::size_t position, int row) const {
    return (position * static_cast<std::size_t>(rows_) + static_cast<std::size_t>(row)) *
           words_per_row_;
  }

  int columns_ = 0;
  int rows_ = 0;
  std::size_t positions_ = 0;
  std::size_t words_per_row_ = 0;
  std::vector<std::uint64_t> words_;
};

/// How many of the bits differ; both of the same shape.
std::uint64_t differing_bits(const LitMaps& a, const LitMaps& b);
/// The same of one position of the sun.
std::uint64_t differing_bits(const LitMaps& a, const LitMaps& b, std::size_t position);

/// At how many positions each vertex is lit, row by row.
std::vector<std::uint16_t> lit_positions(const LitMaps& maps);

}  // namespace phytobench
