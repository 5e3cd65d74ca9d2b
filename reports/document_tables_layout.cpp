// SPDX-License-Identifier: MIT
#include "reports/document_tables_layout.hpp"

#include <algorithm>
#include <cctype>
#include <string_view>

namespace phytobench {

namespace {

constexpr std::string_view cell_pattern = "{row}/{column}";

/// "figure-46-left" -> "Figure 46 left".
std::string column_label_of(std::string name) {
  std::replace(name.begin(), name.end(), '-', ' ');
  name[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(name[0])));
  return name;
}

std::vector<TableLine> lines_of(const std::vector<std::string>& names,
                                const std::vector<std::string>& labels) {
  std::vector<TableLine> lines;
  for (std::size_t i = 0; i < names.size(); ++i) lines.push_back({names[i], labels[i], i});
  return lines;
}

auto line_named(std::vector<TableLine>& lines, const std::string& name) {
  return std::find_if(lines.begin(), lines.end(),
                      [&](const TableLine& line) { return line.name == name; });
}

/// Puts a line that is new after `before`, the place of the last one that was named.
std::size_t place_of(std::vector<TableLine>& lines, const std::string& name, std::size_t before) {
  const auto found = line_named(lines, name);
  if (found != lines.end()) return static_cast<std::size_t>(found - lines.begin()) + 1;
  const auto at = lines.begin() + static_cast<std::ptrdiff_t>(before);
  lines.insert(at, {name, column_label_of(name), std::nullopt});
  return before + 1;
}

}  // namespace

TableLayout layout_of(const PublishedTable& table, const ClaimIndex& claims) {
  TableLayout layout{lines_of(table.rows, table.row_labels),
                     lines_of(table.columns, table.column_labels)};
  if (table.origin != "published" || !table.measurement.ends_with(cell_pattern)) return layout;
  const std::string start =
      table.measurement.substr(0, table.measurement.size() - cell_pattern.size());
  std::size_t row = 0, column = 0;
  for (const std::string& name : claims.table_names_from(start)) {
    const std::size_t slash = name.find('/');
    if (slash == std::string::npos || name.find('/', slash + 1) != std::string::npos) continue;
    row = place_of(layout.rows, name.substr(0, slash), row);
    column = place_of(layout.columns, name.substr(slash + 1), column);
  }
  return layout;
}

std::string cell_name(const PublishedTable& table, const TableLine& row, const TableLine& column) {
  if (row.index && column.index) return table.measurement_at(*row.index, *column.index);
  return table.measurement.substr(0, table.measurement.size() - cell_pattern.size()) + row.name +
         "/" + column.name;
}

}  // namespace phytobench
