// SPDX-License-Identifier: MIT
// What `phytobench derive` finds out about a word and its drawing, and how it is shown: as text and
// as a document of phytobench/derive-1.
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "cli/commands.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/drawn_extent.hpp"
#include "reference/predicted_counts.hpp"

namespace phytobench::cli {

/// The drawing as a tree of [Liebemann2017] sec. 2.4.1.
struct DrawnTree {
  std::size_t nodes = 0;
  std::size_t tips = 0;
  std::size_t largest_degree = 0;  ///< children of a node
  std::size_t depth = 0;           ///< edges from the root to the deepest node
  double root_radius = 0.0;        ///< of the models
};

struct DeriveFindings {
  std::optional<PredictedSymbols> predicted;
  std::string not_predicted;                          ///< why, if they are not
  bool made = false;                                  ///< the word; else it was only counted
  std::optional<std::uint64_t> modules;               ///< up to 2^64 - 1
  std::vector<std::optional<std::uint64_t>> symbols;  ///< of each symbol, the same
  std::optional<int> longest_made;  ///< steps whose word is short enough, where this one is not
  std::uint64_t parameters = 0;     ///< of a word that was made
  std::string word_hash;            ///< the same
  std::optional<DrawnExtent> drawn;
  std::string not_drawn;  ///< why, if it is not
  std::optional<DrawnTree> tree;
  std::string no_tree;              ///< why, if it is none
  std::optional<std::string> word;  ///< the beginning of it, if that was asked for
  std::vector<std::string> files;   ///< that were written
};

/// Parameters of a word that is made, at most.
std::uint64_t most_parameters(const LSystemDeriveOptions& options);

/// Counts what the word will have, by core and by the oracle. Nothing is made. ContractViolation, a
/// bug of phytobench, if they differ.
DeriveFindings forecast_findings(const LSystem& system, const LSystemDeriveOptions& options);

/// Whether the forecast says that the word is longer than allowed.
bool is_too_long(const DeriveFindings& forecast);

/// A word too long to be made: its drawing, if it can be had without it.
void add_streamed_drawing(DeriveFindings& findings, const LSystem& system);

/// A word that was made; ContractViolation if it is not as predicted.
void add_word(DeriveFindings& findings, const LSystem& system, const Word& word);
void add_drawing(DeriveFindings& findings, const LSystem& system, const Word& word);

/// If the drawing is a connected tree that is not too large.
std::optional<TurtleTree> add_tree(DeriveFindings& findings, const LSystem& system,
                                   const Word& word);

/// The word as it is written, only the first modules.
std::string beginning_of(const LSystem& system, const Word& word, std::uint64_t modules);

std::string derive_json(const LSystem& system, const DeriveFindings& findings,
                        const LSystemDeriveOptions& options);
std::string derive_text(const LSystem& system, const DeriveFindings& findings,
                        const LSystemDeriveOptions& options);

}  // namespace phytobench::cli
