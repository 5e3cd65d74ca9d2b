// SPDX-License-Identifier: MIT
#include "benchmarks/regression/families/kernel_digest.hpp"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace phytobench {
namespace {

using Numbers = std::vector<double>;

TEST(KernelDigest, IsThatOfEqualBitsAlone) {
  const std::string digest = KernelDigest().add(Numbers{1.0, 2.0}).add({3.0}).hex();
  EXPECT_EQ(digest.size(), 64u);
  EXPECT_EQ(KernelDigest().add({1.0, 2.0}).add(Numbers{3.0}).hex(), digest);
  EXPECT_NE(KernelDigest().add({1.0, std::nextafter(2.0, 3.0)}).add({3.0}).hex(), digest);
  EXPECT_NE(KernelDigest().add({0.0}).hex(), KernelDigest().add({-0.0}).hex());
}

TEST(KernelDigest, KnowsWhereAListEnds) {
  EXPECT_NE(KernelDigest().add({1.0}).add({2.0, 3.0}).hex(),
            KernelDigest().add({1.0, 2.0}).add({3.0}).hex());
  EXPECT_NE(KernelDigest().add(Numbers{}).hex(), KernelDigest().hex());
}

}  // namespace
}  // namespace phytobench
