// SPDX-License-Identifier: MIT
// Which expressions need no program.
#include <cmath>

#include "core/lsystem/expression.hpp"

namespace phytobench {

namespace {

using Operation = Expression::Operation;

/// 1 / value, if multiplying by it gives the same bits as dividing by value.
double exact_reciprocal(double value) {
  int exponent = 0;
  const bool is_power_of_two =
      std::isfinite(value) && std::abs(std::frexp(value, &exponent)) == 0.5;
  return is_power_of_two && std::abs(exponent) < 1000 ? 1.0 / value : 0.0;
}

}  // namespace

void Expression::find_form() {
  const auto set = [this](Form form, std::uint16_t parameter, double constant) {
    form_ = form;
    form_parameter_ = parameter;
    form_constant_ = constant;
  };
  const Instruction& first = program_[0];
  if (program_.size() == 1)
    return first.operation == Operation::constant ? set(Form::constant, 0, first.value)
                                                  : set(Form::parameter, first.index, 0.0);
  if (program_.size() == 2 && first.operation == Operation::parameter &&
      program_[1].operation == Operation::negate)
    return set(Form::product, first.index, -1.0);
  if (program_.size() != 3) return;
  const Instruction& second = program_[1];
  const bool parameter_first =
      first.operation == Operation::parameter && second.operation == Operation::constant;
  const bool constant_first =
      first.operation == Operation::constant && second.operation == Operation::parameter;
  if (!parameter_first && !constant_first) return;
  const std::uint16_t parameter = parameter_first ? first.index : second.index;
  const double constant = parameter_first ? second.value : first.value;
  const Operation operation = program_[2].operation;
  if (operation == Operation::add) set(Form::sum, parameter, constant);
  if (operation == Operation::multiply) set(Form::product, parameter, constant);
  if (!parameter_first) return;
  if (operation == Operation::subtract) set(Form::sum, parameter, -constant);
  if (operation == Operation::divide && exact_reciprocal(constant) != 0.0)
    set(Form::product, parameter, exact_reciprocal(constant));
}

}  // namespace phytobench
