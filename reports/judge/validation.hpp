// SPDX-License-Identifier: MIT
// Why the suite's own numbers may be believed: what a run measured of itself. Pure: from records
// and times to tables.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "core/record/run_files.hpp"
#include "core/statistics/estimate.hpp"
#include "core/statistics/median_interval.hpp"

namespace phytobench {

/// What one function answers on a data set with certified answers. Of several answers, such as all
/// coefficients of a polynomial, the one with the fewest digits.
struct CertifiedAnswer {
  std::string set;        ///< "num_acc_1"
  std::string statistic;  ///< "standard_deviation"
  std::string function;   ///< "running_moments"
  std::int64_t answers = 1;
  double certified = 0.0;
  double computed = 0.0;
  double digits = 0.0;                             ///< of agreement
  std::optional<double> reachable = std::nullopt;  ///< digits of exact arithmetic on the doubles
  bool is_counter_example = false;  ///< a formula that the suite does not use, to show it fail
  bool is_unused = false;           ///< a function that nothing else in the suite rests on
};

/// What one function answers where a closed form or an exact algorithm knows better.
struct ExactAnswer {
  std::string function;  ///< "f_tail"
  std::string question;  ///< "1_and_1_degree"
  std::string judge;     ///< the closed form
  std::int64_t values = 0;
  double digits = 0.0;  ///< the fewest
  double largest_difference = 0.0;
};

/// An interval of a median by the ranks of its ends.
struct RankedInterval {
  RankInterval ranks;
  double coverage = 0.0;  ///< exact, for independent values
};

/// Both 95 % intervals of the median of so many values.
struct IntervalRanks {
  std::int64_t values = 0;
  RankedInterval bootstrap;
  std::int64_t other_ends = 0;                                    ///< of `tried` bootstraps
  std::int64_t tried = 0;                                         ///< data sets
  std::optional<RankedInterval> order_statistics = std::nullopt;  ///< none for too few values
};

/// How often 95 % intervals held the truth in simulations.
struct SimulatedCoverage {
  std::string statistic;  ///< "median", "paired_ratio", "exponent"
  std::int64_t values = 0;
  std::string law;     ///< "lognormal"
  std::string method;  ///< "bootstrap", "order_statistics", "student"
  std::int64_t covered = 0;
  std::int64_t sets = 0;
  Estimate share;  ///< with its own 95 % interval, Clopper and Pearson's
};

/// A model beside an independent, literal transcription of the printed equations.
struct Transcription {
  std::string measurement;
  double difference = 0.0;  ///< the largest
  std::string unit;
};

/// The power of the step with which an error falls.
struct ObservedOrder {
  std::string measurement;
  double expected = 0.0;
  Estimate order;
};

/// What a computation should keep and how far it strays.
struct KeptQuantity {
  std::string measurement;
  double drift = 0.0;
};

/// Whether the rounds of times know of each other. Series of at least nine rounds.
struct RoundMemory {
  std::string experiment;
  std::int64_t series = 0;
  double median_correlation = 0.0;  ///< of a round with the next, of logarithms of times
  std::int64_t beyond = 0;          ///< series with more than 2 / sqrt(rounds), 5 % by chance
};

struct Validation {
  std::vector<CertifiedAnswer> certified;
  std::vector<ExactAnswer> exact;
  std::vector<Transcription> transcriptions;
  std::vector<ObservedOrder> orders;
  std::vector<KeptQuantity> kept;
  std::vector<IntervalRanks> ranks;
  std::vector<SimulatedCoverage> coverage;
  std::vector<RoundMemory> rounds;
  std::int64_t sampled_records = 0;  ///< that rest on more than one sample
  std::int64_t spread_records = 0;   ///< of those, with the spread of the sample

  /// Whether the run measured anything of the kind.
  bool any() const;
};

Validation validation_of(const RunContents& run);

/// Parts of it, for those who want no more.
std::vector<CertifiedAnswer> certified_answers(const RunContents& run);
std::vector<ExactAnswer> exact_answers(const RunContents& run);
std::vector<IntervalRanks> interval_ranks(const RunContents& run);
std::vector<SimulatedCoverage> simulated_coverage(const RunContents& run);
std::vector<Transcription> transcriptions(const RunContents& run);
std::vector<ObservedOrder> observed_orders(const RunContents& run);
std::vector<KeptQuantity> kept_quantities(const RunContents& run);
std::vector<RoundMemory> round_memories(const RunContents& run);

}  // namespace phytobench
