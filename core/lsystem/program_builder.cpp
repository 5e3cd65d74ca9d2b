// SPDX-License-Identifier: MIT
#include "core/lsystem/program_builder.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace phytobench {

using Operation = Expression::Operation;

void ProgramBuilder::push(Expression::Instruction instruction, std::size_t place) {
  if (++depth_ > Expression::most_depth)
    line_.fail(place, fmt::format("the expression holds more than {} numbers at once; split it "
                                  "into constants",
                                  Expression::most_depth));
  program_.push_back(instruction);
}

void ProgramBuilder::add_constant(double value, std::size_t place) {
  push({Operation::constant, 0, value}, place);
}

void ProgramBuilder::add_parameter(std::size_t index, std::size_t place) {
  push({Operation::parameter, static_cast<std::uint16_t>(index), 0.0}, place);
}

bool ProgramBuilder::ends_with_constants(std::size_t count) const {
  return program_.size() >= count &&
         std::all_of(program_.end() - static_cast<long>(count), program_.end(),
                     [](const Expression::Instruction& instruction) {
                       return instruction.operation == Operation::constant;
                     });
}

/// In postfix the operand of an operation ends right before it: if that is a constant, it is all of
/// the operand.
void ProgramBuilder::fold(std::size_t instructions, std::size_t place) {
  const auto first = program_.end() - static_cast<long>(instructions);
  const double value =
      Expression(std::vector<Expression::Instruction>(first, program_.end())).evaluate(nullptr);
  if (!std::isfinite(value))
    line_.fail(place, fmt::format("this is {}, whatever the parameters are; look for a division by "
                                  "zero, or a root or logarithm of a negative number",
                                  std::isnan(value) ? "not a number" : "infinite"));
  program_.erase(first, program_.end());
  program_.push_back({Operation::constant, 0, value});
}

void ProgramBuilder::add_unary(Operation operation, std::size_t place) {
  const bool folds = ends_with_constants(1);
  program_.push_back({operation, 0, 0.0});
  if (folds) fold(2, place);
}

void ProgramBuilder::add_binary(Operation operation, std::size_t place) {
  const bool folds = ends_with_constants(2);
  --depth_;
  program_.push_back({operation, 0, 0.0});
  if (folds) fold(3, place);
}

void ProgramBuilder::add_random(std::size_t index, std::size_t place) {
  if (ends_with_constants(2) && !(program_.end()[-2].value <= program_.back().value))
    line_.fail(place, "random(low, high) needs low <= high; swap the two");
  --depth_;
  program_.push_back({Operation::random, static_cast<std::uint16_t>(index), 0.0});
}

}  // namespace phytobench
