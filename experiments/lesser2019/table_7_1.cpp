// SPDX-License-Identifier: MIT
// Table 7.1: which software considers what, counted; and what is said about it.
#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <numeric>
#include <string>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lesser2019/thesis_site.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

/// In the order of table 7.1.
constexpr std::array columns = {"gena", "unreal", "horizon", "vegetation-studio", "far-cry-5"};
constexpr std::array rows = {"masks",    "slope",      "biome",        "spread",
                             "sunlight", "soil-depth", "soil-moisture"};

/// 1 for "ja".
using Cells = std::array<std::array<std::int64_t, columns.size()>, rows.size()>;

Cells thesis_table() {
  const auto numbers = thesis_parameters().table("features").number_lists("has");
  Cells cells{};
  for (std::size_t row = 0; row < rows.size(); ++row)
    for (std::size_t column = 0; column < columns.size(); ++column)
      cells[row][column] = numbers.at(row).at(column) != 0.0;
  return cells;
}

std::int64_t sum_of_column(const Cells& table, std::size_t column) {
  std::int64_t sum = 0;
  for (const auto& row : table) sum += row[column];
  return sum;
}

std::int64_t sum_of_row(const Cells& table, std::size_t row) {
  return std::accumulate(table[row].begin(), table[row].end(), std::int64_t{0});
}

void run(ExperimentContext& context) {
  const Cells table = thesis_table();
  std::int64_t all = 0, most = 0, with_most = 0;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    context.record(fmt::format("columns/{}", columns[column]), sum_of_column(table, column),
                   "features");
    all += sum_of_column(table, column);
    most = std::max(most, sum_of_column(table, column));
  }
  std::string best;
  for (std::size_t column = 0; column < columns.size(); ++column) {
    if (sum_of_column(table, column) != most) continue;
    best = columns[column];
    ++with_most;
  }
  for (std::size_t row = 0; row < rows.size(); ++row)
    context.record(fmt::format("rows/{}", rows[row]), sum_of_row(table, row), "programs");
  context.record("cells", whole(rows.size() * columns.size()), "cells");
  context.record("yes", all, "cells");
  context.record("most/program", best);
  context.record("most/programs", with_most, "programs");
  context.record("unreal/spread", table[3][1]);
  // Sec. 7.3: these four use masks, and masks only.
  std::int64_t with_masks = 0, with_masks_only = 0;
  for (std::size_t column = 0; column + 1 < columns.size(); ++column) {
    with_masks += table[0][column];
    with_masks_only += table[0][column] == 1 && sum_of_column(table, column) == 1;
  }
  context.record("said-to-use-masks-only", std::int64_t{4}, "programs");
  context.record("with-masks", with_masks, "programs");
  context.record("with-masks-only", with_masks_only, "programs");
}

}  // namespace

extern const ExperimentDescriptor table_7_1;
constinit const ExperimentDescriptor table_7_1{
    .id = "lesser2019/table-7-1",
    .question = "Does the table of features say what the text says of it?",
    .source = "[Lesser2019] table 7.1, sec. 7.2, 7.3",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
