// SPDX-License-Identifier: MIT
// Words of letters with parameters: what the literal L-systems derive and the literal turtles read.
// Shares no code with core/, so that agreement means something.
#pragma once

#include <charconv>
#include <string>
#include <string_view>
#include <vector>

namespace phytobench::oracles {

// A(1, 2): a letter, which may have more than one character, and its parameters.
struct Module {
  std::string letter;
  std::vector<double> parameters;
  friend bool operator==(const Module&, const Module&) = default;
};
using ParametricWord = std::vector<Module>;

// The number in the fewest digits that give it back; 2 and not 2.0.
inline std::string text_of(double number) {
  char digits[64];
  const std::to_chars_result end = std::to_chars(digits, digits + sizeof digits, number);
  return std::string(digits, end.ptr);
}

// "A(2,2)B(1)".
inline std::string text_of(const ParametricWord& word) {
  std::string text;
  for (const Module& module : word) {
    text += module.letter;
    std::string separator = "(";
    for (const double parameter : module.parameters) {
      text += separator + text_of(parameter);
      separator = ",";
    }
    if (!module.parameters.empty()) text += ")";
  }
  return text;
}

// Every character but blanks becomes a module without parameters.
inline ParametricWord modules_of(std::string_view text) {
  ParametricWord word;
  for (const char character : text)
    if (character != ' ') word.push_back({std::string(1, character), {}});
  return word;
}

inline ParametricWord modules_of(const std::vector<std::string>& letters) {
  ParametricWord word;
  for (const std::string& letter : letters) word.push_back({letter, {}});
  return word;
}

}  // namespace phytobench::oracles
