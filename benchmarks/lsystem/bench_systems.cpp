// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/bench_systems.hpp"

#include <algorithm>
#include <array>
#include <filesystem>
#include <optional>
#include <system_error>
#include <vector>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/contract/suggestion.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/segment_stream.hpp"

namespace phytobench {

namespace {

constexpr auto own_bench_systems = std::to_array<BenchSystem>({
    {"koch_island",
     "axiom: F-F-F-F\n"
     "F -> F-F+F+FF-F-F+F\n"
     "angle: 90\n"},
    {"sierpinski_gasket",
     "axiom: A\n"
     "A -> B+A+B\n"
     "B -> A-B-A\n"
     "angle: 60\n"
     "draw: A B\n"},
    {"hilbert_curve",
     "axiom: A\n"
     "A -> +BF-AFA-FB+\n"
     "B -> -AF+BFB+FA-\n"
     "angle: 90\n"},
    {"dragon_curve",
     "axiom: FX\n"
     "X -> X+YF+\n"
     "Y -> -FX-Y\n"
     "angle: 90\n"},
    {"gosper_curve",
     "axiom: A\n"
     "A -> A-B--B+A++AA+B-\n"
     "B -> +A-BB--B-A++A+B\n"
     "angle: 60\n"
     "draw: A B\n"},
    {"bush",
     "axiom: F\n"
     "F -> F[+F]F[-F][F]\n"
     "angle: 20\n"},
    {"plant",
     "axiom: X\n"
     "X -> F-[[X]+X]+F[+FX]-X\n"
     "F -> FF\n"
     "angle: 22.5\n"},
});

struct Counts {
  std::uint64_t segments = 0;
  std::uint64_t modules = 0;
};

/// None if they are more than `most` segments, or no numbers of 64 bits.
std::optional<Counts> counts_after(const LSystem& system, const oracles::D0LStructure& structure,
                                   int steps, std::uint64_t most) {
  const oracles::LetterCounts counts = oracles::letter_counts(structure, steps);
  const auto segments = oracles::drawn_segments(counts, system.turtle.draws).in_64_bits();
  const auto modules = oracles::word_length(counts).in_64_bits();
  if (!segments || !modules || *segments > most) return std::nullopt;
  return Counts{*segments, *modules};
}

std::vector<BenchSystem> known_systems() {
  std::vector<BenchSystem> known(own_bench_systems.begin(), own_bench_systems.end());
  known.insert(known.end(), published_systems().begin(), published_systems().end());
  return known;
}

LSystem system_named(const std::string& name) {
  std::vector<std::string> known;
  for (const BenchSystem& system : known_systems()) {
    if (system.name == name) return parse_lsystem(system.text, name);
    known.emplace_back(system.name);
  }
  std::error_code unreadable;
  if (std::filesystem::exists(name, unreadable)) return read_lsystem(name);
  throw InputError("'" + name + "' is no file and no system to race" + did_you_mean(name, known) +
                   "; known: " + known_bench_system_names());
}

}  // namespace

std::span<const BenchSystem> bench_systems() {
  return own_bench_systems;
}

std::string known_bench_system_names() {
  std::string names;
  for (const BenchSystem& system : known_systems())
    names += (names.empty() ? "" : ", ") + std::string(system.name);
  return names;
}

oracles::D0LStructure structure_of(const LSystem& system) {
  const auto name = [&](SymbolIndex index) {
    const Symbol& symbol = system.symbols[index];
    return symbol.arity == 0 ? symbol.letter : fmt::format("{}/{}", symbol.letter, symbol.arity);
  };
  oracles::D0LStructure structure;
  for (const AxiomModule& module : system.axiom) structure.axiom.push_back(name(module.symbol));
  for (const Production& production : system.productions) {
    std::vector<std::string> successor;
    for (const SuccessorModule& module : production.successor)
      successor.push_back(name(module.symbol));
    structure.successors.emplace(name(production.predecessor.symbol), successor);
  }
  return structure;
}

LSystemWorkload lsystem_workload(const std::string& name_or_file, double segments) {
  LSystemWorkload workload;
  workload.name = name_or_file;
  workload.system = system_named(name_or_file);
  const std::string objection = objection_to_streaming(workload.system);
  if (!objection.empty())
    throw InputError(name_or_file + " " + objection +
                     "; only systems without parameters and choices are raced");
  const oracles::D0LStructure structure = structure_of(workload.system);
  const auto most = static_cast<std::uint64_t>(std::clamp(segments, 1.0, 1e18));
  constexpr int most_steps = 100;  // growth that takes longer is no growth to race on
  for (int steps = 0; steps <= most_steps; ++steps) {
    const auto counts = counts_after(workload.system, structure, steps, most);
    if (!counts) break;
    workload.steps = steps;
    workload.segments = counts->segments;
    workload.modules = counts->modules;
  }
  if (workload.segments == 0)
    throw InputError(
        fmt::format("{} draws nothing, or more than {} segments at once; give another system or "
                    "more --segments",
                    name_or_file, most));
  return workload;
}

}  // namespace phytobench
