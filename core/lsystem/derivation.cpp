// SPDX-License-Identifier: MIT
#include "core/lsystem/derivation.hpp"

#include <algorithm>
#include <array>
#include <utility>

#include <fmt/format.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/composed_successors.hpp"
#include "core/lsystem/drawing.hpp"
#include "core/lsystem/growth_counter.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

constexpr std::size_t block_modules = 16384;
/// Between two pauses; some tens of milliseconds.
constexpr std::size_t blocks_per_wave = 256;

/// About a million modules are written for each block; where many steps fit, few grow much.
std::size_t block_modules_of(const ComposedSuccessors& successors) {
  if (successors.steps() > ComposedSuccessors::most_counted) return block_modules;
  return std::clamp(std::size_t{1 << 20} / (successors.longest() + 1), std::size_t{1},
                    block_modules);
}

}  // namespace

Derivation::Derivation(const LSystem& system, const DeriveOptions& options)
    : system_(system), options_(options), kind_(kind_of(system)), table_(system) {
  if (table_.is_contextual()) links_.emplace(system);
}

Word Derivation::run() {
  forecast();
  start();
  if (table_.is_fixed() && !table_.is_parametric() && !options_.each_word)
    run_composed();
  else
    run_step_by_step();
  if (options_.work != nullptr) *options_.work = work_;
  return std::move(now_.word);
}

void Derivation::run_step_by_step() {
  for (int step = 1; step <= options_.steps; ++step) {
    ask_go_on(step);
    if (table_.is_fixed())
      step_fixed(step, table_.symbol_runs(), block_modules);
    else
      step_chosen(step);
    finish_step(step);
  }
}

/// Refuses what would grow too long, and asks for all memory at once.
void Derivation::forecast() {
  const WordLength most{options_.most_modules, options_.most_parameters};
  GrowthCounter counter(system_);
  std::array<WordLength, 2> longest{};  // of even and of odd steps: each has its own memory
  for (int step = 0; step <= options_.steps; ++step) {
    if (step > 0) counter.advance();
    if (step % 4096 == 4095) ask_go_on(step);
    const WordLength length{counter.modules(), counter.parameters()};
    refuse_if_longer(system_, length, most, step, step - 1);
    if (!table_.is_fixed()) return;
    WordLength& longest_here = longest[static_cast<std::size_t>(step % 2)];
    longest_here.modules = std::max(longest_here.modules, length.modules);
    longest_here.parameters = std::max(longest_here.parameters, length.parameters);
  }
  if (!table_.is_parametric() && !options_.each_word) return;  // most words are never made
  now_.resize(longest[0].modules, longest[0].parameters);
  next_.resize(longest[1].modules, longest[1].parameters);
}

void Derivation::start() {
  const Word axiom = axiom_word(system_);
  now_.resize(axiom.size(), axiom.parameters.size());
  std::copy_n(axiom.symbols.data(), axiom.size(), now_.word.symbols.data());
  std::copy_n(axiom.parameters.data(), axiom.parameters.size(), now_.word.parameters.data());
  if (!all_finite({axiom.parameters.data(), axiom.parameters.size()}))
    throw InputError(fmt::format("{}: a parameter of the axiom is not a finite number (correct it)",
                                 system_.source));
  finish_step(0);
}

void Derivation::finish_step(int step) {
  if (kind_.queries) {
    answer_queries(system_, now_.word);
    if (!all_finite({now_.word.parameters.data(), now_.word.parameters.size()}))
      throw InputError(
          fmt::format("{}: after step {} the turtle is not at a finite place, so "
                      "queries have no answer (take fewer steps or shorter moves)",
                      system_.source, step));
  }
  if (options_.each_word) options_.each_word(step, now_.word);
}

/// Single steps while the word is short, then more and more at once.
void Derivation::run_composed() {
  struct Stretch {
    ComposedSuccessors successors;
    int times;
  };
  std::vector<Stretch> stretches;
  int rest = options_.steps;
  do {
    ComposedSuccessors successors(table_, system_.symbols.size(), rest);
    const int times = rest / successors.steps();
    rest %= successors.steps();
    stretches.push_back({std::move(successors), times});
  } while (rest >= ComposedSuccessors::most_counted);
  int step = 0;
  while (step < rest) {
    ask_go_on(++step);
    step_fixed(step, table_.symbol_runs(), block_modules);
  }
  for (; !stretches.empty(); stretches.pop_back()) {
    const auto& [successors, times] = stretches.back();
    for (int i = 0; i < times; ++i) {
      step += successors.steps();
      ask_go_on(step);
      step_fixed(step, successors.runs(), block_modules_of(successors));
    }
  }
}

void Derivation::step_fixed(int step, const SymbolRun* runs, std::size_t modules_per_block) {
  cut(modules_per_block);
  over_blocks(step, [&](std::size_t b) { count_fixed(blocks_[b], runs); });
  sum_old_parameters();
  sum_new_lengths(step);
  over_blocks(step, [&](std::size_t b) { write(b, old_symbols(blocks_[b]), runs, step); });
  std::swap(now_, next_);
}

void Derivation::step_chosen(int step) {
  cut(block_modules);
  outcomes_.resize(now_.word.size());
  if (links_) {
    links_->rebuild(now_.word);
    context_.emplace(*links_, now_.word);
  }
  if (table_.is_parametric()) {
    over_blocks(step, [&](std::size_t b) { count_arities(blocks_[b]); });
    sum_old_parameters();
  }
  over_blocks(step, [&](std::size_t b) { choose(blocks_[b], step); });
  sum_new_lengths(step);
  over_blocks(step, [&](std::size_t b) {
    const std::span<const OutcomeIndex> outcomes{outcomes_.data() + blocks_[b].first,
                                                 blocks_[b].count};
    write(b, outcomes, table_.symbol_runs(), step);
  });
  std::swap(now_, next_);
}

template <class Body>
void Derivation::over_blocks(int step, const Body& body) {
  const std::size_t count = blocks_.size() - 1;
  for (std::size_t first = 0; first < count; first += blocks_per_wave) {
    if (first > 0) ask_go_on(step);
    const std::size_t wave = std::min(blocks_per_wave, count - first);
    for_tasks(wave, options_.threads, [&](std::size_t i) { body(first + i); });
    refuse_faults(step, first, wave);
  }
}

void Derivation::ask_go_on(int step) const {
  if (options_.go_on && !options_.go_on(step)) throw Interrupted("the word is not finished");
}

}  // namespace phytobench
