// SPDX-License-Identifier: MIT
#include "reference/certified_values.hpp"

#include <algorithm>
#include <array>
#include <string_view>

#include "reference/data_folder.hpp"

namespace phytobench::certified {

namespace {

constexpr std::array<std::string_view, 6> keys_of_all = {
    "name", "quantity", "certified", "difficulty", "promised_digits", "form"};
constexpr std::array<std::string_view, 3> difficulties = {"lower", "average", "higher"};

template <std::size_t count>
bool is_one_of(const std::array<std::string_view, count>& known, std::string_view text) {
  return std::find(known.begin(), known.end(), text) != known.end();
}

void require_common_keys(const TomlTable& table) {
  for (const std::string_view key : keys_of_all)
    if (!table.has(std::string(key))) table.fail("a value needs the key " + std::string(key));
  if (const std::string difficulty = table.text("difficulty"); !is_one_of(difficulties, difficulty))
    table.fail("difficulty is lower, average or higher, not '" + difficulty + "'");
}

std::string mantissa_of(const std::string& decimal) {
  return decimal.substr(0, decimal.find('e'));
}

/// The power of ten that the last digit stands for.
int exponent_of_last_digit(const std::string& decimal) {
  const std::string mantissa = mantissa_of(decimal);
  const std::size_t dot = mantissa.find('.');
  const int decimals = dot == std::string::npos ? 0 : static_cast<int>(mantissa.size() - dot) - 1;
  const int exponent =
      mantissa.size() == decimal.size() ? 0 : std::stoi(decimal.substr(mantissa.size() + 1));
  return exponent - decimals;
}

}  // namespace

std::vector<std::string> Value::inputs() const {
  std::vector<std::string> keys = table_.keys();
  std::erase_if(keys, [](const std::string& key) { return is_one_of(keys_of_all, key); });
  return keys;
}

std::vector<Value> values_of(const std::string& family) {
  const TomlTable file = TomlTable::read(data_folder() / "certified" / (family + ".toml"));
  std::vector<Value> values;
  for (const TomlTable& table : file.tables("value")) {
    require_common_keys(table);
    values.emplace_back(table);
  }
  return values;
}

std::size_t significant_digits(const std::string& decimal) {
  std::string digits = mantissa_of(decimal);
  std::erase_if(digits, [](char c) { return c < '0' || c > '9'; });
  return digits.size() - std::min(digits.find_first_not_of('0'), digits.size());
}

bool is_rounded_to(const std::string& decimal, const Exact& exact) {
  if (significant_digits(decimal) == 0) return exact == 0;
  const Exact last_digit = pow(Exact(10), exponent_of_last_digit(decimal));
  return abs(Exact(decimal) - exact) <= last_digit / 2;
}

}  // namespace phytobench::certified
