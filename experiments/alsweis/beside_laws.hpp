// SPDX-License-Identifier: MIT
// Samples beside the laws of a Poisson process. Deviations are given in standard errors that follow
// from the law, not from the sample.
#pragma once

#include <cmath>
#include <cstdint>
#include <string>
#include <vector>

#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

/// Moments of a law; `fourth` is about the mean and says how well a variance can be known.
struct Law {
  double mean;
  double variance;
  double fourth;
};

/// The i-th arrival of a process of unit rate.
Law gamma_law(double i);
Law poisson_law(double mean);
/// The distance of the i-th point at intensity 1: the root of a gamma variable over pi.
Law distance_law(double i);

struct Sample {
  std::string name;
  std::vector<double> values;
  std::string unit = "1";
};

void record_of_sample(ExperimentContext& context, const std::string& name, double value,
                      std::int64_t size, const std::string& unit = "1");

/// Mean and variance, and how far they are from the law's.
void record_moments(ExperimentContext& context, const Sample& sample, const Law& law);

/// Kolmogorov and Smirnov's test against the law of the i-th arrival.
void record_arrival_fit(ExperimentContext& context, const std::string& name, std::int64_t i,
                        std::vector<double> arrivals_of_i);

/// Moments of numbers beside Poisson's law, and Pearson's chi-square test.
void record_numbers(ExperimentContext& context, const Sample& counts, double mean);

/// Pearson's, from running sums.
class Correlation {
 public:
  void add(double x, double y) {
    n_ += 1.0;
    x_ += x;
    y_ += y;
    xx_ += x * x;
    yy_ += y * y;
    xy_ += x * y;
  }

  void record(ExperimentContext& context, const std::string& name) const {
    const double value =
        (n_ * xy_ - x_ * y_) / std::sqrt((n_ * xx_ - x_ * x_) * (n_ * yy_ - y_ * y_));
    const auto size = static_cast<std::int64_t>(n_);
    record_of_sample(context, name + "/correlation", value, size);
    record_of_sample(context, name + "/correlation_deviation", value * std::sqrt(n_), size,
                     "standard errors");
  }

 private:
  double n_ = 0.0, x_ = 0.0, y_ = 0.0, xx_ = 0.0, yy_ = 0.0, xy_ = 0.0;
};

/// Rayleigh's test: directions that prefer a side add up to a long vector.
class Directions {
 public:
  void add(double cosine, double sine) {
    cosines_ += cosine;
    sines_ += sine;
    ++count_;
  }

  void record(ExperimentContext& context, const std::string& name) const {
    const double squared = cosines_ * cosines_ + sines_ * sines_;
    record_of_sample(context, name + "/rayleigh_p_value",
                     std::exp(-squared / static_cast<double>(count_)), count_);
  }

 private:
  double cosines_ = 0.0, sines_ = 0.0;
  std::int64_t count_ = 0;
};

}  // namespace phytobench::experiments::alsweis
