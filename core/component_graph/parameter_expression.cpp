// SPDX-License-Identifier: MIT
#include "core/component_graph/parameter_expression.hpp"

#include <algorithm>
#include <span>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "core/contract/errors.hpp"
#include "core/contract/parameter_keys.hpp"
#include "core/lsystem/expression_parser.hpp"

namespace phytobench {

namespace {

constexpr std::size_t longest_text = 2000;

enum class Randomness { allowed, refused };

/// The parser speaks of productions and constants, which do not exist here.
void refuse_unknown_names(LineScanner scanner, std::span<const std::string> names) {
  while (!scanner.at_end()) {
    if (scanner.take_number()) continue;
    const LineScanner before = scanner;
    const std::string_view name = scanner.take_name();
    if (name.empty()) {
      scanner.take_character();
    } else if (!scanner.next_is("(") && !is_function_name(name) &&
               std::find(names.begin(), names.end(), name) == names.end()) {
      before.fail(fmt::format("unknown name '{}'{}; known: {}", in_one_line(name, 40),
                              near_name(name, {names.begin(), names.end()}),
                              fmt::join(names, ", ")));
    }
  }
}

void check_text(std::string_view text, const std::string& where) {
  if (text.empty() || std::all_of(text.begin(), text.end(), is_blank))
    throw InputError(where + ": the function is empty; write one, or leave it out");
  if (text.size() > longest_text)
    throw InputError(fmt::format("{}: the function is longer than {} characters; shorten it", where,
                                 longest_text));
  // The scanner measures characters in UTF-8 and takes what is not for the end of the text.
  if (!std::all_of(text.begin(), text.end(),
                   [](char c) { return (c >= ' ' && c < 0x7f) || c == '\t'; }))
    throw InputError(where +
                     ": the function has a character that has no place in it; use ASCII "
                     "letters, digits and operators on one line");
}

Expression parse(std::string_view text, std::span<const std::string> names, Randomness randomness,
                 const std::string& where) {
  check_text(text, where);
  SourceLine line;
  line.name = "f";
  line.text = text;
  line.pieces.push_back({0, 1});
  int random_calls = 0;
  const Constants constants;
  ExpressionScope scope{.constants = constants};
  scope.parameters = names;
  if (randomness == Randomness::allowed) scope.random_calls = &random_calls;
  try {
    LineScanner scanner(line);
    refuse_unknown_names(scanner, names);
    Expression expression = parse_expression(scanner, scope);
    if (!scanner.at_end())
      scanner.fail(fmt::format("{} after the end of the function; join it by an operator",
                               scanner.next_shown()));
    return expression;
  } catch (const InputError& error) {
    constexpr std::string_view prefix = "f:1:";
    throw InputError(fmt::format("{}: in its function at column {}", where,
                                 std::string_view(error.what()).substr(prefix.size())));
  }
}

}  // namespace

Expression parse_parameter_function(std::string_view text, const std::string& where) {
  static const std::array<std::string, 5> names{"value", "i", "n", "depth", "t"};
  return parse(text, names, Randomness::allowed, where);
}

VectorField parse_vector_field(const std::array<std::string_view, 3>& texts,
                               const std::string& where) {
  static const std::array<std::string, 4> names{"x", "y", "z", "t"};
  std::array<Expression, 3> components;
  for (std::size_t i = 0; i < 3; ++i)
    components[i] = parse(texts[i], names, Randomness::refused, fmt::format("{}[{}]", where, i));
  return VectorField(std::move(components), where);
}

}  // namespace phytobench
