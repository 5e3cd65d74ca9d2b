// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <vector>

#include "core/lsystem/context_links.hpp"

namespace phytobench {

/// The contexts of a production, ready to be compared.
struct ContextPattern {
  enum class Kind : std::uint8_t { module, open, close };
  struct Element {
    Kind kind = Kind::module;
    SymbolIndex symbol = 0;
    std::uint8_t arity = 0;
    std::uint16_t first_parameter = 0;
    std::uint32_t to_partner = 0;  ///< of an opening bracket: elements from here to its partner
  };
  static constexpr std::size_t most_nested = 64;  ///< brackets within brackets

  std::vector<Element> left;   ///< nearest first
  std::vector<Element> right;  ///< nearest first
  Element predecessor;
  std::size_t parameter_count = 0;
};

/// Throws InputError with the production's place if brackets nest deeper than most_nested.
ContextPattern compiled_pattern(const LSystem& system, const Production& production);

/// Compares contexts with the surroundings of a module; see derive.hpp for what they mean. The
/// links must be those of the word.
class ContextMatch {
 public:
  ContextMatch(const ContextLinks& links, const Word& word)
      : links_(&links),
        symbols_(word.symbols.data()),
        size_(word.size()),
        parameters_(word.parameters.data()) {}

  /// Where gathered is not null and the pattern fits, it receives all parameters of the production:
  /// pattern.parameter_count numbers. If it does not fit, anything.
  bool fits(const ContextPattern& pattern, std::size_t position, double* gathered) const;

 private:
  using Element = ContextPattern::Element;
  static constexpr std::size_t nowhere = ~std::size_t{0};
  bool fits_left(const ContextPattern& pattern, std::size_t position, double* gathered) const;
  bool fits_right(const Element* element, const Element* end, std::size_t scan, std::uint32_t next,
                  double* gathered) const;
  std::size_t fitting_branch(const Element* open, const Element* close, std::size_t scan,
                             double* gathered) const;
  void gather(const Element& element, std::size_t position, double* gathered) const;

  const ContextLinks* links_;
  const SymbolIndex* symbols_;
  std::size_t size_;
  const double* parameters_;
};

}  // namespace phytobench
