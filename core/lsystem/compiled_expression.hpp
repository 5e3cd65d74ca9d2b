// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <optional>

#include "core/lsystem/expression.hpp"

namespace phytobench {

/// scale * parameters[index] + offset, each operation rounded. All forms of Expression::Form but
/// the general one come down to it without a change of a bit, so that a successor of such
/// parameters is written without a branch. Constants scale parameters[0] by 0.
struct LinearParameter {
  double scale = 0.0;
  double offset = 0.0;
  std::size_t index = 0;

  double value(const double* parameters) const { return parameters[index] * scale + offset; }
};

/// An expression made ready for the inner loop: one operation between parameters and constants is
/// worked out in place, the rest by its program. Gives the numbers of Expression::evaluate(), bit
/// for bit.
class CompiledExpression {
 public:
  /// Parameter i of the expression will be found at parameters[i - shift].
  explicit CompiledExpression(const Expression& expression, std::uint16_t shift = 0);

  /// parameters[0] is there and finite even if the expression has no parameter.
  double evaluate(const double* parameters, const ExpressionRandom& random) const {
    if (shape_ == Shape::linear) return linear_.value(parameters);
    if (shape_ == Shape::program) return program_.evaluate(parameters, random);
    return combined(left_.value(parameters), right_.value(parameters));
  }

  /// Null if it is not of that form.
  const LinearParameter* linear() const { return shape_ == Shape::linear ? &linear_ : nullptr; }

 private:
  enum class Shape : std::uint8_t { linear, binary, program };
  struct Operand {
    double constant = 0.0;
    std::uint16_t index = 0;
    bool is_constant = false;

    double value(const double* parameters) const {
      return is_constant ? constant : parameters[index];
    }
  };
  static Operand operand_of(const Expression::Instruction& instruction);
  bool find_linear();
  bool find_binary();

  double combined(double a, double b) const {
    using Operation = Expression::Operation;
    switch (operation_) {
      case Operation::add:
        return a + b;
      case Operation::subtract:
        return a - b;
      case Operation::multiply:
        return a * b;
      case Operation::divide:
        return a / b;
      case Operation::less:
        return a < b ? 1.0 : 0.0;
      case Operation::less_equal:
        return a <= b ? 1.0 : 0.0;
      case Operation::greater:
        return a > b ? 1.0 : 0.0;
      case Operation::greater_equal:
        return a >= b ? 1.0 : 0.0;
      case Operation::equal:
        return a == b ? 1.0 : 0.0;
      default:
        return a != b ? 1.0 : 0.0;
    }
  }

  Shape shape_ = Shape::program;
  Expression::Operation operation_ = Expression::Operation::add;
  LinearParameter linear_;
  Operand left_, right_;
  Expression program_;
};

/// Whether the expression asks for a parameter outside [first, first + count).
bool reads_outside(const Expression& expression, std::size_t first, std::size_t count);

}  // namespace phytobench
