// SPDX-License-Identifier: MIT
#include "core/lsystem/module_text.hpp"

#include <array>
#include <charconv>

namespace phytobench {

void append_module(std::string& text, const Symbol& symbol, const double* parameters) {
  text += symbol.letter;
  if (symbol.arity == 0) return;
  std::array<char, 32> digits;  // the longest double has 24 characters
  for (std::size_t i = 0; i < symbol.arity; ++i) {
    text += i == 0 ? '(' : ',';
    const auto written = std::to_chars(digits.data(), digits.data() + digits.size(), parameters[i]);
    text.append(digits.data(), written.ptr);
  }
  text += ')';
}

std::string module_text(const Symbol& symbol, const double* parameters) {
  std::string text;
  append_module(text, symbol, parameters);
  return text;
}

}  // namespace phytobench
