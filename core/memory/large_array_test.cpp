// SPDX-License-Identifier: MIT
#include "core/memory/large_array.hpp"

#include <cstdint>
#include <limits>
#include <memory>
#include <new>
#include <numeric>
#include <type_traits>
#include <utility>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

constexpr std::size_t cache_line = 64;
constexpr std::size_t huge_page = std::size_t{1} << 21;

std::size_t beyond_multiple_of(std::size_t alignment, const void* memory) {
  return reinterpret_cast<std::uintptr_t>(memory) % alignment;
}

/// Every byte of it can be written and read.
void expect_usable(void* memory, std::size_t bytes) {
  auto* const byte = static_cast<unsigned char*>(memory);
  for (std::size_t i = 0; i < bytes; ++i) byte[i] = static_cast<unsigned char>(i % 251);
  for (std::size_t i = 0; i < bytes; ++i) ASSERT_EQ(byte[i], i % 251);
}

TEST(AllocateLarge, BeginsOnACacheLine) {
  for (const std::size_t bytes :
       {std::size_t{0}, std::size_t{1}, std::size_t{63}, std::size_t{64}, std::size_t{65},
        std::size_t{1000}, huge_page - 1, huge_page, 2 * huge_page - 1}) {
    const std::unique_ptr<void, decltype(&std::free)> memory(allocate_large(bytes), &std::free);
    ASSERT_NE(memory.get(), nullptr) << bytes;
    EXPECT_EQ(beyond_multiple_of(cache_line, memory.get()), 0u) << bytes;
    expect_usable(memory.get(), bytes);
  }
}

TEST(AllocateLarge, BeginsOnAHugePageFromTwoOfThemOn) {
  for (const std::size_t bytes : {2 * huge_page, 2 * huge_page + 1, 3 * huge_page - 1}) {
    const std::unique_ptr<void, decltype(&std::free)> memory(allocate_large(bytes), &std::free);
    EXPECT_EQ(beyond_multiple_of(huge_page, memory.get()), 0u) << bytes;
    expect_usable(memory.get(), bytes);
  }
}

TEST(LargeArray, HoldsNothingAtFirst) {
  LargeArray<int> numbers;
  EXPECT_EQ(numbers.size(), 0u);
  EXPECT_EQ(numbers.begin(), numbers.end());
}

TEST(LargeArray, OfZeroElementsIsAnEmptyRange) {
  LargeArray<int> numbers;
  for (const std::size_t count : {0u, 10u, 0u}) {
    numbers.resize_for_overwrite(count);
    EXPECT_EQ(numbers.size(), count);
    EXPECT_EQ(numbers.end() - numbers.begin(), static_cast<std::ptrdiff_t>(count));
  }
}

TEST(LargeArray, KeepsWhatIsWrittenAtEveryPlace) {
  for (const std::size_t count : {std::size_t{1}, std::size_t{1000}, 3 * huge_page / 8 + 1}) {
    LargeArray<double> numbers;
    numbers.resize_for_overwrite(count);
    std::iota(numbers.begin(), numbers.end(), 0.5);
    const LargeArray<double>& constant = numbers;
    for (std::size_t i = 0; i < count; ++i)
      ASSERT_EQ(constant[i], static_cast<double>(i) + 0.5) << i;
    EXPECT_EQ(constant.data(), numbers.data());
    EXPECT_EQ(&numbers[count - 1] + 1, numbers.end());
  }
}

TEST(LargeArray, BeginsWhereAllocateLargeDoes) {
  LargeArray<float> numbers;
  numbers.resize_for_overwrite(3);
  EXPECT_EQ(beyond_multiple_of(cache_line, numbers.data()), 0u);
  numbers.resize_for_overwrite(huge_page);  // four bytes each
  EXPECT_EQ(beyond_multiple_of(huge_page, numbers.data()), 0u);
}

TEST(LargeArray, KeepsItsMemoryAndDataWhenAskedForLess) {
  LargeArray<int> numbers;
  numbers.resize_for_overwrite(1000);
  std::iota(numbers.begin(), numbers.end(), 0);
  const int* const memory = numbers.data();
  for (const std::size_t count : {1000u, 999u, 1u, 0u, 500u, 1000u}) {
    numbers.resize_for_overwrite(count);
    EXPECT_EQ(numbers.size(), count);
    EXPECT_EQ(numbers.data(), memory) << count;
  }
  for (std::size_t i = 0; i < 1000; ++i) ASSERT_EQ(numbers[i], static_cast<int>(i));
}

TEST(LargeArray, GrowsBeyondWhatItHad) {
  LargeArray<std::uint16_t> numbers;
  for (std::size_t count = 1; count <= 3 * huge_page; count = 3 * count + 1) {
    numbers.resize_for_overwrite(count);
    EXPECT_EQ(numbers.size(), count);
    expect_usable(numbers.data(), count * sizeof(std::uint16_t));
  }
}

TEST(LargeArray, TellsWhenThereIsNotEnoughMemory) {
#ifdef __SANITIZE_ADDRESS__
  GTEST_SKIP() << "the sanitizer ends the program where malloc would return nothing";
#endif
  LargeArray<double> numbers;
  EXPECT_THROW(numbers.resize_for_overwrite(std::size_t{1} << 58), std::bad_alloc);
}

// The product of count and element size does not fit: no small array must come out.
TEST(LargeArray, RefusesACountWhoseBytesOverflow) {
  LargeArray<double> numbers;
  numbers.resize_for_overwrite(10);
  EXPECT_THROW(numbers.resize_for_overwrite((std::size_t{1} << 61) + 1), std::bad_alloc);
  EXPECT_THROW(allocate_large(std::numeric_limits<std::size_t>::max()), std::bad_alloc);
  EXPECT_EQ(numbers.size(), 10u) << "what was there is kept";
}

TEST(LargeArray, MovesButIsNotCopied) {
  EXPECT_FALSE(std::is_copy_constructible_v<LargeArray<int>>);
  LargeArray<int> numbers;
  numbers.resize_for_overwrite(100);
  std::iota(numbers.begin(), numbers.end(), 0);
  const int* const memory = numbers.data();
  const LargeArray<int> moved = std::move(numbers);
  numbers.resize_for_overwrite(50);
  expect_usable(numbers.data(), 50 * sizeof(int));
  EXPECT_EQ(moved.data(), memory);
  EXPECT_EQ(moved.size(), 100u);
  EXPECT_EQ(moved[99], 99);
}

TEST(LargeVector, KeepsItsElementsAsItGrowsIntoHugePages) {
  LargeVector<std::int64_t> numbers;
  constexpr std::int64_t count = 1'000'000;  // 8 MB
  for (std::int64_t i = 0; i < count; ++i) numbers.push_back(i * i);
  for (std::int64_t i = 0; i < count; ++i) ASSERT_EQ(numbers[static_cast<std::size_t>(i)], i * i);
  const LargeVector<std::int64_t> copy = numbers;
  EXPECT_EQ(copy, numbers);
}

TEST(LargeVector, RefusesWhatNoMemoryHolds) {
  LargeAllocator<std::int64_t> allocator;
  const auto too_many = std::numeric_limits<std::size_t>::max() / sizeof(std::int64_t) + 1;
  EXPECT_THROW(allocator.allocate(too_many), std::bad_array_new_length);
}

}  // namespace
}  // namespace phytobench
