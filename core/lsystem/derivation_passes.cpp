// SPDX-License-Identifier: MIT
// The passes over the blocks of a word.
#include <algorithm>
#include <utility>

#include "core/lsystem/derivation.hpp"
#include "core/lsystem/production_choice.hpp"
#include "core/lsystem/symbol_histogram.hpp"

namespace phytobench {

void Derivation::Buffer::resize(std::size_t modules, std::size_t parameters) {
  resize_reused(word.symbols, symbol_room, modules);
  resize_reused(word.parameters, parameter_room, parameters + 1);
  word.parameters[parameters] = 0.0;
  word.parameters.resize_for_overwrite(parameters);
}

void Derivation::cut(std::size_t modules_per_block) {
  blocks_.clear();
  const std::size_t size = now_.word.size();
  for (std::size_t first = 0; first < size; first += modules_per_block) {
    blocks_.emplace_back();
    blocks_.back().first = first;
    blocks_.back().count = std::min(modules_per_block, size - first);
  }
  blocks_.emplace_back();
}

void Derivation::count_fixed(Block& block, const SymbolRun* runs) const {
  const SymbolHistogram counts = histogram_of(old_symbols(block));
  for (std::size_t s = 0; s < system_.symbols.size(); ++s) {
    block.modules += counts[s] * runs[s].count;
    block.parameters += counts[s] * table_.parameter_runs()[s].count;
    block.parameters_from += counts[s] * table_.arity(static_cast<SymbolIndex>(s));
  }
}

void Derivation::count_arities(Block& block) const {
  for (const SymbolIndex symbol : old_symbols(block)) block.parameters_from += table_.arity(symbol);
}

void Derivation::choose(Block& block, int step) {
  ProductionChoice choice(table_, context_ ? &*context_ : nullptr, options_.seed, step);
  std::vector<double> gathered(table_.most_parameters() + 1);
  const SymbolIndex* const symbols = now_.word.symbols.data();
  const double* parameters = now_.word.parameters.data() + block.parameters_from;
  for (std::size_t i = block.first; i < block.first + block.count; ++i) {
    const SymbolIndex symbol = symbols[i];
    const OutcomeIndex outcome =
        table_.has_choice(symbol)
            ? choice.outcome_of({i, symbol, parameters}, gathered.data(), block.unfit)
            : OutcomeIndex{symbol};
    if (outcome == no_outcome) {
      block.unfit_at = i;
      return;
    }
    outcomes_[i] = outcome;
    block.modules += table_.symbol_runs()[outcome].count;
    block.parameters += table_.parameter_runs()[outcome].count;
    parameters += table_.arity(symbol);
  }
  block.productions_tried = choice.productions_tried();
}

void Derivation::sum_old_parameters() {
  std::uint64_t sum = 0;
  for (Block& block : blocks_) sum += std::exchange(block.parameters_from, sum);
}

void Derivation::sum_new_lengths(int step) {
  WordLength sum;
  for (Block& block : blocks_) {
    sum.modules += std::exchange(block.modules, sum.modules);
    sum.parameters += std::exchange(block.parameters, sum.parameters);
  }
  refuse_if_longer(system_, sum, {options_.most_modules, options_.most_parameters}, step, step - 1);
  next_.resize(sum.modules, sum.parameters);
  note_work(sum);
}

void Derivation::note_work(const WordLength& written) {
  work_.modules_read += now_.word.size();
  work_.modules_written += written.modules;
  work_.parameters_written += written.parameters;
  for (const Block& block : blocks_) work_.productions_tried += block.productions_tried;
}

template <class Index>
void Derivation::write(std::size_t b, std::span<const Index> outcomes, const SymbolRun* runs,
                       int step) {
  Block& block = blocks_[b];
  const Block& behind = blocks_[b + 1];
  write_symbols(outcomes, runs,
                {next_.word.symbols.data() + block.modules, behind.modules - block.modules});
  if (!table_.is_parametric()) return;
  const std::span<double> out{next_.word.parameters.data() + block.parameters,
                              behind.parameters - block.parameters};
  std::vector<double> gathered;
  write_parameters(source(step, gathered), outcomes, block.first,
                   now_.word.parameters.data() + block.parameters_from, out);
  block.faulty = !all_finite(out);
}

ParameterSource Derivation::source(int step, std::vector<double>& gathered) const {
  ParameterSource source;
  source.table = &table_;
  source.seed = options_.seed;
  source.step = step;
  if (!context_) return source;
  gathered.assign(table_.most_parameters() + 1, 0.0);
  source.contexts = &*context_;
  source.gathered = gathered.data();
  return source;
}

std::span<const SymbolIndex> Derivation::old_symbols(const Block& block) const {
  return {now_.word.symbols.data() + block.first, block.count};
}

template void Derivation::write(std::size_t, std::span<const SymbolIndex>, const SymbolRun*, int);
template void Derivation::write(std::size_t, std::span<const OutcomeIndex>, const SymbolRun*, int);

}  // namespace phytobench
