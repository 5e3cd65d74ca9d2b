// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace phytobench {

/// Where a random number of an expression comes from: the n-th call of random() in a production is
/// random_unit(seed, stream, index + n), see random_place_of() in derive.hpp.
struct ExpressionRandom {
  std::uint64_t seed = 0;
  std::uint64_t stream = 0;
  std::uint64_t index = 0;
};

/// An arithmetic expression over the parameters of a production's predecessor and contexts
/// ([Liebemann2017] sec. 2.2.1), compiled to a postfix program. Truth is 1, falsehood 0; everything
/// else than 0 counts as true.
class Expression {
 public:
  enum class Operation : std::uint8_t {
    constant,   ///< pushes value
    parameter,  ///< pushes parameters[index]
    random,     ///< takes high and low, pushes a number in [low, high)
    negate,
    logical_not,
    add,
    subtract,
    multiply,
    divide,
    modulo,
    power,
    less,
    less_equal,
    greater,
    greater_equal,
    equal,
    not_equal,
    logical_and,
    logical_or,
    sine,
    cosine,
    tangent,
    arc_tangent,  ///< of and in degrees
    square_root,
    absolute,
    floor,
    ceiling,
    exponential,
    logarithm,
    minimum,
    maximum,
  };
  struct Instruction {
    Operation operation = Operation::constant;
    std::uint16_t index = 0;  ///< of the parameter, or of the call of random()
    double value = 0.0;       ///< of the constant
  };
  static constexpr std::size_t most_depth = 64;  ///< of the stack

  Expression() : Expression(0.0) {}
  explicit Expression(double constant);
  /// A valid postfix program that leaves one value and never holds more than most_depth.
  explicit Expression(std::vector<Instruction> program);

  /// `parameters` holds at least parameter_count() numbers, all finite. Not finite where the
  /// arithmetic is not (division by zero, root of a negative number): callers check. What is
  /// compared, chosen from or worked on further counts, too: 1 / 0 < 2 is not a number, and so is
  /// atan(1 / 0). But && and || ask their right side only where the left one does not decide, so
  /// that x > 0 && 1 / x < 2 is 0 for an x of 0.
  double evaluate(const double* parameters, const ExpressionRandom& random = {}) const;

  const std::vector<Instruction>& program() const { return program_; }
  bool uses_random() const { return uses_random_; }
  /// Greatest index of a parameter plus one; 0 for a constant expression.
  std::size_t parameter_count() const { return parameter_count_; }

  /// Forms that need no program: a constant c; p; p + c; p * c (p one parameter).
  enum class Form : std::uint8_t { constant, parameter, sum, product, general };
  Form form() const { return form_; }
  std::uint16_t form_parameter() const { return form_parameter_; }
  double form_constant() const { return form_constant_; }

 private:
  void find_form();
  template <bool strict>
  double run(const double* parameters, const ExpressionRandom& random) const;

  std::vector<Instruction> program_;
  std::size_t parameter_count_ = 0;
  bool uses_random_ = false;
  bool may_hide_ = false;  ///< some operation can make a finite number of one that is not
  Form form_ = Form::general;
  std::uint16_t form_parameter_ = 0;
  double form_constant_ = 0.0;
};

}  // namespace phytobench
