// SPDX-License-Identifier: MIT
// Arithmetic as it is written in a text. Weakest first: ||, &&, == !=, < <= > >=, + -, * / %,
// signs and !, ^. Operators of one strength go from left to right, ^ from right to left;
// comparisons cannot be chained. Angles of sin, cos, tan and atan are degrees, log is natural, %
// has the sign of its left side.
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/lsystem/expression.hpp"
#include "core/lsystem/line_scanner.hpp"

namespace phytobench {

using Constants = std::map<std::string, double, std::less<>>;

/// How often a production may call random(): what derive() sets aside for it.
inline constexpr int most_random_calls = 256;
/// Brackets, signs and powers within each other.
inline constexpr int most_nesting = 64;

/// What the names of an expression stand for. A parameter hides a constant of its name.
struct ExpressionScope {
  const Constants& constants;
  std::span<const std::string> parameters = {};  ///< by their index
  int* random_calls = nullptr;  ///< counts the calls of random(); null: it has no place here
};

/// Reads as far as an expression goes. Parts without parameters are computed now. Throws InputError
/// with line and column: unknown name, wrong number of arguments, a part that is never finite,
/// nesting that is too deep.
Expression parse_expression(LineScanner& scanner, const ExpressionScope& scope);

/// An expression of constants.
double parse_constant(LineScanner& scanner, const Constants& constants);

bool is_function_name(std::string_view name);

/// did_you_mean() for names that are not absurdly long.
std::string near_name(std::string_view wrong, const std::vector<std::string>& known);

}  // namespace phytobench
