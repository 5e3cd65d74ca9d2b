// SPDX-License-Identifier: MIT
#include "core/random/distributions.hpp"

#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/random/counter_stream.hpp"
#include "core/statistics/chi_square.hpp"

namespace phytobench {
namespace {

constexpr double least_p = 1e-4;         // of a chi-square test: four standard errors, about
constexpr double standard_errors = 4.5;  // seeds are fixed: no test fails by chance later on

/// Gives one number for ever.
class ConstantStream final : public UnitStream {
 public:
  explicit ConstantStream(double value) : value_(value) {}
  double next_unit() override { return value_; }

 private:
  double value_;
};

/// Probability of each count up to `last`, by the recursion p(k) = p(k-1) mean / k from the mode
/// outwards: independent of any gamma function.
std::vector<double> poisson_probabilities(double mean, std::size_t last) {
  const auto mode = static_cast<std::size_t>(mean);
  std::vector<double> p(last + 1, 0.0);
  p[mode] = 1.0;
  double sum = 1.0;
  for (std::size_t k = mode + 1; k <= last; ++k)
    sum += p[k] = p[k - 1] * mean / static_cast<double>(k);
  for (std::size_t k = mode; k > 0; --k) sum += p[k - 1] = p[k] * static_cast<double>(k) / mean;
  for (double& probability : p) probability /= sum;
  return p;
}

/// Pearson's statistic over all counts that are expected at least ten times, as a standard normal
/// number (Wilson and Hilferty).
double chi_square_score(double mean, int draws, std::uint64_t seed) {
  const auto last = static_cast<std::size_t>(mean + 12.0 * std::sqrt(mean) + 12.0);
  std::vector<double> seen(last + 1, 0.0);
  CounterStream stream(seed, 0);
  for (int i = 0; i < draws; ++i) seen.at(random_poisson(mean, stream)) += 1.0;
  const std::vector<double> probability = poisson_probabilities(mean, last);
  double statistic = 0.0, cells = 0.0, rest_seen = draws, rest_expected = draws;
  for (std::size_t k = 0; k <= last; ++k) {
    const double expected = probability[k] * draws;
    if (expected < 10.0) continue;
    statistic += (seen[k] - expected) * (seen[k] - expected) / expected;
    cells += 1.0;
    rest_seen -= seen[k];
    rest_expected -= expected;
  }
  statistic += (rest_seen - rest_expected) * (rest_seen - rest_expected) / rest_expected;
  const double spread = 2.0 / (9.0 * cells);
  return (std::cbrt(statistic / cells) - (1.0 - spread)) / std::sqrt(spread);
}

TEST(RandomPoissonLaw, CountsHaveThePoissonProbabilities) {
  // A rejection hat 5 % too low must show: many draws.
  for (const double mean : {0.3, 9.99, 10.0, 40.0})
    EXPECT_LT(chi_square_score(mean, 1'000'000, 5), standard_errors) << "mean " << mean;
  for (const double mean : {2.5, 12.3, 350.0})
    EXPECT_LT(chi_square_score(mean, 200'000, 5), standard_errors) << "mean " << mean;
}

TEST(RandomPoissonLaw, MeanAndVarianceAreEqual) {
  constexpr int draws = 100000;
  for (const double mean : {0.01, 5.0, 1e4, 1e9}) {
    CounterStream stream(2, 0);
    double sum = 0.0, squares = 0.0;
    for (int i = 0; i < draws; ++i) {
      const double excess = static_cast<double>(random_poisson(mean, stream)) - mean;
      sum += excess;
      squares += excess * excess;
    }
    EXPECT_NEAR(sum / draws, 0.0, standard_errors * std::sqrt(mean / draws)) << "mean " << mean;
    // The fourth central moment of the law is 3 mean^2 + mean.
    const double error_of_variance = std::sqrt((2.0 * mean * mean + mean) / draws);
    EXPECT_NEAR(squares / draws, mean, standard_errors * error_of_variance) << "mean " << mean;
  }
}

TEST(RandomPoisson, OfMeanNoneIsNone) {
  CounterStream stream(1, 0);
  for (int i = 0; i < 100; ++i) EXPECT_EQ(random_poisson(0.0, stream), 0u);
}

TEST(RandomPoisson, RefusesWhatIsNoMean) {
  CounterStream stream(1, 0);
  for (const double wrong : {-1e-9, 1.1e9, std::numeric_limits<double>::infinity(),
                             std::numeric_limits<double>::quiet_NaN()})
    EXPECT_THROW(random_poisson(wrong, stream), ContractViolation) << wrong;
}

TEST(RandomNormalLaw, FallsEquallyOftenBetweenItsOctiles) {
  // Normal quantiles of 1/8, 2/8 and 3/8.
  constexpr double octiles[] = {1.1503493803760079, 0.6744897501960817, 0.31863936396437514};
  std::vector<std::int64_t> first(8, 0), second(8, 0);
  const auto octile = [&](double z) {
    std::size_t above = 0;
    for (const double q : octiles) above += static_cast<std::size_t>(z > q) + (z > -q);
    return above + (z > 0.0);
  };
  CounterStream stream(3, 0);
  for (int i = 0; i < 80000; ++i) {
    const auto [x, y] = random_normal_pair(stream);
    ++first[octile(x)];
    ++second[octile(y)];
  }
  EXPECT_GT(uniformity_p_value(first), least_p);
  EXPECT_GT(uniformity_p_value(second), least_p);
}

TEST(RandomNormalLaw, MomentsAreThoseOfTheBell) {
  constexpr int draws = 200000;
  CounterStream stream(4, 0);
  double power[5] = {}, product = 0.0;
  for (int i = 0; i < draws; ++i) {
    const auto [x, y] = random_normal_pair(stream);
    product += x * y;
    double z = 1.0;
    for (double& sum : power) sum += z, z *= x;
  }
  const auto within = [&](double variance) {
    return standard_errors * std::sqrt(variance / draws);
  };
  EXPECT_NEAR(power[1] / draws, 0.0, within(1.0));
  EXPECT_NEAR(power[2] / draws, 1.0, within(2.0));   // 3 - 1
  EXPECT_NEAR(power[3] / draws, 0.0, within(15.0));  // sixth moment
  EXPECT_NEAR(power[4] / draws, 3.0, within(96.0));  // 105 - 9
  EXPECT_NEAR(product / draws, 0.0, within(1.0));    // the two of a pair are independent
}

TEST(RandomNormal, IsTheFirstOfAPair) {
  CounterStream one(9, 0), other(9, 0);
  for (int i = 0; i < 10; ++i) EXPECT_EQ(random_normal(one), random_normal_pair(other)[0]);
}

TEST(RandomExponential, IsFiniteAtBothEndsOfTheStream) {
  ConstantStream lowest(0.0), highest(1.0 - 0x1p-53);
  EXPECT_EQ(random_exponential(lowest), 0.0);
  EXPECT_NEAR(random_exponential(highest), 53.0 * std::log(2.0), 1e-12);
  EXPECT_LT(random_normal_pair(highest)[0], 8.6);
}

TEST(RandomExponentialLaw, MeanAndVarianceAreOne) {
  constexpr int draws = 100000;
  CounterStream stream(6, 0);
  double sum = 0.0, squares = 0.0;
  for (int i = 0; i < draws; ++i) {
    const double q = random_exponential(stream);
    sum += q;
    squares += (q - 1.0) * (q - 1.0);
  }
  EXPECT_NEAR(sum / draws, 1.0, standard_errors * std::sqrt(1.0 / draws));
  EXPECT_NEAR(squares / draws, 1.0, standard_errors * std::sqrt(8.0 / draws));  // 9 - 1
}

}  // namespace
}  // namespace phytobench
