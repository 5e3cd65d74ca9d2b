// SPDX-License-Identifier: MIT
#include "core/lsystem/context_links.hpp"

#include <fmt/format.h>

#include "core/contract/errors.hpp"

namespace phytobench {

bool is_opening_bracket(const Symbol& symbol) {
  return symbol.arity == 0 && symbol.letter == "[";
}

bool is_closing_bracket(const Symbol& symbol) {
  return symbol.arity == 0 && symbol.letter == "]";
}

ContextLinks::ContextLinks(const LSystem& system) : system_(&system) {
  for (std::size_t s = 0; s < system.symbols.size(); ++s) {
    arities_[s] = system.symbols[s].arity;
    parametric_ = parametric_ || arities_[s] > 0;
    if (is_opening_bracket(system.symbols[s]))
      sights_[s] = Sight::open;
    else if (is_closing_bracket(system.symbols[s]))
      sights_[s] = Sight::close;
    else if (s < system.ignored.size() && system.ignored[s])
      sights_[s] = Sight::ignored;
  }
}

void ContextLinks::rebuild(const Word& word) {
  if (word.size() >= none || word.parameters.size() >= none)
    throw InputError(
        fmt::format("{}: contexts reach over at most {} modules and as many "
                    "parameters (take fewer steps)",
                    system_->source, none - 1));
  before_.resize(word.size());
  after_.resize(word.size());
  link_to_the_left(word);
  link_to_the_right(word);
  if (parametric_) find_parameters(word);
}

void ContextLinks::link_to_the_left(const Word& word) {
  open_.clear();
  std::uint32_t seen = none;
  for (std::uint32_t i = 0; i < word.size(); ++i) {
    const Sight sight = sights_[word.symbols[i]];
    before_[i] = seen;
    if (sight == Sight::visible) {
      seen = i;
    } else if (sight == Sight::open) {
      open_.push_back(seen);
    } else if (sight == Sight::close) {
      if (open_.empty()) refuse_brackets();
      seen = open_.back();
      open_.pop_back();
    }
  }
  if (!open_.empty()) refuse_brackets();
}

/// From the end, so that an opening bracket knows its partner; overwrites before_ of those.
void ContextLinks::link_to_the_right(const Word& word) {
  open_.clear();
  std::uint32_t seen = none;
  for (auto i = static_cast<std::uint32_t>(word.size()); i-- > 0;) {
    const Sight sight = sights_[word.symbols[i]];
    after_[i] = seen;
    if (sight == Sight::visible) {
      seen = i;
    } else if (sight == Sight::close) {
      open_.push_back(seen);
      open_.push_back(i);
      seen = none;
    } else if (sight == Sight::open) {
      before_[i] = seen;
      after_[i] = open_.back();
      open_.pop_back();
      seen = open_.back();
      open_.pop_back();
    }
  }
}

void ContextLinks::find_parameters(const Word& word) {
  parameters_from_.resize(word.size());
  std::uint32_t from = 0;
  for (std::size_t i = 0; i < word.size(); ++i) {
    parameters_from_[i] = from;
    from += arities_[word.symbols[i]];
  }
}

void ContextLinks::refuse_brackets() const {
  throw InputError(
      fmt::format("{}: brackets of the derived word do not match, so contexts have no "
                  "meaning (do not replace brackets)",
                  system_->source));
}

}  // namespace phytobench
