// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "core/record/run_files.hpp"
#include "core/statistics/median_of_rounds.hpp"

namespace phytobench {

/// The records and timings of a run by measurement id.
class Evidence {
 public:
  explicit Evidence(const RunContents& run);

  bool has(const std::string& measurement) const;

  /// Text of a recorded value, or nothing for a timing or an unknown measurement.
  std::optional<RecordValue> recorded(const std::string& measurement) const;

  /// Recorded values whose names start with `prefix`.
  std::vector<RecordValue> recorded_below(const std::string& prefix) const;

  /// Samples in the order of rounds: one exact value for a record, all repetitions for a timing.
  std::vector<double> samples(const std::string& measurement) const;

  /// The timings by round; samples may be paired only within a round.
  std::map<std::int64_t, double> rounds(const std::string& measurement) const;

  /// Of a number that was recorded (exact, without rounds) or timed; nothing for anything else.
  std::optional<MedianOfRounds> median_of(const std::string& measurement) const;

  /// first / second: of two recorded numbers, or of times in the rounds that both have. Nothing
  /// without such rounds.
  std::optional<MedianOfRounds> ratio_of(const std::string& first, const std::string& second) const;

  bool is_timing(const std::string& measurement) const { return timings_.contains(measurement); }

  /// How many random values a recorded one sums up; 1 for a timing and what is not known.
  std::int64_t sample_size(const std::string& measurement) const;

  /// Threads used by a timing (the largest, should they differ).
  std::int64_t threads(const std::string& measurement) const;

 private:
  std::map<std::string, RecordValue> records_;
  std::map<std::string, std::int64_t> sample_sizes_;  ///< of those that sum up several
  std::map<std::string, std::vector<TimingSample>> timings_;
};

/// Significant digits of a real number where nothing asks for more.
inline constexpr int shown_digits = 6;

/// An evidence value as it is shown: integers as such, reals rounded.
std::string shown(const RecordValue& value, int digits = shown_digits);
std::string shown(double value, int digits = shown_digits);

/// The fewest digits, from `least` to 17, with which all numbers stand on their side of all bounds
/// that they differ from: a value that misses its bound must not look equal to it. Bounds are shown
/// with as many digits, but never fewer than `shown_digits`.
int digits_to_tell_apart(std::span<const double> numbers, std::span<const double> bounds,
                         int least = shown_digits);

/// Bounds as they are shown: "1 to 2", or, where rounding to the shown digits would move a bound by
/// more than a twentieth of what lies between, "1.2283742 ± 1e-06" with as many digits of the
/// centre as that half-width asks for; "= 1" where both are one number.
std::string shown_range(double low, double high, int digits = shown_digits);

}  // namespace phytobench
