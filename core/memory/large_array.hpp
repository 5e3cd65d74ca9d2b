// SPDX-License-Identifier: MIT
#pragma once

#include <cstddef>
#include <cstdlib>
#include <limits>
#include <memory>
#include <new>
#include <type_traits>
#include <utility>
#include <vector>

namespace phytobench {

/// At least `bytes` bytes on a cache line, uninitialised. Large pieces come in huge pages where the
/// system has them: random access to hundreds of megabytes in small pages is bound by address
/// translation. Throws std::bad_alloc. Free with std::free.
void* allocate_large(std::size_t bytes);

/// allocate_large() for containers of the standard library.
template <class T>
struct LargeAllocator {
  using value_type = T;

  LargeAllocator() = default;
  template <class Other>
  LargeAllocator(const LargeAllocator<Other>&) {}

  T* allocate(std::size_t count) {
    if (count > std::numeric_limits<std::size_t>::max() / sizeof(T))
      throw std::bad_array_new_length();
    return static_cast<T*>(allocate_large(count * sizeof(T)));
  }
  void deallocate(T* memory, std::size_t) { std::free(memory); }

  friend bool operator==(const LargeAllocator&, const LargeAllocator&) = default;
};

/// A vector that may grow to hundreds of megabytes: in huge pages it costs a fraction of the page
/// faults.
template <class T>
using LargeVector = std::vector<T, LargeAllocator<T>>;

/// Memory for plain data that is written before it is read: not initialised. Keeps its memory when
/// asked for less.
template <class T>
class LargeArray {
  static_assert(std::is_trivially_copyable_v<T>);

 public:
  LargeArray() = default;
  LargeArray(LargeArray&& other) noexcept { *this = std::move(other); }
  LargeArray& operator=(LargeArray&& other) noexcept {
    memory_ = std::move(other.memory_);
    size_ = std::exchange(other.size_, 0);
    capacity_ = std::exchange(other.capacity_, 0);
    return *this;
  }

  void resize_for_overwrite(std::size_t count) {
    if (count > capacity_) {
      if (count > std::numeric_limits<std::size_t>::max() / sizeof(T)) throw std::bad_alloc();
      memory_.reset();  // first, so that both need not fit
      size_ = capacity_ = 0;
      memory_.reset(static_cast<T*>(allocate_large(count * sizeof(T))));
      capacity_ = count;
    }
    size_ = count;
  }

  std::size_t size() const { return size_; }
  T* data() { return memory_.get(); }
  const T* data() const { return memory_.get(); }
  T* begin() { return data(); }
  T* end() { return data() + size_; }
  T& operator[](std::size_t i) { return data()[i]; }
  const T& operator[](std::size_t i) const { return data()[i]; }

 private:
  struct Free {
    void operator()(T* memory) const { std::free(memory); }
  };
  std::unique_ptr<T, Free> memory_;
  std::size_t size_ = 0;
  std::size_t capacity_ = 0;
};

}  // namespace phytobench
