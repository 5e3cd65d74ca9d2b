// SPDX-License-Identifier: MIT
#include "benchmarks/regression/callgrind_region.hpp"

#include <malloc.h>

#include <algorithm>
#include <cstddef>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"

namespace phytobench {
namespace {

/// Takes a large piece of memory in every run, and notes how much then is in pieces of their own,
/// which the system gives and takes back each time.
class LargeKernel final : public WatchedKernel {
 public:
  explicit LargeKernel(std::size_t& apart) : apart_(apart) {}

  std::string inputs() const override { return "inputs"; }
  void run() override {
    std::vector<double> large(std::size_t{1} << 20, 1.0);
    sum_ = sum_ + large[large.size() / 2];
    apart_ = std::max(apart_, static_cast<std::size_t>(::mallinfo2().hblkhd));
  }
  std::string answer() const override { return "answer"; }
  WorkCounts work() const override { return {}; }
  std::string objection() override { return ""; }

 private:
  std::size_t& apart_;
  volatile double sum_ = 0.0;
};

TEST(CallgrindRegion, KeepsTheMemoryOfTheFirstRunForTheSecond) {
  std::size_t apart = 0;
  const WatchedBenchmark benchmark{.name = "large", .summary = "", .is_own = true, .prepare = [&] {
                                     return std::make_unique<LargeKernel>(apart);
                                   }};
  const auto before = static_cast<std::size_t>(::mallinfo2().hblkhd);
  try {
    EXPECT_EQ(run_in_callgrind_region(benchmark).answer, "answer");
  } catch (const EnvironmentError& error) {
    GTEST_SKIP() << error.what();
  }
  EXPECT_LE(apart, before);
}

}  // namespace
}  // namespace phytobench
