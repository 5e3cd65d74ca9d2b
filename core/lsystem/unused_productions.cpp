// SPDX-License-Identifier: MIT
#include "core/lsystem/unused_productions.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/lsystem/derivation_errors.hpp"

namespace phytobench {

namespace {

using Context = std::vector<PatternModule>;

bool is_same(const PatternModule& a, const PatternModule& b) {
  return a.symbol == b.symbol;
}

bool begins_with(const Context& whole, const Context& part) {
  return part.size() <= whole.size() &&
         std::equal(part.begin(), part.end(), whole.begin(), is_same);
}

bool ends_with(const Context& whole, const Context& part) {
  return part.size() <= whole.size() &&
         std::equal(part.rbegin(), part.rend(), whole.rbegin(), is_same);
}

std::string shown(const Symbol& symbol) {
  if (symbol.arity == 0) return fmt::format("'{}'", symbol.letter);
  return fmt::format("'{}' with {} parameter{}", symbol.letter, symbol.arity,
                     symbol.arity == 1 ? "" : "s");
}

class UnusedProductions {
 public:
  explicit UnusedProductions(const LSystem& system)
      : system_(system), occurs_(system.symbols.size(), false) {
    for (const AxiomModule& module : system.axiom) occurs_[module.symbol] = true;
    while (spread()) continue;
  }

  std::vector<std::string> lines() const {
    std::vector<std::string> lines;
    for (const Production& production : system_.productions) {
      std::string why = why_it_meets_nothing(production);
      if (why.empty()) why = why_it_comes_too_late(production);
      if (!why.empty())
        lines.push_back(fmt::format("{} is never used: {}", name_of(system_, production), why));
    }
    return lines;
  }

 private:
  bool meets(const Production& production) const {
    return !symbol_that_lacks(production).has_value();
  }

  /// The predecessor or a symbol of its contexts that occurs in no word.
  std::optional<SymbolIndex> symbol_that_lacks(const Production& production) const {
    if (!occurs_[production.predecessor.symbol]) return production.predecessor.symbol;
    for (const Context* context : {&production.left, &production.right})
      for (const PatternModule& module : *context)
        if (!occurs_[module.symbol]) return module.symbol;
    return std::nullopt;
  }

  /// To the successors of what occurs; whether there were more.
  bool spread() {
    bool more = false;
    for (const Production& production : system_.productions) {
      if (!meets(production)) continue;
      for (const SuccessorModule& module : production.successor) {
        more = more || !occurs_[module.symbol];
        occurs_[module.symbol] = true;
      }
    }
    return more;
  }

  std::string why_it_meets_nothing(const Production& production) const {
    const auto lacking = symbol_that_lacks(production);
    if (!lacking) return "";
    const Symbol& symbol = system_.symbols[*lacking];
    std::string others;
    for (std::size_t s = 0; s < system_.symbols.size(); ++s)
      if (occurs_[s] && system_.symbols[s].letter == symbol.letter)
        others = fmt::format(" ({} does)", shown(system_.symbols[s]));
    return fmt::format(
        "{} comes neither in the axiom nor from it{}; correct its letter or number of parameters, "
        "or remove the production",
        shown(symbol), others);
  }

  std::string why_it_comes_too_late(const Production& production) const {
    if (!has_context(production)) return "";  // the reader refuses them
    for (const Production& earlier : system_.productions) {
      if (&earlier == &production) return "";
      if (earlier.predecessor.symbol == production.predecessor.symbol && has_context(earlier) &&
          !earlier.condition && earlier.group != production.group &&
          ends_with(production.left, earlier.left) && begins_with(production.right, earlier.right))
        return fmt::format(
            "{} in line {} has no condition and fits wherever it would; move this one above it",
            earlier.label, earlier.place.line);
    }
    return "";
  }

  const LSystem& system_;
  std::vector<bool> occurs_;  ///< per symbol, in some word
};

}  // namespace

std::vector<std::string> unused_productions(const LSystem& system) {
  return UnusedProductions(system).lines();
}

}  // namespace phytobench
