// SPDX-License-Identifier: MIT
#include "core/population/cell_population.hpp"

#include <algorithm>
#include <utility>

#include "core/contract/check.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

/// Growth of all cells alike, of each cell its own, and none; called with the cell's number.
struct UniformGrowth {
  LogisticMap map;
  LogisticMap operator()(std::size_t) const { return map; }
};
struct HabitatGrowth {
  const LogisticMap* maps;
  LogisticMap operator()(std::size_t cell) const { return maps[cell]; }
};
struct NoGrowth {
  LogisticMap operator()(std::size_t) const { return {}; }
};

/// One row and what surrounds it.
struct RowView {
  const double* here;
  const double* above;
  const double* below;
  double left;   ///< of the first cell
  double right;  ///< of the last cell
};

struct RowSource {
  const CellGrid& grid;
  CellBorder border;
  const double* counts;
  const double* empty_row;

  RowView row(std::size_t y) const {
    const double* here = counts + y * grid.width;
    const double first = here[0], last = here[grid.width - 1];
    RowView view{here, beyond(y, y > 0, y - 1, grid.height - 1),
                 beyond(y, y + 1 < grid.height, y + 1, 0), 0.0, 0.0};
    if (border == CellBorder::torus) {
      view.left = last;
      view.right = first;
    } else if (border == CellBorder::reflecting) {
      view.left = first;
      view.right = last;
    }
    return view;
  }

 private:
  const double* beyond(std::size_t y, bool inside, std::size_t next, std::size_t opposite) const {
    if (inside) return counts + next * grid.width;
    if (border == CellBorder::absorbing) return empty_row;
    return counts + (border == CellBorder::torus ? opposite : y) * grid.width;
  }
};

/// (2.13) in one row. Opposite neighbours are added first, so that mirror images round alike.
template <class Growth>
void migrate_row(const RowView& row, std::size_t width, std::size_t first_cell, double migration,
                 const Growth& growth, double* next) {
  const auto cell = [&](std::size_t x, double left, double right) {
    const double count = row.here[x];
    const double inflow = ((row.above[x] + row.below[x]) + (left + right)) - 4.0 * count;
    next[x] = growth(first_cell + x).next(count) + migration * inflow;
  };
  if (width == 1) return cell(0, row.left, row.right);
  cell(0, row.left, row.here[1]);
  for (std::size_t x = 1; x + 1 < width; ++x) cell(x, row.here[x - 1], row.here[x + 1]);
  cell(width - 1, row.here[width - 2], row.right);
}

void clip_at_zero(double* counts, std::size_t size) {
  for (std::size_t i = 0; i < size; ++i) counts[i] = std::max(0.0, counts[i]);
}

}  // namespace

std::string_view name_of(CellBorder border) {
  switch (border) {
    case CellBorder::torus:
      return "torus";
    case CellBorder::reflecting:
      return "reflecting";
    case CellBorder::absorbing:
      return "absorbing";
  }
  return "";
}

std::string_view name_of(CellStep step) {
  switch (step) {
    case CellStep::unclipped:
      return "unclipped";
    case CellStep::positive_part:
      return "positive part";
    case CellStep::conserving:
      return "conserving";
  }
  return "";
}

double count_bound(const LogisticMap& growth, double migration) {
  PHYTOBENCH_EXPECT(growth.mortality < 0.0);
  PHYTOBENCH_EXPECT(migration >= 0.0 && migration < bounded_migration);
  const double own = std::max(0.0, growth.reproduction_rate() - 4.0 * migration);
  return own * own / (4.0 * -growth.mortality) / (1.0 - 4.0 * migration);
}

CellPopulation::CellPopulation(const CellGrid& grid, const CellRule& rule,
                               const LogisticMap& growth)
    : CellPopulation(grid, rule, std::vector<LogisticMap>(1, growth)) {}

CellPopulation::CellPopulation(const CellGrid& grid, const CellRule& rule,
                               std::vector<LogisticMap> growth)
    : grid_(grid),
      rule_(rule),
      growth_(std::move(growth)),
      counts_(grid.size(), 0.0),
      next_(grid.size(), 0.0),
      empty_row_(rule.border == CellBorder::absorbing ? grid.width : 0, 0.0) {
  PHYTOBENCH_EXPECT(grid.width > 0 && grid.height > 0);
  PHYTOBENCH_EXPECT(rule.migration >= 0.0 && rule.migration <= 1.0);
  PHYTOBENCH_EXPECT(growth_.size() == 1 || growth_.size() == grid.size());
}

double CellPopulation::total() const {
  double sum = 0.0;
  for (std::size_t y = 0; y < grid_.height; ++y) {
    double row = 0.0;
    for (std::size_t x = 0; x < grid_.width; ++x) row += count_at(x, y);
    sum += row;
  }
  return sum;
}

void CellPopulation::grow(int threads) {
  const bool uniform = growth_.size() == 1;
  for_blocks(counts_.size(), threads, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i)
      counts_[i] = std::max(0.0, growth_[uniform ? 0 : i].next(counts_[i]));
  });
}

template <class Growth>
void CellPopulation::migrate(double migration, const Growth& growth, int threads) {
  const std::size_t width = grid_.width;
  const RowSource source{grid_, rule_.border, counts_.data(), empty_row_.data()};
  // Bands of rows with about as many cells each, so that wide and narrow grids share out alike.
  constexpr std::size_t cells_of_band = 16384;
  const std::size_t rows = std::max<std::size_t>(1, cells_of_band / width);
  const std::size_t bands = (grid_.height + rows - 1) / rows;
  for_tasks(bands, threads, [&](std::size_t band) {
    for (std::size_t y = band * rows; y < std::min(grid_.height, (band + 1) * rows); ++y) {
      double* next = next_.data() + y * width;
      migrate_row(source.row(y), width, y * width, migration, growth, next);
      if (rule_.step == CellStep::positive_part) clip_at_zero(next, width);
    }
  });
  counts_.swap(next_);
}

void CellPopulation::step(int threads) {
  if (rule_.step == CellStep::conserving) {
    grow(threads);
    migrate(std::min(rule_.migration, bounded_migration), NoGrowth{}, threads);
  } else if (growth_.size() == 1) {
    migrate(rule_.migration, UniformGrowth{growth_[0]}, threads);
  } else {
    migrate(rule_.migration, HabitatGrowth{growth_.data()}, threads);
  }
}

}  // namespace phytobench
