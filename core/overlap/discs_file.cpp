// SPDX-License-Identifier: MIT
#include "core/overlap/discs_file.hpp"

#include <utility>

#include "core/contract/csv_file.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

std::string usual_radius_column(const std::filesystem::path& file) {
  std::error_code ignored;
  const bool may_be_asked = std::filesystem::is_regular_file(file, ignored);
  return may_be_asked && !has_column(file, "r") && has_column(file, "radius") ? "radius" : "r";
}

DiscTable read_discs(const std::filesystem::path& file, const Ground& ground,
                     const std::string& radius_column) {
  auto columns = read_number_columns(file, {"x", "y", radius_column});
  DiscTable table{std::move(columns[0]), std::move(columns[1]), std::move(columns[2])};
  if (const auto problem = problem_with(table.discs(), ground))
    throw InputError(place_of_row(file, problem->disc) + ": " + problem->what);
  return table;
}

}  // namespace phytobench
