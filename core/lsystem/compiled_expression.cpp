// SPDX-License-Identifier: MIT
#include "core/lsystem/compiled_expression.hpp"

#include <algorithm>
#include <cmath>
#include <vector>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

using Operation = Expression::Operation;
using Instruction = Expression::Instruction;

Expression shifted(const Expression& expression, std::uint16_t shift) {
  std::vector<Instruction> program = expression.program();
  for (Instruction& instruction : program) {
    if (instruction.operation != Operation::parameter) continue;
    PHYTOBENCH_EXPECT(instruction.index >= shift);
    instruction.index = static_cast<std::uint16_t>(instruction.index - shift);
  }
  return Expression(std::move(program));
}

bool is_leaf(const Instruction& instruction) {
  return instruction.operation == Operation::constant ||
         instruction.operation == Operation::parameter;
}

/// The operations that combined() knows.
bool is_plain(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::divide:
    case Operation::less:
    case Operation::less_equal:
    case Operation::greater:
    case Operation::greater_equal:
    case Operation::equal:
    case Operation::not_equal:
      return true;
    default:
      return false;
  }
}

/// What changes no number when it is added, not even -0.
constexpr double nothing = -0.0;

}  // namespace

CompiledExpression::CompiledExpression(const Expression& expression, std::uint16_t shift)
    : program_(shifted(expression, shift)) {
  if (find_linear())
    shape_ = Shape::linear;
  else if (find_binary())
    shape_ = Shape::binary;
}

bool CompiledExpression::find_linear() {
  const double constant = program_.form_constant();
  linear_.index = program_.form_parameter();
  switch (program_.form()) {
    case Expression::Form::constant:
      linear_ = {0.0, constant, 0};
      return !(constant == 0.0 && std::signbit(constant));  // 0 * p + -0 may be +0
    case Expression::Form::parameter:
      linear_ = {1.0, nothing, linear_.index};
      return true;
    case Expression::Form::sum:
      linear_ = {1.0, constant, linear_.index};
      return true;
    case Expression::Form::product:
      linear_ = {constant, nothing, linear_.index};
      return true;
    case Expression::Form::general:
      return false;
  }
  return false;
}

bool CompiledExpression::find_binary() {
  const std::vector<Instruction>& program = program_.program();
  if (program.size() != 3 || !is_leaf(program[0]) || !is_leaf(program[1]) ||
      !is_plain(program[2].operation))
    return false;
  operation_ = program[2].operation;
  left_ = operand_of(program[0]);
  right_ = operand_of(program[1]);
  return true;
}

CompiledExpression::Operand CompiledExpression::operand_of(const Instruction& instruction) {
  return {instruction.value, instruction.index, instruction.operation == Operation::constant};
}

bool reads_outside(const Expression& expression, std::size_t first, std::size_t count) {
  const std::vector<Instruction>& program = expression.program();
  return std::any_of(program.begin(), program.end(), [&](const Instruction& instruction) {
    return instruction.operation == Operation::parameter &&
           (instruction.index < first || instruction.index >= first + count);
  });
}

}  // namespace phytobench
