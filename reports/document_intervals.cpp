// SPDX-License-Identifier: MIT
#include "reports/document_intervals.hpp"

#include <fmt/format.h>

#include "reports/document_numbers.hpp"

namespace phytobench {

std::string shown_ends(const MedianOfRounds& median, const std::string& low,
                       const std::string& high) {
  std::string text = fmt::format("{} to {}", low, high);
  if (median.is_only_range()) text += " in " + counted(median.rounds, "round");
  return text;
}

}  // namespace phytobench
