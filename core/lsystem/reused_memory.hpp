// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cstddef>

#include "core/memory/large_array.hpp"

namespace phytobench {

/// Makes `array` hold `count` elements that will be written. `room` is how many its memory holds: a
/// word that grows a little with every step does not ask for new memory every time. Afterwards the
/// memory is there even for no elements.
template <class T>
void resize_reused(LargeArray<T>& array, std::size_t& room, std::size_t count) {
  if (count > room || room == 0) {
    const std::size_t wanted = room == 0 ? std::max(count, std::size_t{1}) : count + count / 4;
    room = 0;
    array.resize_for_overwrite(wanted);
    room = wanted;
  }
  array.resize_for_overwrite(count);
}

/// Scratch memory that grows as needed.
template <class T>
class ReusedMemory {
 public:
  void resize(std::size_t count) { resize_reused(array_, room_, count); }
  T* data() { return array_.data(); }
  const T* data() const { return array_.data(); }
  T& operator[](std::size_t i) { return array_[i]; }
  const T& operator[](std::size_t i) const { return array_[i]; }

 private:
  LargeArray<T> array_;
  std::size_t room_ = 0;
};

}  // namespace phytobench
