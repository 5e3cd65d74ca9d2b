// SPDX-License-Identifier: MIT
#include "core/contract/csv_file.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract/errors.hpp"
#include "core/contract/text_file.hpp"

namespace phytobench {

namespace {

std::string_view trimmed(std::string_view text) {
  const auto is_blank = [](char c) { return c == ' ' || c == '\t' || c == '\r'; };
  while (!text.empty() && is_blank(text.front())) text.remove_prefix(1);
  while (!text.empty() && is_blank(text.back())) text.remove_suffix(1);
  return text;
}

/// As spreadsheets and R write names; what holds a comma stays two fields.
std::string_view unquoted(std::string_view field) {
  const bool is_quoted = field.size() >= 2 && field.front() == '"' && field.back() == '"';
  return is_quoted ? trimmed(field.substr(1, field.size() - 2)) : field;
}

/// Without the three bytes that some programs put before UTF-8.
std::string_view without_mark(std::string_view text) {
  if (text.starts_with("\xef\xbb\xbf")) text.remove_prefix(3);
  return text;
}

/// Not empty, and no comment.
bool holds_fields(std::string_view line) {
  line = trimmed(line);
  return !line.empty() && line.front() != '#';
}

void split(std::string_view line, std::vector<std::string_view>& fields) {
  fields.clear();
  for (;;) {
    const std::size_t comma = line.find(',');
    fields.push_back(unquoted(trimmed(line.substr(0, comma))));
    if (comma == std::string_view::npos) return;
    line.remove_prefix(comma + 1);
  }
}

/// A field as the user sees it, however long or odd.
std::string shown(std::string_view field) {
  constexpr std::size_t most = 40;
  return field.size() <= most ? std::string(field) : std::string(field.substr(0, most)) + "...";
}

class ColumnReader {
 public:
  ColumnReader(std::string_view name, const std::vector<std::string>& columns,
               const std::vector<std::string>& word_columns)
      : name_(name), columns_(columns), word_columns_(word_columns) {
    table_.numbers.resize(columns.size());
    table_.words.resize(word_columns.size());
  }

  void read_line(std::string_view line) {
    ++line_number_;
    if (line_number_ == 1) line = without_mark(line);
    if (!holds_fields(line)) return;
    split(trimmed(line), fields_);
    if (field_count_ == 0)
      read_header();
    else
      read_numbers();
  }

  CsvTable finish() {
    if (field_count_ == 0) refuse(fmt::format("is empty; give a line with {}", wanted()));
    if (rows_ == 0) refuse("has a header but no line of numbers; give at least one");
    return std::move(table_);
  }

 private:
  std::string wanted() const {
    std::vector<std::string> all = columns_;
    all.insert(all.end(), word_columns_.begin(), word_columns_.end());
    return fmt::format("{}", fmt::join(all, ","));
  }

  [[noreturn]] void refuse(const std::string& what) const {
    throw InputError(fmt::format("{}: {}", name_, what));
  }
  [[noreturn]] void refuse_line(const std::string& what) const {
    throw InputError(fmt::format("{}:{}: {}", name_, line_number_, what));
  }

  void read_header() {
    field_count_ = fields_.size();
    for (const std::string& column : columns_) places_.push_back(place_of(column));
    for (const std::string& column : word_columns_) word_places_.push_back(place_of(column));
  }

  std::size_t place_of(const std::string& column) const {
    const auto found = std::find(fields_.begin(), fields_.end(), column);
    if (found == fields_.end())
      refuse_line(fmt::format("no column '{}' in the header; the first line must name {}", column,
                              wanted()));
    if (std::find(found + 1, fields_.end(), column) != fields_.end())
      refuse_line(fmt::format("column '{}' is named twice; keep one", column));
    return static_cast<std::size_t>(found - fields_.begin());
  }

  void read_numbers() {
    if (fields_.size() != field_count_)
      refuse_line(fmt::format("{} fields where the header has {}; complete or remove the line",
                              fields_.size(), field_count_));
    for (std::size_t i = 0; i < places_.size(); ++i)
      table_.numbers[i].push_back(number(fields_[places_[i]], columns_[i]));
    for (std::size_t i = 0; i < word_places_.size(); ++i)
      table_.words[i].push_back(word(fields_[word_places_[i]], word_columns_[i]));
    ++rows_;
  }

  std::string word(std::string_view field, const std::string& column) const {
    if (field.empty()) refuse_line(fmt::format("{} is empty; give a word", column));
    return std::string(field);
  }

  double number(std::string_view field, const std::string& column) const {
    double value = 0.0;
    const auto [end, error] = std::from_chars(field.data(), field.data() + field.size(), value);
    if (error != std::errc() || end != field.data() + field.size() || !std::isfinite(value))
      refuse_line(fmt::format("{} = '{}' is no finite number; write it like 1.5 or 2e-3", column,
                              shown(field)));
    return value;
  }

  std::string_view name_;
  const std::vector<std::string>& columns_;
  const std::vector<std::string>& word_columns_;
  CsvTable table_;
  std::vector<std::size_t> places_, word_places_;
  std::vector<std::string_view> fields_;
  std::size_t field_count_ = 0;
  std::size_t line_number_ = 0;
  std::size_t rows_ = 0;
};

constexpr std::uintmax_t most_csv_bytes = std::uintmax_t{4} << 30;

CsvTable parse(std::string_view text, std::string_view name,
               const std::vector<std::string>& numbers, const std::vector<std::string>& words) {
  ColumnReader reader(name, numbers, words);
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    reader.read_line(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return reader.finish();
}

}  // namespace

std::vector<std::vector<double>> parse_number_columns(std::string_view text, std::string_view name,
                                                      const std::vector<std::string>& columns) {
  return parse(text, name, columns, {}).numbers;
}

CsvTable read_table(const std::filesystem::path& file, const std::vector<std::string>& numbers,
                    const std::vector<std::string>& words) {
  return parse(read_text_file(file, most_csv_bytes), file.string(), numbers, words);
}

std::vector<std::vector<double>> read_number_columns(const std::filesystem::path& file,
                                                     const std::vector<std::string>& columns) {
  return read_table(file, columns, {}).numbers;
}

bool has_column(const std::filesystem::path& file, std::string_view column) {
  const std::string content = read_text_file(file, most_csv_bytes);
  std::string_view text = without_mark(content);
  while (!text.empty()) {
    const std::string_view line = text.substr(0, text.find('\n'));
    text.remove_prefix(std::min(line.size() + 1, text.size()));
    if (!holds_fields(line)) continue;
    std::vector<std::string_view> names;
    split(trimmed(line), names);
    return std::find(names.begin(), names.end(), column) != names.end();
  }
  return false;
}

std::string place_of_row(const std::filesystem::path& file, std::size_t row) {
  const std::string content = read_text_file(file, most_csv_bytes);
  std::string_view text = without_mark(content);
  // The header is the first line that counts.
  for (std::size_t line = 1, lines_to_go = row + 2; !text.empty(); ++line) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    if (holds_fields(text.substr(0, end)) && --lines_to_go == 0)
      return fmt::format("{}:{}", file.string(), line);
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return file.string();
}

}  // namespace phytobench
