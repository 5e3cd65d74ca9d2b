// SPDX-License-Identifier: MIT
#include "core/lsystem/turtle_settings.hpp"

#include <array>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/contract/suggestion.hpp"

namespace phytobench {

namespace {

struct ConventionEntry {
  TurtleConvention convention;
  std::string_view name;
  TurtleSigns signs;
};

constexpr std::array conventions{
    ConventionEntry{TurtleConvention::words, "words", {1.0, 1.0, 1.0}},
    ConventionEntry{TurtleConvention::abop_matrices, "abop_matrices", {-1.0, -1.0, -1.0}},
    ConventionEntry{TurtleConvention::cpfg, "cpfg", {1.0, 1.0, -1.0}},
    ConventionEntry{TurtleConvention::lpfg_uncorrected, "lpfg_uncorrected", {1.0, -1.0, -1.0}},
};

const ConventionEntry& entry_of(TurtleConvention convention) {
  for (const ConventionEntry& entry : conventions)
    if (entry.convention == convention) return entry;
  contract_failed("expectation", "a known turtle convention", __FILE__, __LINE__);
}

}  // namespace

TurtleSigns signs_of(TurtleConvention convention) {
  return entry_of(convention).signs;
}

std::string_view name_of(TurtleConvention convention) {
  return entry_of(convention).name;
}

TurtleConvention turtle_convention_named(std::string_view name) {
  std::vector<std::string> known;
  for (const ConventionEntry& entry : conventions) {
    if (entry.name == name) return entry.convention;
    known.emplace_back(entry.name);
  }
  const std::string shown = in_one_line(name, 40);
  throw InputError(fmt::format("no turtle convention '{}'{}; give one of {}", shown,
                               did_you_mean(shown, known), fmt::join(known, ", ")));
}

}  // namespace phytobench
