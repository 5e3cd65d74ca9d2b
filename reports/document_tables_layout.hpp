// SPDX-License-Identifier: MIT
// Rows and columns of a printed table as a report shows them.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "reference/claims.hpp"
#include "reports/document_places.hpp"

namespace phytobench {

/// A row or a column.
struct TableLine {
  std::string name;                  ///< in the names of claims and measurements: "figure-46-left"
  std::string label;                 ///< as a reader sees it
  std::optional<std::size_t> index;  ///< among those of the table; none: only claims are about it
};

struct TableLayout {
  std::vector<TableLine> rows, columns;

  bool has_more_than(const PublishedTable& table) const {
    return rows.size() > table.rows.size() || columns.size() > table.columns.size();
  }
};

/// The lines of the table and, of a published one whose measurements end in "{row}/{column}", those
/// that only claims name, for nothing can be measured there; rows in the order of the claims.
TableLayout layout_of(const PublishedTable& table, const ClaimIndex& claims);

/// The full id of the measurement of a cell, were there one.
std::string cell_name(const PublishedTable& table, const TableLine& row, const TableLine& column);

}  // namespace phytobench
