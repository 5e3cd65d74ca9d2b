// SPDX-License-Identifier: MIT
// The files of reference/certified/ as tests read them, and numbers of a hundred digits to derive
// their values again with.
#pragma once

#include <cstddef>
#include <string>
#include <vector>

#include <boost/multiprecision/cpp_bin_float.hpp>

#include "reference/toml_table.hpp"

namespace phytobench::certified {

using Exact = boost::multiprecision::cpp_bin_float_100;

/// One certified value with its inputs. Decimals are read with all their digits.
class Value {
 public:
  explicit Value(TomlTable table) : table_(std::move(table)) {}

  std::string name() const { return table_.text("name"); }
  std::string quantity() const { return table_.text("quantity"); }
  std::string digits() const { return table_.text("certified"); }
  double certified() const { return number("certified"); }  ///< rounded
  double promised_digits() const { return table_.number("promised_digits"); }

  Exact exact(const std::string& input) const { return Exact(table_.text(input)); }
  double number(const std::string& input) const { return static_cast<double>(exact(input)); }
  std::size_t count(const std::string& input) const {
    return static_cast<std::size_t>(number(input));
  }
  /// The keys that are inputs, in file order.
  std::vector<std::string> inputs() const;

 private:
  TomlTable table_;
};

/// The values of the file of that name without ".toml". Throws InputError if an entry lacks what
/// every entry has or has an unknown difficulty.
std::vector<Value> values_of(const std::string& family);

/// Digits from the first that is not 0 on; none in "0".
std::size_t significant_digits(const std::string& decimal);

/// Whether the decimal number is `exact` rounded to the last digit that is written; "0" must be 0.
bool is_rounded_to(const std::string& decimal, const Exact& exact);

}  // namespace phytobench::certified
