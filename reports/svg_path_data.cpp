// SPDX-License-Identifier: MIT
#include "reports/svg_path_data.hpp"

#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "reports/characters.hpp"

namespace phytobench {

namespace {

/// A number of tenths without needless zeros: "3.5", "-.2", "12".
std::string shown_tenths(long tenths) {
  const std::string sign = tenths < 0 ? "-" : "";
  const long whole = std::abs(tenths) / 10, rest = std::abs(tenths) % 10;
  if (rest == 0) return fmt::format("{}{}", sign, whole);
  return whole == 0 ? fmt::format("{}.{}", sign, rest) : fmt::format("{}{}.{}", sign, whole, rest);
}

std::string pair_text(long x, long y) {
  const std::string second = shown_tenths(y);
  return shown_tenths(x) + (second.starts_with('-') ? "" : " ") + second;
}

class Steps {
 public:
  void move_to(long x, long y) {
    const std::string absolute = "M" + pair_text(x, y);
    const std::string relative = "m" + pair_text(x - x_, y - y_);
    text_ += text_.empty() || absolute.size() <= relative.size() ? absolute : relative;
    start_x_ = x;
    start_y_ = y;
    set(x, y, 'M');
  }

  void line_to(long x, long y) {
    const long across = x - x_, down = y - y_;
    if (across == 0 && down == 0 && command_ != 'M') return;
    if (down == 0) {
      text_ += "h" + shown_tenths(across);
      set(x, y, 'h');
    } else if (across == 0) {
      text_ += "v" + shown_tenths(down);
      set(x, y, 'v');
    } else {
      const std::string pair = pair_text(across, down);
      text_ += command_ != 'l' ? "l" : pair.starts_with('-') ? "" : " ";
      text_ += pair;
      set(x, y, 'l');
    }
  }

  void across(long by) {
    text_ += "h" + shown_tenths(by);
    set(x_ + by, y_, 'h');
  }

  void close() {
    text_ += 'z';
    set(start_x_, start_y_, 'z');
  }

  const std::string& text() const { return text_; }

 private:
  void set(long x, long y, char command) {
    x_ = x;
    y_ = y;
    command_ = command;
  }

  std::string text_;
  long x_ = 0, y_ = 0, start_x_ = 0, start_y_ = 0;
  char command_ = 0;
};

/// Reads a number in tenths; false if there is none.
bool read_tenths(const std::string& data, std::size_t& at, long& tenths) {
  while (at < data.size() && (is_space(data[at]) || data[at] == ',')) ++at;
  double number = 0.0;
  const char* const end = data.data() + data.size();
  const auto [rest, error] = std::from_chars(data.data() + at, end, number);
  if (error != std::errc{}) return false;
  tenths = std::lround(10.0 * number);
  at = static_cast<std::size_t>(rest - data.data());
  return true;
}

}  // namespace

bool is_space(char c) {
  return std::isspace(static_cast<unsigned char>(c)) != 0;
}

std::string spaceless_path_data(std::string_view data) {
  std::string text;
  for (std::size_t i = 0; i < data.size(); ++i) {
    if (!is_space(data[i])) {
      text += data[i];
      continue;
    }
    while (i + 1 < data.size() && is_space(data[i + 1])) ++i;
    const bool needed =
        !text.empty() && !is_letter(text.back()) && i + 1 < data.size() && !is_letter(data[i + 1]);
    if (needed) text += ' ';
  }
  return text;
}

bool is_in_tenths(std::string_view data) {
  std::size_t decimals = 0;
  bool in_decimals = false;
  for (const char c : data) {
    const bool digit = std::isdigit(static_cast<unsigned char>(c)) != 0;
    decimals = in_decimals && digit ? decimals + 1 : 0;
    in_decimals = c == '.' || (in_decimals && digit);
    if (decimals > 1 || c == 'e' || c == 'E') return false;
  }
  return true;
}

std::string stepwise_path_data(const std::string& data) {
  Steps steps;
  char command = 0;
  for (std::size_t at = 0; at < data.size();) {
    if (is_letter(data[at])) command = data[at++];
    long x = 0, y = 0;
    if (command == 'z') {
      steps.close();
      command = 0;
    } else if (command == 'h' && read_tenths(data, at, x)) {
      steps.across(x);
    } else if (command == 'M' && read_tenths(data, at, x) && read_tenths(data, at, y)) {
      steps.move_to(x, y);
      command = 'L';
    } else if (command == 'L' && read_tenths(data, at, x) && read_tenths(data, at, y)) {
      steps.line_to(x, y);
    } else {
      return data;
    }
  }
  return steps.text();
}

}  // namespace phytobench
