// SPDX-License-Identifier: MIT
// Natural numbers of any size, in decimal digits as on paper: the counts of L-systems leave every
// machine word. Shares no code with core/, so that agreement means something.
#pragma once

#include <cstddef>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>
#include <vector>

namespace phytobench::oracles {

class Natural {
 public:
  Natural(std::uint64_t value = 0) {
    for (; value > 0; value /= 10) digits_.push_back(static_cast<int>(value % 10));
  }

  Natural& operator+=(const Natural& other) {
    int carry = 0;
    for (std::size_t i = 0; i < other.digits_.size() || carry > 0; ++i) {
      if (i == digits_.size()) digits_.push_back(0);
      const int sum = digits_[i] + other.digit(i) + carry;
      digits_[i] = sum % 10;
      carry = sum / 10;
    }
    return *this;
  }
  friend Natural operator+(Natural a, const Natural& b) { return a += b; }
  friend bool operator==(const Natural&, const Natural&) = default;

  std::size_t digits() const { return digits_.size(); }  // 0 has none

  std::string text() const {
    if (digits_.empty()) return "0";
    std::string text;
    for (auto digit = digits_.rbegin(); digit != digits_.rend(); ++digit)
      text += static_cast<char>('0' + *digit);
    return text;
  }

  // Nothing if the number is greater than 2^64 - 1: a 64-bit count must say that it is saturated.
  std::optional<std::uint64_t> in_64_bits() const {
    const std::uint64_t greatest = std::numeric_limits<std::uint64_t>::max();
    std::uint64_t value = 0;
    for (auto digit = digits_.rbegin(); digit != digits_.rend(); ++digit) {
      const auto d = static_cast<std::uint64_t>(*digit);
      if (value > (greatest - d) / 10) return std::nullopt;
      value = 10 * value + d;
    }
    return value;
  }

  // Rounded; infinite where doubles end.
  double in_double() const {
    double value = 0;
    for (auto digit = digits_.rbegin(); digit != digits_.rend(); ++digit)
      value = 10 * value + *digit;
    return value;
  }

 private:
  int digit(std::size_t i) const { return i < digits_.size() ? digits_[i] : 0; }

  std::vector<int> digits_;  // least first, without zeros at the end
};

}  // namespace phytobench::oracles
