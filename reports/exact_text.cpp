// SPDX-License-Identifier: MIT
#include "reports/exact_text.hpp"

#include <fmt/format.h>

namespace phytobench {

std::string exact_text(double value) {
  return fmt::format("{}", value);
}

std::string exact_text(const RecordValue& value) {
  if (const auto* text = std::get_if<std::string>(&value)) return *text;
  if (const auto* whole = std::get_if<std::int64_t>(&value)) return std::to_string(*whole);
  return exact_text(std::get<double>(value));
}

}  // namespace phytobench
