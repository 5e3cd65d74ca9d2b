// SPDX-License-Identifier: MIT
// What the keys of every parameter file have in common: ranges, messages and the commented example.
#pragma once

#include <cstddef>
#include <limits>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

/// One visitor made of several lambdas, for std::visit.
template <class... Alternatives>
struct Overloaded : Alternatives... {
  using Alternatives::operator()...;
};
template <class... Alternatives>
Overloaded(Alternatives...) -> Overloaded<Alternatives...>;

/// The numbers that a key may have.
struct NumberRange {
  double low = 0.0;
  double high = std::numeric_limits<double>::infinity();
  bool low_is_allowed = true;
  bool high_is_allowed = true;
  bool whole = false;                ///< only whole numbers
  bool infinity_is_allowed = false;  ///< besides those up to `high`
};

/// Never for NaN.
bool is_allowed(double value, const NumberRange& range);

/// ">= 0 and <= 1, whole".
std::string allowed(const NumberRange& range);

/// "key = 2 is not allowed; give a number >= 0 and <= 1".
std::string out_of_range(std::string_view name, double value, const NumberRange& range);

/// "unknown key 'sed'; did you mean 'seed'? (`example` lists all keys)".
std::string unknown_key(std::string_view name, std::span<const std::string> known,
                        std::string_view example);

/// Two keys that exclude each other are both given.
std::string set_the_same(std::string_view key, std::string_view other);

/// Text of a user for messages of one line: without control characters, and cut after `most` bytes.
std::string in_one_line(std::string_view text, std::size_t most = 80);

/// What is before the last '.' of a key's name, "" at the top; and what is behind it.
std::string_view section_of(std::string_view name);
std::string_view short_name_of(std::string_view name);

/// A key as the commented example shows it.
struct KeyText {
  std::string_view name;
  std::string_view unit;
  std::string_view meaning;  ///< begins with a small letter
  std::string_view source;
  std::string allowed;
  std::string_view value;
  bool is_commented_out = false;
};

/// A comment with all that is known of the key, and the key.
std::string example_lines(const KeyText& key);

}  // namespace phytobench
