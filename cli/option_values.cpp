// SPDX-License-Identifier: MIT
#include "cli/option_values.hpp"

#include <array>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"

namespace phytobench::cli {

void refuse_odd_size(const Rectangle& window, const std::string& whose) {
  constexpr double smallest = 1e-50, largest = 1e50;
  for (const double length : {window.width(), window.height()})
    if (!(length >= smallest && length <= largest))
      throw InputError(
          fmt::format("{}: a window {:g} by {:g} is not within 1e-50 to 1e50; use another unit",
                      whose, window.width(), window.height()));
}

Rectangle rectangle_from(const std::string& text, const std::string& option) {
  const InputError wrong(fmt::format(
      "{} '{}': give x0,y0,x1,y1 with x0 < x1 and y0 < y1, like 0,0,100,50", option, text));
  std::array<double, 4> numbers{};
  const char *at = text.data(), *const end = text.data() + text.size();
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    if (i > 0 && (at == end || *at++ != ',')) throw wrong;
    const auto [next, error] = std::from_chars(at, end, numbers[i]);
    if (error != std::errc() || !std::isfinite(numbers[i])) throw wrong;
    at = next;
  }
  const Rectangle window{{numbers[0], numbers[1]}, {numbers[2], numbers[3]}};
  if (at != end || !(window.width() > 0.0) || !(window.height() > 0.0)) throw wrong;
  refuse_odd_size(window, option);
  return window;
}

std::string json_text(const nlohmann::ordered_json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::ordered_json::error_handler_t::replace);
}

std::string json_text(const nlohmann::json& json, int indent) {
  return json.dump(indent, ' ', false, nlohmann::json::error_handler_t::replace);
}

double shown(double number) {
  return number == 0.0 ? 0.0 : number;
}

std::string with_unit(double seconds) {
  if (seconds < 1e-3) return fmt::format("{:.1f} us", 1e6 * seconds);
  if (seconds < 1.0) return fmt::format("{:.2f} ms", 1e3 * seconds);
  return fmt::format("{:.2f} s", seconds);
}

}  // namespace phytobench::cli
