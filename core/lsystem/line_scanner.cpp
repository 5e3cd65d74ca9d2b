// SPDX-License-Identifier: MIT
#include "core/lsystem/line_scanner.hpp"

#include <algorithm>
#include <cctype>
#include <charconv>

#include <fmt/format.h>

namespace phytobench {

namespace {

bool is_digit(char c) {
  return std::isdigit(static_cast<unsigned char>(c)) != 0;
}

bool is_of_name(char c) {
  return c == '_' || std::isalnum(static_cast<unsigned char>(c)) != 0;
}

}  // namespace

void LineScanner::advance(std::size_t bytes) {
  at_ += bytes;
  skip_blanks();
}

bool LineScanner::take(std::string_view text) {
  if (!next_is(text)) return false;
  advance(text.size());
  return true;
}

std::string_view LineScanner::take_word() {
  const std::string_view left = rest();
  const auto end = std::find_if(left.begin(), left.end(), is_blank);
  const std::string_view word = left.substr(0, static_cast<std::size_t>(end - left.begin()));
  advance(word.size());
  return word;
}

std::string_view LineScanner::take_name() {
  const std::string_view left = rest();
  if (left.empty() || is_digit(left[0])) return {};
  const auto end = std::find_if_not(left.begin(), left.end(), is_of_name);
  const std::string_view name = left.substr(0, static_cast<std::size_t>(end - left.begin()));
  advance(name.size());
  return name;
}

std::optional<double> LineScanner::take_number() {
  const std::string_view left = rest();
  const bool begins = !left.empty() && (is_digit(left[0]) ||
                                        (left[0] == '.' && left.size() > 1 && is_digit(left[1])));
  if (!begins) return std::nullopt;
  double number = 0.0;
  const auto [end, error] = std::from_chars(left.data(), left.data() + left.size(), number);
  if (error != std::errc())
    fail("the number is too large or too small; give one between 1e-300 and 1e300");
  advance(static_cast<std::size_t>(end - left.data()));
  return number;
}

std::string_view LineScanner::take_character() {
  const std::string_view character = rest().substr(0, utf8_length(rest()));
  advance(character.size());
  return character;
}

std::string LineScanner::next_shown() const {
  if (at_end()) return "the end";
  const std::string_view name = next_name();
  return fmt::format(
      "'{}'", name.empty() || name.size() > 40 ? rest().substr(0, utf8_length(rest())) : name);
}

}  // namespace phytobench
