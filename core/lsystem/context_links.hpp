// SPDX-License-Identifier: MIT
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/lsystem/reused_memory.hpp"
#include "core/lsystem/word.hpp"

namespace phytobench {

/// What a word looks like to contexts: for each module the ones that it sees to the left and to the
/// right, whatever lies between them, so that no search is as long as a branch. Ignored symbols and
/// brackets are seen by nobody but see others themselves.
class ContextLinks {
 public:
  static constexpr std::uint32_t none = 0xffffffff;
  enum class Sight : std::uint8_t { visible, ignored, open, close };

  explicit ContextLinks(const LSystem& system);

  /// Throws InputError if the word has 2^32 - 1 modules or more, or brackets that do not match (a
  /// production replaced one). Its memory is reused by the next call.
  void rebuild(const Word& word);

  /// The nearest visible module between i and the root, branches beside the path left out.
  std::uint32_t before(std::size_t i) const { return before_[i]; }
  /// The next visible module of the branch that i is in, branches that start between left out.
  std::uint32_t after(std::size_t i) const { return after_[i]; }
  /// Of an opening bracket: the first visible module in it, and its partner.
  std::uint32_t first_inside(std::size_t open) const { return before_[open]; }
  std::uint32_t partner(std::size_t open) const { return after_[open]; }
  /// Where the parameters of module i begin; only for systems with parameters.
  std::uint32_t parameters_from(std::size_t i) const { return parameters_from_[i]; }

  Sight sight(SymbolIndex symbol) const { return sights_[symbol]; }

 private:
  void link_to_the_left(const Word& word);
  void link_to_the_right(const Word& word);
  void find_parameters(const Word& word);
  [[noreturn]] void refuse_brackets() const;

  const LSystem* system_;
  bool parametric_ = false;
  std::array<Sight, most_symbols> sights_{};
  std::array<std::uint8_t, most_symbols> arities_{};
  ReusedMemory<std::uint32_t> before_, after_, parameters_from_;
  std::vector<std::uint32_t> open_;  // what was seen last before each bracket that is still open
};

bool is_opening_bracket(const Symbol& symbol);
bool is_closing_bracket(const Symbol& symbol);

}  // namespace phytobench
