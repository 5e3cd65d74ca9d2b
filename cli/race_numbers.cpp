// SPDX-License-Identifier: MIT
#include "cli/race_numbers.hpp"

#include <fmt/format.h>
#include <nlohmann/json.hpp>

namespace phytobench::cli {

void put_seconds(nlohmann::ordered_json& json, const MedianOfRounds& seconds) {
  json["median_s"] = seconds.value;
  json["ci95_s"] = {seconds.low, seconds.high};
  json["rounds"] = seconds.rounds;
}

nlohmann::ordered_json ratio_json(const std::string& slower, const std::string& faster,
                                  const MedianOfRounds& ratio) {
  return {{"slower", slower},
          {"faster", faster},
          {"ratio", ratio.value},
          {"ci95", {ratio.low, ratio.high}},
          {"rounds", ratio.rounds}};
}

EndsInWords ends_in_words(std::size_t rounds) {
  if (rounds == 0 || rounds >= fewest_rounds) return {"95 % from", "95 %", ""};
  return {
      "least", "least, most",
      fmt::format("\nOf {} round{}, with the least and the most; an interval takes {} rounds.\n",
                  rounds, rounds == 1 ? "" : "s", fewest_rounds)};
}

}  // namespace phytobench::cli
