// SPDX-License-Identifier: MIT
#include "core/overlap/discs_file.hpp"

#include <utility>

#include "core/contract/csv_file.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

DiscTable read_discs(const std::filesystem::path& file, const Ground& ground,
                     const std::string& radius_column) {
  auto columns = read_number_columns(file, {"x", "y", radius_column});
  DiscTable table{std::move(columns[0]), std::move(columns[1]), std::move(columns[2])};
  if (const auto problem = problem_with(table.discs(), ground))
    throw InputError(place_of_row(file, problem->disc) + ": " + problem->what);
  return table;
}

}  // namespace phytobench
