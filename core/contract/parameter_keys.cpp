// SPDX-License-Identifier: MIT
#include "core/contract/parameter_keys.hpp"

#include <cctype>
#include <cmath>

#include <fmt/format.h>

#include "core/contract/suggestion.hpp"

namespace phytobench {

bool is_allowed(double value, const NumberRange& range) {
  if (range.infinity_is_allowed && std::isinf(value) && value > 0.0) return true;
  const bool high_enough = range.low_is_allowed ? value >= range.low : value > range.low;
  const bool low_enough = range.high_is_allowed ? value <= range.high : value < range.high;
  return high_enough && low_enough && std::isfinite(value) &&
         (!range.whole || value == std::floor(value));
}

std::string allowed(const NumberRange& range) {
  std::string text = fmt::format("{} {}", range.low_is_allowed ? ">=" : ">", range.low);
  if (std::isfinite(range.high))
    text += fmt::format(" and {} {}", range.high_is_allowed ? "<=" : "<", range.high);
  if (range.infinity_is_allowed) text += ", or inf";
  return range.whole ? text + ", whole" : text;
}

std::string out_of_range(std::string_view name, double value, const NumberRange& range) {
  return fmt::format("{} = {} is not allowed; give a number {}", name, value, allowed(range));
}

std::string unknown_key(std::string_view name, std::span<const std::string> known,
                        std::string_view example) {
  return fmt::format("unknown key '{}'{} ({} lists all keys)", in_one_line(name),
                     did_you_mean(name, known), example);
}

std::string set_the_same(std::string_view key, std::string_view other) {
  return fmt::format("{} and {} set the same; give one of them", key, other);
}

std::string in_one_line(std::string_view text, std::size_t most) {
  std::string line(text.substr(0, most));
  for (char& c : line)
    if (std::iscntrl(static_cast<unsigned char>(c)) != 0) c = '?';
  return text.size() > most ? line + "..." : line;
}

std::string_view section_of(std::string_view name) {
  const std::size_t dot = name.rfind('.');
  return dot == std::string_view::npos ? "" : name.substr(0, dot);
}

std::string_view short_name_of(std::string_view name) {
  return name.substr(name.rfind('.') + 1);
}

std::string example_lines(const KeyText& key) {
  return fmt::format("# {}{}. Unit: {}. Allowed: {}. Source: {}.\n{}{} = {}\n",
                     static_cast<char>(std::toupper(static_cast<unsigned char>(key.meaning[0]))),
                     key.meaning.substr(1), key.unit, key.allowed, key.source,
                     key.is_commented_out ? "# " : "", short_name_of(key.name), key.value);
}

}  // namespace phytobench
