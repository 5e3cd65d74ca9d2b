// SPDX-License-Identifier: MIT
#include "benchmarks/history/history_value.hpp"

#include <cmath>
#include <limits>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"

namespace phytobench {

namespace {

constexpr const char* counter_prefix = "counter:";

bool is_word(const std::string& name) {
  return !name.empty() && name.find_first_not_of(
                              "abcdefghijklmnopqrstuvwxyz"
                              "ABCDEFGHIJKLMNOPQRSTUVWXYZ"
                              "0123456789_-./") == std::string::npos;
}

}  // namespace

HistoryQuantity HistoryQuantity::counter(const std::string& name) {
  if (!is_word(name))
    throw InputError("counter '" + name + "': a name is of letters, digits and _-./");
  return HistoryQuantity(counter_prefix + name);
}

HistoryQuantity HistoryQuantity::named(const std::string& text) {
  if (text == "instructions") return instructions();
  if (text == "ratio") return ratio();
  const std::string prefix = counter_prefix;
  if (text.starts_with(prefix)) return counter(text.substr(prefix.size()));
  throw InputError("'" + text +
                   "' is no quantity of a history; use counter:NAME, instructions or ratio");
}

HistoryValue HistoryValue::counted(const std::string& benchmark, const std::string& inputs,
                                   const HistoryQuantity& quantity, std::uint64_t count) {
  PHYTOBENCH_EXPECT(!quantity.is_ratio());
  if (count > static_cast<std::uint64_t>(std::numeric_limits<std::int64_t>::max()))
    throw InputError(fmt::format("{} of '{}': {} is more than a history can hold", quantity.text(),
                                 benchmark, count));
  HistoryValue value(benchmark, inputs, quantity);
  value.count_ = static_cast<std::int64_t>(count);
  return value;
}

HistoryValue HistoryValue::ratio(const std::string& benchmark, const std::string& inputs,
                                 double ratio) {
  if (!(std::isfinite(ratio) && ratio > 0.0))
    throw InputError(fmt::format("ratio of '{}': {} is no positive number", benchmark, ratio));
  HistoryValue value(benchmark, inputs, HistoryQuantity::ratio());
  value.ratio_ = ratio;
  return value;
}

std::string HistoryValue::text() const {
  return quantity_.is_ratio() ? fmt::format("{:.6g}", ratio_) : fmt::format("{}", count_);
}

}  // namespace phytobench
