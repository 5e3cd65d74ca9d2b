// SPDX-License-Identifier: MIT
// Words of L-systems, derived, drawn and made up, for the experiments of every paper.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

#include "core/contract/errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/random/unit_stream.hpp"

namespace phytobench::experiments {

/// Whether the text is no L-system of the suite.
inline bool is_refused(std::string_view text) {
  try {
    parse_lsystem(text, "text");
  } catch (const InputError&) {
    return true;
  }
  return false;
}

inline Word derived(const LSystem& system, int steps, std::uint64_t seed = 0) {
  DeriveOptions options;
  options.steps = steps;
  options.seed = seed;
  return derive(system, options);
}

inline std::string word_after(const LSystem& system, int steps, std::uint64_t seed = 0) {
  return text_of(system, derived(system, steps, seed));
}

/// What the turtle draws along a word that nothing replaces.
inline Drawing drawn_word(const std::string& letters, double angle_deg) {
  LSystem system = parse_lsystem("axiom: " + letters + "\n", "word");
  system.turtle.angle_deg = angle_deg;
  return draw(system, axiom_word(system));
}

inline std::string random_letters(UnitStream& stream, std::string_view from, std::size_t count) {
  std::string letters;
  for (std::size_t i = 0; i < count; ++i)
    letters +=
        from[static_cast<std::size_t>(stream.next_unit() * static_cast<double>(from.size()))];
  return letters;
}

}  // namespace phytobench::experiments
