// SPDX-License-Identifier: MIT
#include "core/record/record_from_json.hpp"

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"

namespace phytobench {

using nlohmann::ordered_json;

Record record_from(const ordered_json& line) {
  Record record{
      .experiment = line.at("experiment"), .measurement = line.at("measurement"), .value = {}};
  const ordered_json& value = line.at("value");
  if (value.is_number_integer())
    record.value = value.get<std::int64_t>();
  else if (value.is_number())
    record.value = value.get<double>();
  else if (value.is_string())
    record.value = value.get<std::string>();
  else
    throw InputError("measurement '" + record.measurement +
                     "' holds neither number nor text; run the experiments again");
  record.unit = line.at("unit");
  record.sample_size = line.at("n");
  if (line.contains("spread")) record.spread = line.at("spread").get<double>();
  if (line.contains("seed")) record.seed = line.at("seed").get<std::uint64_t>();
  return record;
}

TimingSample timing_from(const ordered_json& line) {
  TimingSample sample{.experiment = line.at("experiment"),
                      .measurement = line.at("measurement"),
                      .round = line.at("round"),
                      .position = line.at("position"),
                      .threads = line.at("threads")};
  if (line.contains("seconds")) {
    sample.value = line.at("seconds");
  } else {
    sample.value = line.at("value");
    sample.unit = line.at("unit");
  }
  if (!(sample.value > 0.0))
    throw InputError("a timing must be positive; run the experiments again");
  return sample;
}

}  // namespace phytobench
