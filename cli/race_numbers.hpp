// SPDX-License-Identifier: MIT
// Medians of a race's rounds as it prints them, alike for everything that is raced. In the
// documents of `phytobench/race-1`:
//   median_s, ratio  median over the rounds; a ratio pairs what was timed in the same round
//   ci95_s, ci95     from six rounds on the exact 95 % interval of that median, from the ranks
//                    of the rounds; of fewer rounds, which have no such interval, the smallest
//                    and the largest
//   rounds           how many there were, and so which of the two it is
#pragma once

#include <cstddef>
#include <string>

#include <nlohmann/json_fwd.hpp>

#include "core/statistics/median_of_rounds.hpp"

namespace phytobench::cli {

/// Sets `median_s`, `ci95_s` and `rounds`.
void put_seconds(nlohmann::ordered_json& json, const MedianOfRounds& seconds);

/// `slower`, `faster`, `ratio`, `ci95` and `rounds`.
nlohmann::ordered_json ratio_json(const std::string& slower, const std::string& faster,
                                  const MedianOfRounds& ratio);

/// Headings of a table on so many rounds, and the line that stands below the last table.
struct EndsInWords {
  std::string from;   ///< over lower ends: "95 % from", or "least"
  std::string ratio;  ///< over the two ends of a ratio: "95 %", or "least, most"
  std::string note;   ///< says what ends are where they are no interval, and is else empty
};

EndsInWords ends_in_words(std::size_t rounds);

}  // namespace phytobench::cli
