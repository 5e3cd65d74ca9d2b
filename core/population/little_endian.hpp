// SPDX-License-Identifier: MIT
// Numbers and lists as bytes of a file, the low byte of a number first, and back.
#pragma once

#include <algorithm>
#include <bit>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/contract/errors.hpp"

namespace phytobench {

/// Bytes of one number in the order of files, from that of this machine or back.
template <class T>
void swap_unless_little_endian(char* bytes) {
  if constexpr (std::endian::native != std::endian::little) std::reverse(bytes, bytes + sizeof(T));
}

class ByteWriter {
 public:
  template <class T>
  void number(T value) {
    char bytes[sizeof(T)];
    std::memcpy(bytes, &value, sizeof(T));
    swap_unless_little_endian<T>(bytes);
    text.append(bytes, sizeof(T));
  }

  void count(std::size_t value) { number(static_cast<std::uint64_t>(value)); }

  void word(std::string_view value) {
    count(value.size());
    text += value;
  }

  /// Without its length.
  template <class T>
  void numbers(std::span<const T> values) {
    if constexpr (std::endian::native == std::endian::little)
      text.append(reinterpret_cast<const char*>(values.data()), values.size_bytes());
    else
      for (const T value : values) number(value);
  }

  template <class T>
  void list(std::span<const T> values) {
    count(values.size());
    numbers(values);
  }

  std::string text;
};

/// Never reads, or makes room for, more than there is.
class ByteReader {
 public:
  ByteReader(std::string_view bytes, const std::string& name) : left_(bytes), name_(name) {}

  template <class T>
  T number() {
    T value;
    std::memcpy(&value, take(sizeof(T)).data(), sizeof(T));
    swap_unless_little_endian<T>(reinterpret_cast<char*>(&value));
    return value;
  }

  /// A length of things that take at least so many bytes each.
  std::size_t count(std::size_t bytes_each) {
    const auto value = number<std::uint64_t>();
    if (value > left_.size() / bytes_each) damaged();
    return static_cast<std::size_t>(value);
  }

  std::string word() { return std::string(take(count(1))); }

  template <class T>
  std::vector<T> numbers(std::size_t size) {
    const std::string_view bytes = take(size * sizeof(T));
    std::vector<T> values(size);
    if (size > 0) std::memcpy(values.data(), bytes.data(), bytes.size());
    for (T& value : values) swap_unless_little_endian<T>(reinterpret_cast<char*>(&value));
    return values;
  }

  template <class T>
  std::vector<T> list() {
    return numbers<T>(count(sizeof(T)));
  }

  void expect(bool condition) const {
    if (!condition) damaged();
  }
  bool is_at_end() const { return left_.empty(); }

 private:
  std::string_view take(std::size_t size) {
    expect(size <= left_.size());
    const std::string_view taken = left_.substr(0, size);
    left_.remove_prefix(size);
    return taken;
  }

  [[noreturn]] void damaged() const {
    throw InputError(name_ + ": is damaged; start the run again, into another folder");
  }

  std::string_view left_;
  const std::string& name_;
};

}  // namespace phytobench
