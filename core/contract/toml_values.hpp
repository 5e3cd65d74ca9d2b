// SPDX-License-Identifier: MIT
// Checked values of a TOML file, with messages that begin with file:line. Only for the files that
// read parameters: nothing else sees the TOML library.
#pragma once

#include <array>
#include <filesystem>
#include <span>
#include <string>
#include <string_view>

#include <toml++/toml.h>

#include "core/contract/parameter_keys.hpp"

namespace phytobench {

/// Throws InputError with file:line:column for text that is no TOML.
toml::table parse_toml(std::string_view text, std::string_view name);

/// Throws the InputError "file:line: problem".
[[noreturn]] void fail_at(const std::filesystem::path& file, const toml::node& node,
                          const std::string& problem);

/// A key's node, and what messages on it need.
struct TomlValue {
  const std::filesystem::path& file;
  std::string_view name;
  const toml::node& node;

  [[noreturn]] void fail(const std::string& problem) const { fail_at(file, node, problem); }
};

/// Keys are named by their path: a key that holds a '.' itself, in quotes, would pass for another.
void refuse_quoted_name(const TomlValue& value, std::string_view key);

/// Each of these throws InputError for a value of another type, or out of range.
double read_number(const TomlValue& value, const NumberRange& range);
/// Two numbers, as in [1.0, 2.0].
std::array<double, 2> read_pair(const TomlValue& value, const NumberRange& range);
bool read_switch(const TomlValue& value);
std::string read_text(const TomlValue& value);
/// Position of the word that is given.
std::size_t read_choice(const TomlValue& value, std::span<const std::string_view> words);
/// The file, seen from the folder of the TOML file; "" stays "".
std::string read_file_name(const TomlValue& value);

}  // namespace phytobench
