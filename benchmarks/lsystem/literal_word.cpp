// SPDX-License-Identifier: MIT
#include "benchmarks/lsystem/literal_word.hpp"

#include <optional>
#include <span>
#include <vector>

#include <fmt/format.h>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

using Letters = std::vector<SymbolIndex>;

class LetterFollower {
 public:
  LetterFollower(const LSystem& system, const Word& word)
      : system_(system), word_(word), successors_(system.symbols.size()) {
    for (const Production& production : system.productions) {
      Letters& letters = successors_[production.predecessor.symbol].emplace();
      for (const SuccessorModule& module : production.successor) letters.push_back(module.symbol);
    }
  }

  std::string objection(int steps) {
    Letters axiom;
    for (const AxiomModule& module : system_.axiom) axiom.push_back(module.symbol);
    if (!fits(axiom, steps)) return objection_;
    if (at_ == word_.size()) return "";
    return fmt::format("{} modules instead of {}", word_.size(), at_);
  }

 private:
  bool fits(const Letters& letters, int steps) {
    for (const SymbolIndex letter : letters)
      if (steps > 0 && successors_[letter] ? !fits(*successors_[letter], steps - 1)
                                           : !stands_next(letter))
        return false;
    return true;
  }

  bool stands_next(SymbolIndex letter) {
    if (at_ == word_.size()) {
      objection_ = fmt::format("the word ends after {} modules", at_);
    } else if (word_.symbols[at_] != letter) {
      objection_ =
          fmt::format("module {} is {} instead of {}", at_,
                      system_.symbols[word_.symbols[at_]].letter, system_.symbols[letter].letter);
    } else {
      ++at_;
      return true;
    }
    return false;
  }

  const LSystem& system_;
  const Word& word_;
  std::vector<std::optional<Letters>> successors_;
  std::size_t at_ = 0;
  std::string objection_;
};

}  // namespace

std::string objection_to_letters(const LSystem& system, int steps, const Word& word) {
  PHYTOBENCH_EXPECT(kind_of(system).is_d0l());
  return LetterFollower(system, word).objection(steps);
}

}  // namespace phytobench
