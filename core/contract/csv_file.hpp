// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// Numbers from a comma-separated file whose first line names the columns. Other columns may be
/// there and are ignored; empty lines and lines that start with # are skipped, double quotes
/// around a field are taken off. Returns one vector
/// per wanted column, in the order of `columns`, all of the same length. Throws InputError with
/// file:line for a missing column, a line with more or fewer fields than the header, a field that
/// is no finite number, and a file without any line of numbers.
std::vector<std::vector<double>> read_number_columns(const std::filesystem::path& file,
                                                     const std::vector<std::string>& columns);

/// The same from text; `name` stands for the file in messages.
std::vector<std::vector<double>> parse_number_columns(std::string_view text, std::string_view name,
                                                      const std::vector<std::string>& columns);

/// Columns of numbers and columns of words, each in the order asked for.
struct CsvTable {
  std::vector<std::vector<double>> numbers;
  std::vector<std::vector<std::string>> words;
};

/// The same with columns that may hold any words but commas and nothing but blanks.
CsvTable read_table(const std::filesystem::path& file, const std::vector<std::string>& numbers,
                    const std::vector<std::string>& words);

/// Whether the first line names that column, for those that a file may leave out. Throws InputError
/// for a file that cannot be read.
bool has_column(const std::filesystem::path& file, std::string_view column);

/// "points.csv:12": where row `row` (0-based, of numbers) of such a file stands, for messages on
/// what only the reader of the numbers can find wrong.
std::string place_of_row(const std::filesystem::path& file, std::size_t row);

}  // namespace phytobench
