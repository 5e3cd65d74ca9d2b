// SPDX-License-Identifier: MIT
// Systems that are raced, unless the user gives others.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <string_view>

#include "core/lsystem/lsystem.hpp"
#include "reference/oracles/lsystem_counts.hpp"

namespace phytobench {

struct BenchSystem {
  std::string_view name;
  std::string_view text;    ///< see read_lsystem.hpp
  int published_steps = 0;  ///< derivations with which others have timed it; 0: nobody has
};

/// Seven textbook curves and plants in the plane: right angles, sixths of a turn, fractions of
/// it; lines without branches and bushes; one letter and several.
std::span<const BenchSystem> bench_systems();

/// The seven systems of "Optimizing L-Systems" (Zucker 2020), which were timed with 50 to 168
/// million segments: a drawing of at most 2e8 segments takes as many derivations.
std::span<const BenchSystem> published_systems();

/// "koch_island, ..." of both, for messages.
std::string known_bench_system_names();

/// A system that is raced.
struct LSystemWorkload {
  std::string name;
  LSystem system;
  int steps = 0;
  std::uint64_t segments = 0;  ///< by the matrix of its letters
  std::uint64_t modules = 0;   ///< of the word, the same way
};

/// One of bench_systems() or published_systems(), or else a file, with as many derivations as draw
/// at most so many segments. Throws InputError if it is neither, if no engine could be judged on it
/// (see objection_to_streaming()), and if it draws nothing, or more than so many from the start.
LSystemWorkload lsystem_workload(const std::string& name_or_file, double segments);

/// The system's letters for the counting oracle; those with parameters as "F/1".
oracles::D0LStructure structure_of(const LSystem& system);

}  // namespace phytobench
