// SPDX-License-Identifier: MIT
#include "core/overlap/layered_grid/layered_grid.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>

#include "core/contract/check.hpp"
#include "core/overlap/layered_grid/size_classes.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// Sixteen doubles behind the last one: more than any vector has.
constexpr std::size_t padding = 16;

/// Cells are this much wider than they need be, so that rounding never moves a neighbour out of
/// reach.
constexpr double wider = 1.0 + 1e-6;

std::int32_t place(double offset, double per_unit, std::int32_t count) {
  return std::clamp(static_cast<std::int32_t>(offset * per_unit), 0, count - 1);
}

struct Extent {
  double low = std::numeric_limits<double>::infinity();
  double high = -std::numeric_limits<double>::infinity();
};

/// Loops that ask the processor to wait for the result before last, not for the last.
constexpr std::size_t lanes = 8;

Extent extent_of(std::span<const double> values) {
  std::array<double, lanes> low, high;
  low.fill(Extent().low);
  high.fill(Extent().high);
  std::size_t i = 0;
  const auto take = [&](std::size_t lane, double value) {
    low[lane] = value < low[lane] ? value : low[lane];
    high[lane] = value > high[lane] ? value : high[lane];
  };
  for (; i + lanes <= values.size(); i += lanes)
    for (std::size_t lane = 0; lane < lanes; ++lane) take(lane, values[i + lane]);
  for (; i < values.size(); ++i) take(0, values[i]);
  return {*std::min_element(low.begin(), low.end()), *std::max_element(high.begin(), high.end())};
}

}  // namespace

void LayeredGrid::build(const Discs& discs, const Ground& ground, int threads) {
  PHYTOBENCH_EXPECT(discs.size() < std::numeric_limits<std::uint32_t>::max());
  find_layers(discs, ground);
  sort_into_rows(discs, threads);
  sort_into_cells(threads);
}

void LayeredGrid::find_box(const Discs& discs, const Ground& ground) {
  period_ = {ground.period_x(), ground.period_y()};
  if (ground.torus) {
    low_ = ground.torus->low;
    high_ = ground.torus->high;
    return;
  }
  const Extent x = extent_of(discs.x), y = extent_of(discs.y);
  low_ = {x.low, y.low};
  high_ = {x.high, y.high};
}

void LayeredGrid::find_layers(const Discs& discs, const Ground& ground) {
  find_box(discs, ground);
  layers_.clear();
  layer_of_exponent_.assign(exponent_count, 0);
  std::size_t rows = 0;
  cells_ = 0;
  for (const SizeClass& sizes : size_classes(discs.radius, Rectangle{low_, high_}.area())) {
    for (std::size_t e = sizes.first_exponent; e <= sizes.last_exponent; ++e)
      layer_of_exponent_[e] = static_cast<std::uint16_t>(layers_.size());
    DiscLayer& layer = layers_.emplace_back();
    layer.largest_radius = sizes.largest;
    layer.disc_count = sizes.count;
    lay_out(layer);
    layer.first_row = rows;
    layer.first_cell = cells_;
    rows += static_cast<std::size_t>(layer.rows);
    cells_ += static_cast<std::size_t>(layer.rows) * static_cast<std::size_t>(layer.columns);
  }
  row_begin_.assign(rows + 1, 0);
}

void LayeredGrid::lay_out(DiscLayer& layer) const {
  // No more cells than discs, however far apart those are.
  const double width = high_.x - low_.x, height = high_.y - low_.y;
  const auto n = static_cast<double>(layer.disc_count);
  const double edge = std::max({2.0 * layer.largest_radius,
                                std::sqrt(width / n) * std::sqrt(height), width / n, height / n}) *
                      wider;
  const auto cells = [&](double length) {
    return std::max(1, static_cast<std::int32_t>(length / edge));
  };
  layer.columns = cells(width);
  layer.rows = cells(height);
  layer.is_crowded_by_space = edge > 8.0 * wider * layer.largest_radius;
  // They fill the box, and so the period of a torus, exactly. A box too thin to divide by has one.
  const auto per_unit = [&](std::int32_t& count, double length) {
    const double result = count / length;
    if (std::isfinite(result)) return result;
    count = 1;
    return 0.0;
  };
  layer.cells_per_x = per_unit(layer.columns, width);
  layer.cells_per_y = per_unit(layer.rows, height);
}

bool LayeredGrid::is_clumped() const {
  double pairs = 0.0, discs = 0.0;
  for (const DiscLayer& layer : layers_) {
    if (!layer.is_crowded_by_space) continue;
    const std::uint32_t* const begin = cell_begin_.data() + layer.first_cell;
    const auto cells =
        static_cast<std::size_t>(layer.rows) * static_cast<std::size_t>(layer.columns);
    for (std::size_t c = 0; c < cells; ++c) {
      const double count = begin[c + 1] - begin[c];
      pairs += count * count;
    }
    discs += static_cast<double>(layer.disc_count);
  }
  constexpr double too_many = 250.0;
  return pairs > too_many * discs;
}

std::size_t LayeredGrid::layer_of(double radius) const {
  return layer_of_exponent_[exponent_of(radius)];
}

std::size_t LayeredGrid::row_of(const DiscLayer& layer, double y) const {
  return layer.first_row +
         static_cast<std::size_t>(place(y - low_.y, layer.cells_per_y, layer.rows));
}

void LayeredGrid::sort_into_rows(const Discs& discs, int threads) {
  // Each thread has a block of discs and in every row a place for those of its block: within a row
  // discs keep their order, however many blocks there are.
  const auto blocks = static_cast<std::size_t>(std::max(1, threads));
  const std::size_t rows = row_begin_.size() - 1;
  const auto for_block = [&](std::size_t block, const auto& visit) {
    for (std::size_t i = discs.size() * block / blocks; i < discs.size() * (block + 1) / blocks;
         ++i)
      if (discs.radius[i] > 0.0) visit(i, row_of(layers_[layer_of(discs.radius[i])], discs.y[i]));
  };
  next_.assign(blocks * rows, 0);
  for_tasks(blocks, threads, [&](std::size_t block) {
    std::uint32_t* const counts = next_.data() + block * rows;
    for_block(block, [&](std::size_t, std::size_t row) { ++counts[row]; });
  });
  std::uint32_t sum = 0;
  for (std::size_t row = 0; row < rows; ++row) {
    row_begin_[row] = sum;
    for (std::size_t block = 0; block < blocks; ++block)
      sum += std::exchange(next_[block * rows + row], sum);
  }
  row_begin_[rows] = sum;
  in_rows_.resize_for_overwrite(sum);
  for_tasks(blocks, threads, [&](std::size_t block) {
    std::uint32_t* const next = next_.data() + block * rows;
    for_block(block, [&](std::size_t i, std::size_t row) {
      in_rows_[next[row]++] = {discs.x[i], discs.y[i], discs.radius[i], static_cast<double>(i)};
    });
  });
}

void LayeredGrid::sort_into_cells(int threads) {
  const std::size_t count = in_rows_.size();
  // Not a multiple of a page: four places at the same offset in their pages get in each other's
  // way.
  constexpr std::size_t page = 512, off_page = 136;
  stride_ = (count + padding) / page * page + page + off_page;
  numbers_.resize_for_overwrite(4 * stride_);
  for (std::size_t a = 0; a < 4; ++a)
    std::fill_n(numbers_.data() + a * stride_ + count, padding, 0.0);
  cell_begin_.resize_for_overwrite(cells_ + 1);
  cell_begin_[cells_] = static_cast<std::uint32_t>(count);
  for (const DiscLayer& layer : layers_)
    for_blocks(static_cast<std::size_t>(layer.rows), threads,
               [&](std::size_t first, std::size_t last) {
                 for (std::size_t row = first; row < last; ++row) sort_row_into_cells(layer, row);
               });
}

void LayeredGrid::sort_row_into_cells(const DiscLayer& layer, std::size_t row) {
  const std::uint32_t begin = row_begin_[layer.first_row + row],
                      end = row_begin_[layer.first_row + row + 1];
  const auto columns = static_cast<std::size_t>(layer.columns);
  std::uint32_t* const cells = cell_begin_.data() + layer.first_cell + row * columns;
  const auto column = [&](const Entry& e) {
    return static_cast<std::size_t>(place(e.x - low_.x, layer.cells_per_x, layer.columns));
  };
  std::fill_n(cells, columns, 0);
  for (std::uint32_t i = begin; i < end; ++i) ++cells[column(in_rows_[i])];
  std::uint32_t sum = begin;
  for (std::size_t c = 0; c < columns; ++c) sum += std::exchange(cells[c], sum);
  double *const x = numbers_.data(), *const y = x + stride_, *const radius = y + stride_,
                *const disc = radius + stride_;
  for (std::uint32_t i = begin; i < end; ++i) {
    const Entry& entry = in_rows_[i];
    const std::uint32_t to = cells[column(entry)]++;
    x[to] = entry.x;
    y[to] = entry.y;
    radius[to] = entry.radius;
    disc[to] = entry.disc;
  }
  // Every cell now says where it ends: where the next one begins.
  std::copy_backward(cells, cells + columns - 1, cells + columns);
  cells[0] = begin;
}

}  // namespace phytobench
