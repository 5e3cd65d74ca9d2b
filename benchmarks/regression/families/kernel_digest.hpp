// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <initializer_list>
#include <ranges>
#include <span>
#include <string>
#include <type_traits>

#include "core/contract/sha256.hpp"

namespace phytobench {

/// SHA-256 of inputs or an answer, put in one after the other: the same where all bits are.
class KernelDigest {
 public:
  /// Numbers or letters, or structs of them without padding, as they lie in memory.
  template <std::ranges::contiguous_range Values>
  KernelDigest& add(const Values& values) {
    static_assert(std::is_trivially_copyable_v<std::ranges::range_value_t<Values>>);
    const std::uint64_t count = std::ranges::size(values);
    append(&count, sizeof count);  // so that no value can pass from one list to the next
    append(std::ranges::data(values), count * sizeof(std::ranges::range_value_t<Values>));
    return *this;
  }

  KernelDigest& add(std::initializer_list<double> numbers) {
    return add(std::span(numbers.begin(), numbers.size()));
  }

  std::string hex() const { return sha256_hex(bytes_); }

 private:
  void append(const void* from, std::size_t bytes) {
    if (bytes > 0) bytes_.append(static_cast<const char*>(from), bytes);
  }

  std::string bytes_;
};

/// A choice or a whole number as one of the numbers of a digest.
template <class Value>
constexpr double digest_number(Value value) {
  return static_cast<double>(value);
}

}  // namespace phytobench
