// SPDX-License-Identifier: MIT
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "benchmarks/lsystem/derivation_case.hpp"
#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {

namespace {

constexpr const char* row_text =
    "axiom: A(1)\n"
    "A(x) < A(y) > A(z) -> A((x + y + z) / 3)\n";

std::vector<double> row_values(std::size_t count) {
  std::vector<double> values;
  for (std::size_t i = 0; i < count; ++i) values.push_back(static_cast<double>(i * i % 1'009));
  return values;
}

/// The same means in an array: equal bits, since the sums have the same order.
std::string objection_to_row(std::size_t count, int steps, const Word& word) {
  std::vector<double> values = row_values(count), next = values;
  for (int step = 0; step < steps; ++step) {
    for (std::size_t i = 1; i + 1 < count; ++i)
      next[i] = (values[i - 1] + values[i] + values[i + 1]) / 3;
    values = next;
  }
  if (word.size() != count || word.parameters.size() != count)
    return fmt::format("{} modules instead of {}", word.size(), count);
  for (std::size_t i = 0; i < count; ++i)
    if (word.parameters[i] != values[i])
      return fmt::format("module {} has {} instead of {}", i, word.parameters[i], values[i]);
  return "";
}

}  // namespace

DerivationCase row_derivation(std::size_t modules, int steps) {
  LSystem system = parse_lsystem(row_text, "row");
  const SymbolIndex symbol = system.axiom.front().symbol;
  system.axiom.clear();
  for (const double value : row_values(modules)) system.axiom.push_back({symbol, {value}});
  return {"row, parametric, contexts",
          row_text,
          std::move(system),
          steps,
          true,
          [modules, steps](const Word& word) { return objection_to_row(modules, steps, word); }};
}

}  // namespace phytobench
