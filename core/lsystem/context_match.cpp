// SPDX-License-Identifier: MIT
#include "core/lsystem/context_match.hpp"

#include <algorithm>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/lsystem/derivation_errors.hpp"

namespace phytobench {

namespace {

ContextPattern::Element element_of(const LSystem& system, const PatternModule& module) {
  const Symbol& symbol = system.symbols[module.symbol];
  ContextPattern::Element element;
  element.symbol = module.symbol;
  element.arity = symbol.arity;
  element.first_parameter = module.first_parameter;
  if (is_opening_bracket(symbol)) element.kind = ContextPattern::Kind::open;
  if (is_closing_bracket(symbol)) element.kind = ContextPattern::Kind::close;
  return element;
}

void join_brackets(const LSystem& system, const Production& production,
                   std::vector<ContextPattern::Element>& elements) {
  std::vector<std::size_t> open;
  for (std::size_t i = 0; i < elements.size(); ++i) {
    if (elements[i].kind == ContextPattern::Kind::open) open.push_back(i);
    if (open.size() > ContextPattern::most_nested)
      throw InputError(
          fmt::format("{} nests more than {} brackets in its right context (name "
                      "fewer branches)",
                      name_of(system, production), ContextPattern::most_nested));
    if (elements[i].kind != ContextPattern::Kind::close) continue;
    PHYTOBENCH_EXPECT(!open.empty());
    elements[open.back()].to_partner = static_cast<std::uint32_t>(i - open.back());
    open.pop_back();
  }
  PHYTOBENCH_EXPECT(open.empty());
}

}  // namespace

ContextPattern compiled_pattern(const LSystem& system, const Production& production) {
  ContextPattern pattern;
  for (const PatternModule& module : production.left)
    pattern.left.push_back(element_of(system, module));
  std::reverse(pattern.left.begin(), pattern.left.end());
  for (const PatternModule& module : production.right)
    pattern.right.push_back(element_of(system, module));
  join_brackets(system, production, pattern.right);
  pattern.predecessor = element_of(system, production.predecessor);
  pattern.parameter_count = production.parameter_count;
  return pattern;
}

bool ContextMatch::fits(const ContextPattern& pattern, std::size_t position,
                        double* gathered) const {
  if (!fits_left(pattern, position, gathered)) return false;
  if (!pattern.right.empty() &&
      !fits_right(pattern.right.data(), pattern.right.data() + pattern.right.size(), position + 1,
                  links_->after(position), gathered))
    return false;
  gather(pattern.predecessor, position, gathered);
  return true;
}

bool ContextMatch::fits_left(const ContextPattern& pattern, std::size_t position,
                             double* gathered) const {
  std::size_t at = position;
  for (const Element& element : pattern.left) {
    at = links_->before(at);
    if (at == ContextLinks::none || symbols_[at] != element.symbol) return false;
    gather(element, at, gathered);
  }
  return true;
}

/// Branches are looked for from `scan` on; `next` is the next visible module after it.
bool ContextMatch::fits_right(const Element* element, const Element* end, std::size_t scan,
                              std::uint32_t next, double* gathered) const {
  for (; element != end; ++element) {
    if (element->kind == ContextPattern::Kind::open) {
      const Element* const close = element + element->to_partner;
      scan = fitting_branch(element, close, scan, gathered);
      if (scan == nowhere) return false;
      element = close;
    } else {
      if (next == ContextLinks::none || symbols_[next] != element->symbol) return false;
      gather(*element, next, gathered);
      scan = next + std::size_t{1};
      next = links_->after(next);
    }
  }
  return true;
}

/// Where to go on behind the first branch that begins with the pattern's; nowhere if there is none.
std::size_t ContextMatch::fitting_branch(const Element* open, const Element* close,
                                         std::size_t scan, double* gathered) const {
  while (scan < size_) {
    const ContextLinks::Sight sight = links_->sight(symbols_[scan]);
    if (sight == ContextLinks::Sight::ignored) {
      ++scan;
    } else if (sight == ContextLinks::Sight::open) {
      const std::size_t behind = links_->partner(scan) + std::size_t{1};
      if (fits_right(open + 1, close, scan + 1, links_->first_inside(scan), gathered))
        return behind;
      scan = behind;
    } else {
      return nowhere;
    }
  }
  return nowhere;
}

void ContextMatch::gather(const Element& element, std::size_t position, double* gathered) const {
  if (gathered == nullptr || element.arity == 0) return;
  std::copy_n(parameters_ + links_->parameters_from(position), element.arity,
              gathered + element.first_parameter);
}

}  // namespace phytobench
