// SPDX-License-Identifier: MIT
#include "core/population/growth_integrators.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/population/richards_growth.hpp"

namespace phytobench {
namespace {

const RichardsGrowth laws[] = {
    {0.1, 10.0, 0.5}, {0.1, 10.0, 1.0}, {0.1, 10.0, 2.0}, {0.1, 10.0, 3.0}};

/// From the errors of n and 2 n steps.
template <class Method>
double observed_order(const Method& method, const RichardsGrowth& law, std::size_t steps) {
  const auto rate = [&](double v) { return richards_rate(law, v); };
  const double exact = richards_size(law, 1.0, 20.0);
  const double coarse = integrated(method, 1.0, 20.0, steps, rate) - exact;
  const double fine = integrated(method, 1.0, 20.0, 2 * steps, rate) - exact;
  return std::log2(coarse / fine);
}

struct ImplicitEuler {
  template <class Rate>
  double operator()(double size, double step, const Rate& rate) const {
    return implicit_euler_step(size, step, rate).value();
  }
};

TEST(GrowthIntegratorsLaw, HaveTheOrdersOneOneAndFour) {
  for (const RichardsGrowth& law : laws) {
    EXPECT_NEAR(observed_order(ExplicitEuler{}, law, 20'000), 1.0, 0.01) << law.shape;
    EXPECT_NEAR(observed_order(ImplicitEuler{}, law, 20'000), 1.0, 0.01) << law.shape;
    EXPECT_NEAR(observed_order(RungeKutta4{}, law, 40), 4.0, 0.2) << law.shape;
  }
}

TEST(GrowthIntegratorsLaw, StayWhereNothingGrows) {
  const auto rate = [](double v) { return richards_rate({0.1, 10.0, 2.0}, v); };
  EXPECT_EQ(ExplicitEuler{}(10.0, 1.0, rate), 10.0);
  EXPECT_EQ(RungeKutta4{}(10.0, 1.0, rate), 10.0);
  EXPECT_EQ(implicit_euler_step(10.0, 1.0, rate), 10.0);
}

TEST(GrowthIntegrators, StepAVectorAsItsNumbers) {
  const auto one = [](double v) { return richards_rate({0.1, 10.0, 2.0}, v); };
  const auto both = [&](const std::vector<double>& v) {
    return std::vector<double>{one(v[0]), one(v[1])};
  };
  const std::vector<double> start{1.0, 4.0};
  for (std::size_t i = 0; i < 2; ++i) {
    EXPECT_EQ(integrated(RungeKutta4{}, start, 5.0, 10, both)[i],
              integrated(RungeKutta4{}, start[i], 5.0, 10, one));
    EXPECT_EQ(integrated(ExplicitEuler{}, start, 5.0, 10, both)[i],
              integrated(ExplicitEuler{}, start[i], 5.0, 10, one));
  }
}

TEST(ImplicitEuler, SolvesTheEquationOfItsStep) {
  for (const RichardsGrowth& law : laws) {
    const auto rate = [&](double v) { return richards_rate(law, v); };
    for (const double size : {0.01, 1.0, 5.0, 12.0}) {
      const auto next = implicit_euler_step(size, 1.0, rate);
      ASSERT_TRUE(next) << law.shape << " " << size;
      EXPECT_NEAR(*next, size + rate(*next), 1e-14 * *next);
    }
  }
  // 0.01 v^2 + 0.9 v - 1 = 0.
  EXPECT_NEAR(*implicit_euler_step(1.0, 1.0, [](double v) { return 0.1 * v * (1.0 - v / 10.0); }),
              50.0 * (std::sqrt(0.85) - 0.9), 1e-14);
}

TEST(ImplicitEuler, MayShrink) {
  // v = 2 - v and v = 1 - 3 v^2.
  EXPECT_NEAR(*implicit_euler_step(2.0, 1.0, [](double v) { return -v; }), 1.0, 1e-15);
  EXPECT_NEAR(*implicit_euler_step(1.0, 3.0, [](double v) { return -v * v; }),
              (std::sqrt(13.0) - 1.0) / 6.0, 1e-15);
}

TEST(ImplicitEuler, SaysSoWhereItsEquationHasNoSolution) {
  // v = 1 + v.
  EXPECT_FALSE(implicit_euler_step(1.0, 1.0, [](double v) { return v; }));
  // v = 1 + 1 + v^2.
  EXPECT_FALSE(implicit_euler_step(1.0, 1.0, [](double v) { return 1.0 + v * v; }));
  // v = 1 - 3 is no size.
  EXPECT_FALSE(implicit_euler_step(1.0, 1.0, [](double) { return -3.0; }));
  EXPECT_THROW(implicit_euler_step(0.0, 1.0, [](double v) { return v; }), ContractViolation);
}

TEST(GrowthIntegrators, RefuseNoStepsAndSlopesOfAnotherLength) {
  const auto rate = [](double v) { return v; };
  EXPECT_THROW(integrated(ExplicitEuler{}, 1.0, 1.0, 0, rate), ContractViolation);
  EXPECT_THROW(integrated(ExplicitEuler{}, 1.0, std::nan(""), 1, rate), ContractViolation);
  EXPECT_THROW(moved(std::vector<double>{1.0}, 1.0, std::vector<double>{}), ContractViolation);
}

}  // namespace
}  // namespace phytobench
