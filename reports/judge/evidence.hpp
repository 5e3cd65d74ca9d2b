// SPDX-License-Identifier: MIT
#pragma once

#include <map>
#include <optional>
#include <string>
#include <vector>

#include "core/record/run_files.hpp"
#include "core/statistics/bootstrap.hpp"

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

  bool is_timing(const std::string& measurement) const { return timings_.contains(measurement); }

  /// Threads used by a timing (the largest, should they differ).
  std::int64_t threads(const std::string& measurement) const;

 private:
  std::map<std::string, RecordValue> records_;
  std::map<std::string, std::vector<TimingSample>> timings_;
};

/// An evidence value as it is shown: integers as such, reals with six significant digits.
std::string shown(const RecordValue& value);
std::string shown(double value);

/// Bounds as they are shown: "1 to 2", or, where rounding to the shown digits would move a bound by
/// more than a twentieth of what lies between, "1.2283742 ± 1e-06" with as many digits of the
/// centre as that half-width asks for; "= 1" where both are one number.
std::string shown_range(double low, double high);

}  // namespace phytobench
