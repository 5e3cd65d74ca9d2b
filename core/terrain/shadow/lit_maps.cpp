// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/lit_maps.hpp"

#include <bit>
#include <limits>

#include "core/contract/check.hpp"

namespace phytobench {

void LitMaps::reset(int columns, int rows, std::size_t positions) {
  PHYTOBENCH_EXPECT(columns > 0 && rows > 0);
  columns_ = columns;
  rows_ = rows;
  positions_ = positions;
  words_per_row_ = (static_cast<std::size_t>(columns) + 63) / 64;
  words_.assign(positions * static_cast<std::size_t>(rows) * words_per_row_, 0);
}

void LitMaps::light_all(std::size_t position) {
  const std::size_t rest = static_cast<std::size_t>(columns_) % 64;
  for (int row = 0; row < rows_; ++row) {
    std::uint64_t* words = this->row(position, row);
    for (std::size_t w = 0; w < words_per_row_; ++w) words[w] = ~std::uint64_t{0};
    if (rest != 0) words[words_per_row_ - 1] = (std::uint64_t{1} << rest) - 1;
  }
}

namespace {

std::uint64_t ones(std::span<const std::uint64_t> words) {
  std::uint64_t count = 0;
  for (const std::uint64_t word : words) count += static_cast<std::uint64_t>(std::popcount(word));
  return count;
}

std::span<const std::uint64_t> words_of(const LitMaps& maps, std::size_t first, std::size_t count) {
  return {maps.row(first, 0), count * static_cast<std::size_t>(maps.rows()) * maps.words_per_row()};
}

std::uint64_t differing(std::span<const std::uint64_t> a, std::span<const std::uint64_t> b) {
  std::uint64_t count = 0;
  for (std::size_t i = 0; i < a.size(); ++i)
    count += static_cast<std::uint64_t>(std::popcount(a[i] ^ b[i]));
  return count;
}

bool same_shape(const LitMaps& a, const LitMaps& b) {
  return a.columns() == b.columns() && a.rows() == b.rows() && a.positions() == b.positions();
}

}  // namespace

std::uint64_t LitMaps::lit(std::size_t position) const {
  return ones(words_of(*this, position, 1));
}

std::uint64_t LitMaps::lit() const {
  return ones(words_);
}

std::uint64_t differing_bits(const LitMaps& a, const LitMaps& b) {
  PHYTOBENCH_EXPECT(same_shape(a, b));
  return differing(words_of(a, 0, a.positions()), words_of(b, 0, b.positions()));
}

std::uint64_t differing_bits(const LitMaps& a, const LitMaps& b, std::size_t position) {
  PHYTOBENCH_EXPECT(same_shape(a, b) && position < a.positions());
  return differing(words_of(a, position, 1), words_of(b, position, 1));
}

std::vector<std::uint16_t> lit_positions(const LitMaps& maps) {
  PHYTOBENCH_EXPECT(maps.positions() <= std::numeric_limits<std::uint16_t>::max());
  const auto columns = static_cast<std::size_t>(maps.columns());
  std::vector<std::uint16_t> counts(columns * static_cast<std::size_t>(maps.rows()), 0);
  for (std::size_t position = 0; position < maps.positions(); ++position)
    for (int row = 0; row < maps.rows(); ++row) {
      std::uint16_t* in_row = counts.data() + static_cast<std::size_t>(row) * columns;
      const std::uint64_t* words = maps.row(position, row);
      for (std::size_t column = 0; column < columns; ++column)
        in_row[column] = static_cast<std::uint16_t>(in_row[column] +
                                                    ((words[column / 64] >> (column % 64)) & 1));
    }
  return counts;
}

}  // namespace phytobench
