// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "core/lsystem/context_links.hpp"
#include "core/lsystem/derivation_errors.hpp"
#include "core/lsystem/derive.hpp"
#include "core/lsystem/production_table.hpp"
#include "core/lsystem/reused_memory.hpp"
#include "core/lsystem/successor_writer.hpp"

namespace phytobench {

/// The work of derive(): two words that take turns, and the memory between the passes of a step.
/// The old word is cut into blocks. Each block counts what it will become; sums of the counts say
/// where each writes; then each writes. Blocks do not depend on the number of threads, and no byte
/// depends on the blocks.
class Derivation {
 public:
  Derivation(const LSystem& system, const DeriveOptions& options);
  Word run();  ///< once

 private:
  struct Block {
    std::size_t first = 0, count = 0;           // modules of the old word
    std::uint64_t parameters_from = 0;          // of the old word; before the sums: how many
    std::uint64_t modules = 0, parameters = 0;  // where the new ones begin; before: how many
    bool faulty = false;                        // a parameter is not finite
    const Production* unfit = nullptr;          // has a condition without a finite value
    std::size_t unfit_at = 0;
    std::uint64_t productions_tried = 0;
  };
  /// A word that keeps its memory, with one more number behind its parameters, which is 0: where a
  /// symbol without parameters makes constants, they scale what comes next by 0.
  struct Buffer {
    Word word;
    std::size_t symbol_room = 0, parameter_room = 0;
    void resize(std::size_t modules, std::size_t parameters);
  };

  void forecast();
  void start();
  void finish_step(int step);
  void run_composed();
  void run_step_by_step();
  void step_fixed(int step, const SymbolRun* runs, std::size_t block_modules);
  void step_chosen(int step);

  void cut(std::size_t block_modules);
  void count_fixed(Block& block, const SymbolRun* runs) const;
  void count_arities(Block& block) const;
  void choose(Block& block, int step);
  void sum_old_parameters();
  void sum_new_lengths(int step);
  void note_work(const WordLength& written);
  template <class Index>
  void write(std::size_t b, std::span<const Index> outcomes, const SymbolRun* runs, int step);
  ParameterSource source(int step, std::vector<double>& gathered) const;
  std::span<const SymbolIndex> old_symbols(const Block& block) const;

  /// Runs body(index of a block) for all, with pauses in which faults and the user are heard.
  template <class Body>
  void over_blocks(int step, const Body& body);
  void ask_go_on(int step) const;
  void refuse_faults(int step, std::size_t first, std::size_t count) const;
  [[noreturn]] void refuse_parameters_of(const Block& block, int step) const;
  [[noreturn]] void refuse_condition_of(const Block& block, int step) const;
  DerivationPlace place(int step, std::size_t position, const double* parameters) const;

  const LSystem& system_;
  const DeriveOptions& options_;
  LSystemKind kind_;
  ProductionTable table_;
  std::optional<ContextLinks> links_;    // only with contexts
  std::optional<ContextMatch> context_;  // the same, of the old word
  Buffer now_, next_;
  std::vector<Block> blocks_;  // one more, whose sums are the totals
  ReusedMemory<OutcomeIndex> outcomes_;
  DerivationWork work_;
};

}  // namespace phytobench
