// SPDX-License-Identifier: MIT
// For tests: derivation as it is defined, module by module, with contexts that are looked for by
// walking along the word. No tables, no links, no blocks.
#pragma once

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "core/lsystem/derive.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

struct LiteralModule {
  SymbolIndex symbol = 0;
  std::vector<double> parameters;
};
using LiteralWord = std::vector<LiteralModule>;

class LiteralDerivation {
 public:
  LiteralDerivation(const LSystem& system, std::uint64_t seed) : system_(system), seed_(seed) {
    for (const AxiomModule& module : system.axiom)
      word_.push_back({module.symbol, module.parameters});
  }

  void step() {
    ++step_;
    LiteralWord next;
    for (std::size_t i = 0; i < word_.size(); ++i) replace(i, next);
    word_ = std::move(next);
  }

  const LiteralWord& word() const { return word_; }

 private:
  bool is(std::size_t i, const char* letter) const {
    return system_.symbols[word_[i].symbol].letter == letter;
  }
  bool is_unseen(std::size_t i) const { return system_.ignored[word_[i].symbol]; }
  bool is_pattern(const PatternModule& module, const char* letter) const {
    return system_.symbols[module.symbol].letter == letter;
  }

  void replace(std::size_t i, LiteralWord& next) const {
    std::vector<double> values;
    const Production* const production = chosen(i, values);
    if (production == nullptr) {
      next.push_back(word_[i]);
      return;
    }
    for (const SuccessorModule& made : production->successor) {
      next.push_back({made.symbol, {}});
      for (const Expression& expression : made.parameters)
        next.back().parameters.push_back(
            expression.evaluate(values.data(), random_place_of(seed_, step_, i)));
    }
  }

  const Production* chosen(std::size_t i, std::vector<double>& values) const {
    for (const bool with_context : {true, false})
      for (const Production& production : system_.productions) {
        const bool has_context = !production.left.empty() || !production.right.empty();
        if (has_context == with_context && fits(production, i, values)) return drawn(production, i);
      }
    return nullptr;
  }

  const Production* drawn(const Production& first, std::size_t i) const {
    if (!first.probability) return &first;
    const double unit = random_unit(seed_, 2 * static_cast<std::uint64_t>(step_), i);
    const Production* last = nullptr;
    double below = 0.0;
    for (const Production& production : system_.productions) {
      if (production.group != first.group) continue;
      last = &production;
      below += *production.probability;
      if (unit < below) break;
    }
    return last;
  }

  bool fits(const Production& production, std::size_t i, std::vector<double>& values) const {
    if (word_[i].symbol != production.predecessor.symbol) return false;
    values.assign(production.parameter_count + std::size_t{1}, 0.0);
    take(production.predecessor, i, values);
    if (!fits_left(production, i, values)) return false;
    if (!fits_right(production.right, 0, production.right.size(), i + 1, values)) return false;
    return !production.condition ||
           production.condition->evaluate(values.data(), random_place_of(seed_, step_, i)) != 0.0;
  }

  void take(const PatternModule& module, std::size_t i, std::vector<double>& values) const {
    for (std::size_t p = 0; p < word_[i].parameters.size(); ++p)
      values[module.first_parameter + p] = word_[i].parameters[p];
  }

  bool fits_left(const Production& production, std::size_t i, std::vector<double>& values) const {
    for (auto module = production.left.rbegin(); module != production.left.rend(); ++module) {
      const std::optional<std::size_t> seen = seen_to_the_left(i);
      if (!seen || word_[*seen].symbol != module->symbol) return false;
      take(*module, *seen, values);
      i = *seen;
    }
    return true;
  }

  /// Step by step towards the root; closed branches are counted, not looked at.
  std::optional<std::size_t> seen_to_the_left(std::size_t i) const {
    int closed = 0;
    while (i-- > 0) {
      if (is(i, "]")) ++closed;
      if (is(i, "[") && closed > 0) {
        --closed;
      } else if (closed == 0 && !is(i, "[") && !is_unseen(i)) {
        return i;
      }
    }
    return std::nullopt;
  }

  std::size_t behind_branch(std::size_t open) const {
    int depth = 0;
    do {
      if (is(open, "[")) ++depth;
      if (is(open, "]")) --depth;
      ++open;
    } while (depth > 0);
    return open;
  }

  std::size_t behind_pattern_branch(const std::vector<PatternModule>& pattern,
                                    std::size_t open) const {
    int depth = 0;
    do {
      if (is_pattern(pattern[open], "[")) ++depth;
      if (is_pattern(pattern[open], "]")) --depth;
      ++open;
    } while (depth > 0);
    return open;
  }

  /// Whether pattern[from, to) fits what stands at i.
  bool fits_right(const std::vector<PatternModule>& pattern, std::size_t from, std::size_t to,
                  std::size_t i, std::vector<double>& values) const {
    if (from == to) return true;
    if (i == word_.size() || is(i, "]")) return false;
    if (is_unseen(i)) return fits_right(pattern, from, to, i + 1, values);
    const bool wants_branch = is_pattern(pattern[from], "[");
    if (is(i, "[")) {
      if (wants_branch) {
        const std::size_t behind = behind_pattern_branch(pattern, from);
        if (fits_right(pattern, from + 1, behind - 1, i + 1, values))
          return fits_right(pattern, behind, to, behind_branch(i), values);
      }
      return fits_right(pattern, from, to, behind_branch(i), values);
    }
    if (wants_branch || word_[i].symbol != pattern[from].symbol) return false;
    take(pattern[from], i, values);
    return fits_right(pattern, from + 1, to, i + 1, values);
  }

  const LSystem& system_;
  std::uint64_t seed_;
  int step_ = 0;
  LiteralWord word_;
};

/// The same, as derive() returns it.
inline Word literal_word_of(const LSystem& system, int steps, std::uint64_t seed) {
  LiteralDerivation derivation(system, seed);
  for (int step = 0; step < steps; ++step) derivation.step();
  Word word;
  std::size_t parameters = 0;
  for (const LiteralModule& module : derivation.word()) parameters += module.parameters.size();
  word.symbols.resize_for_overwrite(derivation.word().size());
  word.parameters.resize_for_overwrite(parameters);
  double* to = word.parameters.data();
  for (std::size_t i = 0; i < word.size(); ++i) {
    word.symbols[i] = derivation.word()[i].symbol;
    for (const double parameter : derivation.word()[i].parameters) *to++ = parameter;
  }
  return word;
}

}  // namespace phytobench
