// SPDX-License-Identifier: MIT
#include "core/record/record.hpp"

#include <cmath>

#include <nlohmann/json.hpp>

#include "core/contract/check.hpp"

namespace phytobench {

using nlohmann::ordered_json;

std::string_view name_of(Tier tier) {
  switch (tier) {
    case Tier::smoke:
      return "smoke";
    case Tier::quick:
      return "quick";
    case Tier::full:
      return "full";
  }
  return "unknown";
}

Tier tier_named(std::string_view name) {
  for (const Tier tier : {Tier::smoke, Tier::quick, Tier::full})
    if (name == name_of(tier)) return tier;
  throw InputError("unknown tier '" + std::string(name) + "'; use smoke, quick or full");
}

std::string to_json_line(const Record& record) {
  ordered_json line;
  line["experiment"] = record.experiment;
  line["measurement"] = record.measurement;
  // JSON has no NaN and would silently hold null.
  if (const double* number = std::get_if<double>(&record.value))
    PHYTOBENCH_EXPECT(std::isfinite(*number));
  std::visit([&line](const auto& value) { line["value"] = value; }, record.value);
  line["unit"] = record.unit;
  line["n"] = record.sample_size;
  if (record.spread) {
    PHYTOBENCH_EXPECT(std::isfinite(*record.spread));
    line["spread"] = *record.spread;
  }
  if (record.seed) line["seed"] = *record.seed;
  return line.dump();
}

std::string to_json_line(const TimingSample& sample) {
  PHYTOBENCH_EXPECT(std::isfinite(sample.value));
  ordered_json line;
  line["experiment"] = sample.experiment;
  line["measurement"] = sample.measurement;
  line["round"] = sample.round;
  line["position"] = sample.position;
  if (sample.unit == "s") {
    line["seconds"] = sample.value;
  } else {
    line["value"] = sample.value;
    line["unit"] = sample.unit;
  }
  line["threads"] = sample.threads;
  return line.dump();
}

}  // namespace phytobench
