// SPDX-License-Identifier: MIT
#include "core/terrain/made/fractal_terrain.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract/check.hpp"
#include "core/parallel/for_blocks.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

constexpr int most_octaves = 14;

void check_options(const MapGrid& grid, const FractalOptions& options) {
  PHYTOBENCH_EXPECT(grid.columns > 0 && grid.rows > 0 && options.threads > 0);
  PHYTOBENCH_EXPECT(grid.cell_width > 0.0 && grid.cell_depth > 0.0);
  PHYTOBENCH_EXPECT(options.relief_m >= 0.0 && std::isfinite(options.relief_m));
  PHYTOBENCH_EXPECT(options.persistence > 0.0 && options.persistence <= 1.0);
  PHYTOBENCH_EXPECT(options.octaves >= 0 && options.octaves <= most_octaves);
}

std::size_t size_of(int count) {
  return static_cast<std::size_t>(count);
}

/// From 0 to the relief. Flat where all heights are the same.
void scale_to_relief(HeightField& field, double relief, int threads) {
  const HeightRange range = height_range(field);
  const double extent = range.highest - range.lowest;
  const std::span<double> heights = field.heights();
  for_blocks(heights.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      heights[i] = extent > 0.0 ? (heights[i] - range.lowest) / extent * relief : 0.0;
  });
}

/// Where a coordinate lies between two corners of a lattice.
struct BetweenCorners {
  std::size_t corner = 0;
  double blend = 0.0;  ///< 0 at this corner, 1 at the next; level at both
};

/// One octave of noise, in the unit of `period` metres.
class NoiseOctave {
 public:
  NoiseOctave(const MapGrid& grid, double period, std::uint64_t seed, int octave)
      : x_(places(grid.columns, grid.cell_width, period)),
        y_(places(grid.rows, grid.cell_depth, period)),
        width_(x_.back().corner + 2) {
    const std::size_t height = y_.back().corner + 2;
    corners_.resize(width_ * height);
    for (std::size_t row = 0; row < height; ++row)
      for (std::size_t column = 0; column < width_; ++column) {
        // The number of a corner does not depend on how wide the lattice is.
        const std::uint64_t index = std::uint64_t{row} << 32 | std::uint64_t{column};
        corners_[row * width_ + column] =
            2.0 * random_unit(seed, static_cast<std::uint64_t>(octave), index) - 1.0;
      }
  }

  void add_row(std::size_t row, double swing, double* heights) const {
    const BetweenCorners& y = y_[row];
    const double* north = corners_.data() + y.corner * width_;
    const double* south = north + width_;
    for (std::size_t column = 0; column < x_.size(); ++column) {
      const BetweenCorners& x = x_[column];
      const double above = north[x.corner] + x.blend * (north[x.corner + 1] - north[x.corner]);
      const double below = south[x.corner] + x.blend * (south[x.corner + 1] - south[x.corner]);
      heights[column] += swing * (above + y.blend * (below - above));
    }
  }

 private:
  static std::vector<BetweenCorners> places(int count, double side, double period) {
    std::vector<BetweenCorners> places(size_of(count));
    for (std::size_t i = 0; i < places.size(); ++i) {
      const double at = static_cast<double>(i) * side / period;
      const double corner = std::floor(at), t = at - corner;
      places[i] = {static_cast<std::size_t>(corner), t * t * (3.0 - 2.0 * t)};
    }
    return places;
  }

  std::vector<BetweenCorners> x_, y_;
  std::size_t width_;
  std::vector<double> corners_;
};

double longer_side(const MapGrid& grid) {
  const double side =
      std::max((grid.columns - 1) * grid.cell_width, (grid.rows - 1) * grid.cell_depth);
  return side > 0.0 ? side : 1.0;  // a single vertex
}

int octave_count(const MapGrid& grid, const FractalOptions& options) {
  if (options.octaves > 0) return options.octaves;
  const double finest = 2.0 * std::min(grid.cell_width, grid.cell_depth);
  int octaves = 1;
  for (double period = longer_side(grid) / 2.0; period >= finest && octaves < most_octaves;
       period /= 2.0)
    ++octaves;
  return octaves;
}

/// Midpoint displacement in place on a square of 2^k + 1 vertices.
class DiamondSquare {
 public:
  DiamondSquare(int side, const FractalOptions& options)
      : side_(side), options_(options), field_(side, side, 1.0, 1.0) {
    for (const int row : {0, side - 1})
      for (const int column : {0, side - 1}) field_.at(column, row) = displacement(column, row);
  }

  HeightField run() {
    double swing = options_.persistence;
    for (int step = side_ - 1; step > 1; step /= 2, swing *= options_.persistence) {
      const int half = step / 2;
      each_row(half, step, [&](int row) { displace_square_row(row, step, swing); });
      each_row(0, half, [&](int row) { displace_diamond_row(row, step, swing); });
    }
    return std::move(field_);
  }

 private:
  /// Each row reads only what earlier passes wrote.
  template <class Row>
  void each_row(int first, int step, const Row& displace) {
    const std::size_t rows = size_of((side_ - 1 - first) / step + 1);
    for_tasks(rows, options_.threads,
              [&](std::size_t i) { displace(first + static_cast<int>(i) * step); });
  }

  double displacement(int column, int row) const {
    return 2.0 * random_unit(options_.seed, 0, field_.index(column, row)) - 1.0;
  }

  /// The middles of squares, from their four corners.
  void displace_square_row(int row, int step, double swing) {
    const int half = step / 2;
    for (int column = half; column < side_; column += step) {
      const double mean =
          (field_.at(column - half, row - half) + field_.at(column + half, row - half) +
           field_.at(column - half, row + half) + field_.at(column + half, row + half)) /
          4.0;
      field_.at(column, row) = mean + swing * displacement(column, row);
    }
  }

  /// The middles of diamonds, from those of their corners that are on the map.
  void displace_diamond_row(int row, int step, double swing) {
    const int half = step / 2;
    for (int column = row / half % 2 == 0 ? half : 0; column < side_; column += step) {
      double sum = 0.0;
      int count = 0;
      const auto add = [&](int x, int y) {
        if (x < 0 || y < 0 || x >= side_ || y >= side_) return;
        sum += field_.at(x, y);
        ++count;
      };
      add(column, row - half);
      add(column - half, row);
      add(column + half, row);
      add(column, row + half);
      field_.at(column, row) = sum / count + swing * displacement(column, row);
    }
  }

  int side_;
  const FractalOptions& options_;
  HeightField field_;
};

}  // namespace

HeightField noise_terrain(const MapGrid& grid, const FractalOptions& options) {
  check_options(grid, options);
  HeightField field(grid.columns, grid.rows, grid.cell_width, grid.cell_depth);
  double period = longer_side(grid), swing = 1.0;
  const int octaves = octave_count(grid, options);
  for (int octave = 0; octave < octaves; ++octave) {
    const NoiseOctave noise(grid, period, options.seed, octave);
    for_tasks(size_of(grid.rows), options.threads, [&](std::size_t row) {
      noise.add_row(row, swing, &field.at(0, static_cast<int>(row)));
    });
    period /= 2.0;
    swing *= options.persistence;
  }
  scale_to_relief(field, options.relief_m, options.threads);
  return field;
}

HeightField diamond_square_terrain(const MapGrid& grid, const FractalOptions& options) {
  check_options(grid, options);
  int side = 2;
  while (side < std::max(grid.columns, grid.rows)) side = 2 * (side - 1) + 1;
  const HeightField square = DiamondSquare(side, options).run();
  HeightField field(grid.columns, grid.rows, grid.cell_width, grid.cell_depth);
  for (int row = 0; row < grid.rows; ++row)
    std::copy_n(square.row(row), size_of(grid.columns), &field.at(0, row));
  scale_to_relief(field, options.relief_m, options.threads);
  return field;
}

}  // namespace phytobench
