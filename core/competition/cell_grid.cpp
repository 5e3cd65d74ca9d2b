// SPDX-License-Identifier: MIT
#include "core/competition/cell_grid.hpp"

#include <functional>
#include <limits>

#include "core/competition/cell_rows.hpp"
#include "core/competition/neighbour_field.hpp"
#include "core/contract/check.hpp"

namespace phytobench {

namespace {

constexpr std::size_t nobody = std::numeric_limits<std::size_t>::max();

/// A cell of the row: its strongest plant, and the weights of all in units of that one's.
struct SharedCell {
  std::size_t strongest = nobody;
  double weights = 0.0;
};

/// Weight of one disc beside others; along a row, the strongest seldom changes.
class WeightBeside {
 public:
  WeightBeside(const SharingLaw& law, std::span<const double> radius, std::size_t disc)
      : law_(law), radius_(radius), disc_(disc) {}

  double operator()(std::size_t strongest) {
    if (strongest != last_) weight_ = law_.weight_ratio(radius_, disc_, strongest);
    last_ = strongest;
    return weight_;
  }

 private:
  const SharingLaw& law_;
  std::span<const double> radius_;
  std::size_t disc_;
  std::size_t last_ = nobody;
  double weight_ = 0.0;
};

/// Sums over the cells of each disc, row by row.
class SharedRow {
 public:
  SharedRow(const CellRows& rows, const Discs& discs, const SharingLaw& law)
      : rows_(rows), radius_(discs.radius), law_(law), cells_(rows.columns()) {}

  void add(const std::vector<CellReach>& strongest_first, std::int64_t row, CellShares& sums) {
    for (const CellReach& reach : strongest_first) {
      WeightBeside weight(law_, radius_, reach.disc());
      rows_.each_cell(reach, row, [&](std::size_t column, double) {
        SharedCell& cell = cells_[column];
        if (cell.strongest == nobody) cell.strongest = reach.disc();
        cell.weights += weight(cell.strongest);
      });
    }
    for (const CellReach& reach : strongest_first) {
      WeightBeside weight(law_, radius_, reach.disc());
      rows_.each_cell(reach, row, [&](std::size_t column, double) {
        sums.won[reach.disc()] += weight(cells_[column].strongest) / cells_[column].weights;
        ++sums.cells[reach.disc()];
      });
    }
    for (const CellReach& reach : strongest_first)
      rows_.each_cell(reach, row, [&](std::size_t column, double) { cells_[column] = {}; });
  }

 private:
  const CellRows& rows_;
  std::span<const double> radius_;
  const SharingLaw& law_;
  std::vector<SharedCell> cells_;
};

class FieldRow {
 public:
  FieldRow(const CellRows& rows, std::span<const double> stem_radius, double field_at_rim)
      : rows_(rows), stem_radius_(stem_radius), at_rim_(field_at_rim), all_(rows.columns(), 0.0) {}

  void add(const std::vector<CellReach>& reaches, std::int64_t row, CellField& sums) {
    for (const CellReach& reach : reaches)
      each_cell(reach, row, [&](std::size_t column, double own) { all_[column] += own; });
    for (const CellReach& reach : reaches)
      each_cell(reach, row, [&](std::size_t column, double own) {
        sums.mean[reach.disc()] += all_[column] - own;
        ++sums.cells[reach.disc()];
      });
    for (const CellReach& reach : reaches)
      rows_.each_cell(reach, row, [&](std::size_t column, double) { all_[column] = 0.0; });
  }

 private:
  template <class Visit>
  void each_cell(const CellReach& reach, std::int64_t row, const Visit& visit) const {
    const NeighbourField field(stem_radius_[reach.disc()], reach.entry.radius, at_rim_);
    rows_.each_cell(reach, row, [&](std::size_t column, double squared) {
      visit(column, field.at(std::sqrt(squared)));
    });
  }

  const CellRows& rows_;
  std::span<const double> stem_radius_;
  double at_rim_;
  std::vector<double> all_;  ///< sum of fields in each cell of the row
};

}  // namespace

CellShares cell_shares(const Discs& discs, const Ground& ground, double side,
                       const SharingLaw& law) {
  PHYTOBENCH_EXPECT(law.is_fit(discs.size()));
  CellRows rows(discs, ground, side);
  CellShares shares{std::vector<double>(discs.size(), 0.0),
                    std::vector<std::int64_t>(discs.size(), 0)};
  SharedRow shared(rows, discs, law);
  const auto is_before = [&](std::size_t i, std::size_t j) {
    return law.is_before(discs.radius, i, j);
  };
  rows.each_row(is_before, [&](const std::vector<CellReach>& reaches, std::int64_t row) {
    shared.add(reaches, row, shares);
  });
  for (double& won : shares.won) won *= rows.cell_area();
  return shares;
}

CellField cell_field(const Discs& zones, std::span<const double> stem_radius, double field_at_rim,
                     const Ground& ground, double side) {
  PHYTOBENCH_EXPECT(stem_radius.size() == zones.size());
  CellRows rows(zones, ground, side);
  CellField field{std::vector<double>(zones.size(), 0.0),
                  std::vector<std::int64_t>(zones.size(), 0)};
  FieldRow fields(rows, stem_radius, field_at_rim);
  rows.each_row(std::less<std::size_t>(),
                [&](const std::vector<CellReach>& reaches, std::int64_t row) {
                  fields.add(reaches, row, field);
                });
  for (std::size_t i = 0; i < zones.size(); ++i)
    field.mean[i] /= static_cast<double>(field.cells[i]);
  return field;
}

}  // namespace phytobench
