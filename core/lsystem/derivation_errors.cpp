// SPDX-License-Identifier: MIT
#include "core/lsystem/derivation_errors.hpp"

#include <limits>

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

std::string name_of(const LSystem& system, const Production& production) {
  const TextPlace& place = production.place;
  if (place.line == 0) return fmt::format("{}: {}", system.source, production.label);
  return fmt::format("{}:{}:{}: {}", system.source, place.line, place.column, production.label);
}

void refuse_parameter(const LSystem& system, const Production& production,
                      const DerivationPlace& place, const std::string& made) {
  throw InputError(fmt::format(
      "{} makes {} of {} (module {} of the word before step {}); a parameter must be a finite "
      "number: look for a division by zero, the root of a negative number or endless growth",
      name_of(system, production), made, place.module, place.position + 1, place.step));
}

void refuse_condition(const LSystem& system, const Production& production,
                      const DerivationPlace& place) {
  throw InputError(fmt::format(
      "{} has a condition without a finite value for {} (module {} of the word before step {}); "
      "look for a division by zero or the root of a negative number",
      name_of(system, production), place.module, place.position + 1, place.step));
}

void refuse_if_longer(const LSystem& system, const WordLength& length, const WordLength& most,
                      int step, int fitting_step) {
  if (length.modules <= most.modules && length.parameters <= most.parameters) return;
  const bool too_many_modules = length.modules > most.modules;
  const std::uint64_t number = too_many_modules ? length.modules : length.parameters;
  const std::string count = number == std::numeric_limits<std::uint64_t>::max()
                                ? "more than 1.8e19"
                                : fmt::format("{}", number);
  const std::string fits =
      fitting_step < 0 ? std::string("not even the axiom fits")
                       : fmt::format("{} is the greatest number of steps that fits", fitting_step);
  throw InputError(
      fmt::format("{}: the word of step {} would have {} {}, more than the {} allowed; "
                  "{} (take fewer steps or allow longer words)",
                  system.source, step, count, too_many_modules ? "modules" : "parameters",
                  too_many_modules ? most.modules : most.parameters, fits));
}

}  // namespace phytobench
