// SPDX-License-Identifier: MIT
#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>

namespace phytobench {

/// Mean, spread and extremes of values that come one by one (Welford 1962: no digits lost where the
/// mean is large). NaN where there are too few values.
class RunningMoments {
 public:
  void add(double value) {
    ++count_;
    const double before = value - mean_;
    mean_ += before / static_cast<double>(count_);
    squares_ += before * (value - mean_);
    least_ = std::min(least_, value);
    largest_ = std::max(largest_, value);
  }

  std::int64_t count() const { return count_; }
  double mean() const { return count_ > 0 ? mean_ : nan; }
  /// Of the population: divided by one less than the number of values.
  double variance() const { return count_ > 1 ? squares_ / static_cast<double>(count_ - 1) : nan; }
  double deviation() const { return std::sqrt(variance()); }
  /// Of the mean, for independent values.
  double standard_error() const { return deviation() / std::sqrt(static_cast<double>(count_)); }
  double least() const { return least_; }      ///< infinite without values
  double largest() const { return largest_; }  ///< the same, below 0

 private:
  static constexpr double nan = std::numeric_limits<double>::quiet_NaN();
  std::int64_t count_ = 0;
  double mean_ = 0.0;
  double squares_ = 0.0;
  double least_ = std::numeric_limits<double>::infinity();
  double largest_ = -std::numeric_limits<double>::infinity();
};

}  // namespace phytobench
