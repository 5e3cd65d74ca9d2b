// SPDX-License-Identifier: MIT
// What an experiment leaves behind. Experiments write these, the judge reads them; nothing else
// passes between the two.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

namespace phytobench {

using RecordValue = std::variant<std::int64_t, double, std::string>;

/// One measured value. Deterministic: the same seed gives the same bytes.
struct Record {
  std::string experiment;   ///< "brzoska2019/table-1"
  std::string measurement;  ///< "brzoska2019/table-1/euclid.s/edges"
  RecordValue value;
  std::string unit = "1";
  std::int64_t sample_size = 1;
  std::optional<double> spread = std::nullopt;       ///< standard deviation over the sample
  std::optional<std::uint64_t> seed = std::nullopt;  ///< of the random numbers behind the value
};

/// One raw sample of what is not the same in every run: a time, or memory. `round` counts
/// interleaved repetitions, `position` the place within the round.
struct TimingSample {
  std::string experiment;
  std::string measurement;
  std::int64_t round = 0;
  std::int64_t position = 0;
  double value = 0.0;
  std::int64_t threads = 1;
  std::string unit = "s";
};

enum class Tier { smoke, quick, full };

std::string_view name_of(Tier tier);

/// Throws InputError naming the three tiers.
Tier tier_named(std::string_view name);

/// One JSON object without line end. Throws ContractViolation for a value that is not finite.
std::string to_json_line(const Record& record);
std::string to_json_line(const TimingSample& sample);

}  // namespace phytobench
