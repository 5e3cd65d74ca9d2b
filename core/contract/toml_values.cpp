// SPDX-License-Identifier: MIT
#include "core/contract/toml_values.hpp"

#include <algorithm>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract/errors.hpp"

namespace phytobench {

toml::table parse_toml(std::string_view text, std::string_view name) {
  try {
    return toml::parse(text, name);
  } catch (const toml::parse_error& error) {
    const auto& where = error.source().begin;
    // It quotes what it found, line ends included.
    constexpr std::size_t longest = 300;
    throw InputError(fmt::format("{}:{}:{}: not valid TOML: {}", name, where.line, where.column,
                                 in_one_line(error.description(), longest)));
  }
}

void fail_at(const std::filesystem::path& file, const toml::node& node,
             const std::string& problem) {
  throw InputError(fmt::format("{}:{}: {}", file.string(), node.source().begin.line, problem));
}

void refuse_quoted_name(const TomlValue& value, std::string_view key) {
  if (key.find('.') != std::string_view::npos)
    value.fail(fmt::format("unknown key '{}' in quotes; write it without, or as [section] and key",
                           in_one_line(value.name)));
}

double read_number(const TomlValue& value, const NumberRange& range) {
  const auto number = value.node.value<double>();
  if (!number) value.fail(fmt::format("{} must be a number {}", value.name, allowed(range)));
  if (!is_allowed(*number, range)) value.fail(out_of_range(value.name, *number, range));
  return *number;
}

std::array<double, 2> read_pair(const TomlValue& value, const NumberRange& range) {
  const toml::array* array = value.node.as_array();
  if (array == nullptr || array->size() != 2)
    value.fail(
        fmt::format("{} must be two numbers {}, as in [1.0, 2.0]", value.name, allowed(range)));
  const TomlValue first{value.file, value.name, (*array)[0]};
  const TomlValue second{value.file, value.name, (*array)[1]};
  return {read_number(first, range), read_number(second, range)};
}

bool read_switch(const TomlValue& value) {
  if (!value.node.is_boolean()) value.fail(fmt::format("{} must be true or false", value.name));
  return value.node.as_boolean()->get();
}

std::string read_text(const TomlValue& value) {
  const auto text = value.node.value<std::string>();
  if (!text) value.fail(fmt::format("{} must be a text in quotes", value.name));
  return *text;
}

std::size_t read_choice(const TomlValue& value, std::span<const std::string_view> words) {
  const auto text = value.node.value<std::string_view>();
  const auto word = text ? std::find(words.begin(), words.end(), *text) : words.end();
  if (word == words.end())
    value.fail(fmt::format("{} must be one of \"{}\"", value.name, fmt::join(words, "\", \"")));
  return static_cast<std::size_t>(word - words.begin());
}

std::string read_file_name(const TomlValue& value) {
  const auto name = value.node.value<std::string>();
  if (!name) value.fail(fmt::format("{} must be a file name in quotes", value.name));
  return name->empty() ? "" : (value.file.parent_path() / *name).string();
}

}  // namespace phytobench
