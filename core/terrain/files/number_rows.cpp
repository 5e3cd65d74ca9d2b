// SPDX-License-Identifier: MIT
#include "core/terrain/files/number_rows.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/terrain/files/number_words.hpp"

namespace phytobench {

namespace {

[[noreturn]] void refuse_field(std::string_view field, const std::string& place) {
  if (field.find(';') != std::string_view::npos)
    throw InputError(
        fmt::format("{}: '{}' has semicolons between its numbers; write commas there, and points "
                    "within numbers",
                    place, shown_word(field)));
  throw InputError(
      fmt::format("{}: '{}' is no finite number; write it like 1.5 or 2e-3, with "
                  "commas between numbers and nothing where there is no data",
                  place, shown_word(field)));
}

double number_in_field(std::string_view field, const std::string& place) {
  std::string_view words = field;
  const std::string_view word = next_word(words);
  if (word.empty() || (is_nan_word(word) && next_word(words).empty())) return HeightField::no_data;
  const std::optional<double> value = number_of(word);
  if (!value || !std::isfinite(*value) || !next_word(words).empty()) refuse_field(field, place);
  return *value;
}

/// How many there were.
std::int64_t append_fields(std::string_view line, const std::string& place,
                           std::vector<double>& values) {
  std::int64_t count = 0;
  for (;;) {
    const std::size_t comma = line.find(',');
    values.push_back(number_in_field(line.substr(0, comma), place));
    ++count;
    if (comma == std::string_view::npos) return count;
    line.remove_prefix(comma + 1);
  }
}

bool holds_numbers(std::string_view line) {
  const std::string_view word = next_word(line);
  return !word.empty() && word.front() != '#';
}

}  // namespace

Raster parse_number_rows(std::string_view text, const std::string& name) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  Raster raster;
  raster.format = "CSV";
  std::int64_t columns = 0, rows = 0;
  for (std::size_t line_number = 1; !text.empty(); ++line_number) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string_view line = text.substr(0, end);
    text.remove_prefix(std::min(end + 1, text.size()));
    if (!holds_numbers(line)) continue;
    const std::string place = fmt::format("{}:{}", name, line_number);
    const std::int64_t count = append_fields(line, place, raster.values);
    if (rows == 0) columns = count;
    if (count != columns)
      throw InputError(
          fmt::format("{}: {} numbers where the first row has {}; complete or remove "
                      "the line",
                      place, count, columns));
    check_raster_size(columns, ++rows, place);
  }
  if (rows == 0) throw InputError(name + ": holds no row of numbers; give at least one");
  raster.columns = static_cast<int>(columns);
  raster.rows = static_cast<int>(rows);
  return raster;
}

}  // namespace phytobench
