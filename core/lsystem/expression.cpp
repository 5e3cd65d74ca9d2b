// SPDX-License-Identifier: MIT
#include "core/lsystem/expression.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numbers>
#include <utility>

#include "core/contract/check.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {

namespace {

using Operation = Expression::Operation;
using Instruction = Expression::Instruction;

std::size_t operand_count(Operation operation) {
  switch (operation) {
    case Operation::constant:
    case Operation::parameter:
      return 0;
    case Operation::negate:
    case Operation::logical_not:
    case Operation::sine:
    case Operation::cosine:
    case Operation::tangent:
    case Operation::arc_tangent:
    case Operation::square_root:
    case Operation::absolute:
    case Operation::floor:
    case Operation::ceiling:
    case Operation::exponential:
    case Operation::logarithm:
      return 1;
    default:
      return 2;
  }
}

constexpr double radians_per_degree = std::numbers::pi / 180.0;

/// Sine of the angle `quarters` quarter turns further; exact at multiples of 90 degrees. Adding 0
/// turns -0 into 0.
double sine_of_degrees(double degrees, int quarters) {
  if (!std::isfinite(degrees)) return std::numeric_limits<double>::quiet_NaN();
  const double turn = std::remainder(degrees, 360.0);
  const double nearest = std::round(turn / 90.0);
  const double rest = (turn - nearest * 90.0) * radians_per_degree;
  switch ((static_cast<int>(nearest) + quarters + 4) % 4) {
    case 0:
      return std::sin(rest) + 0.0;
    case 1:
      return std::cos(rest);
    case 2:
      return 0.0 - std::sin(rest);
    default:
      return -std::cos(rest);
  }
}

double value_of(Operation operation, double a) {
  switch (operation) {
    case Operation::negate:
      return -a;
    case Operation::logical_not:
      return a == 0.0 ? 1.0 : 0.0;
    case Operation::sine:
      return sine_of_degrees(a, 0);
    case Operation::cosine:
      return sine_of_degrees(a, 1);
    case Operation::tangent:
      return sine_of_degrees(a, 0) / sine_of_degrees(a, 1);
    case Operation::arc_tangent:
      return std::atan(a) / radians_per_degree;
    case Operation::square_root:
      return std::sqrt(a);
    case Operation::absolute:
      return std::abs(a);
    case Operation::floor:
      return std::floor(a);
    case Operation::ceiling:
      return std::ceil(a);
    case Operation::exponential:
      return std::exp(a);
    default:
      return std::log(a);
  }
}

double truth(bool value) {
  return value ? 1.0 : 0.0;
}

double value_of(Operation operation, double a, double b) {
  switch (operation) {
    case Operation::add:
      return a + b;
    case Operation::subtract:
      return a - b;
    case Operation::multiply:
      return a * b;
    case Operation::divide:
      return a / b;
    case Operation::modulo:
      return std::fmod(a, b);
    case Operation::power:
      return std::pow(a, b);
    case Operation::less:
      return truth(a < b);
    case Operation::less_equal:
      return truth(a <= b);
    case Operation::greater:
      return truth(a > b);
    case Operation::greater_equal:
      return truth(a >= b);
    case Operation::equal:
      return truth(a == b);
    case Operation::not_equal:
      return truth(a != b);
    case Operation::logical_and:
      return truth(a != 0.0 && b != 0.0);
    case Operation::logical_or:
      return truth(a != 0.0 || b != 0.0);
    case Operation::minimum:
      return b < a ? b : a;
    default:
      return a < b ? b : a;
  }
}

bool is_leaf(Operation operation) {
  return operation == Operation::constant || operation == Operation::parameter;
}

/// Whether the operation may give a finite number where an operand is none.
bool may_hide(Operation operation) {
  switch (operation) {
    case Operation::add:
    case Operation::subtract:
    case Operation::multiply:
    case Operation::negate:
    case Operation::sine:
    case Operation::cosine:
    case Operation::tangent:
    case Operation::square_root:
    case Operation::absolute:
    case Operation::floor:
    case Operation::ceiling:
    case Operation::logarithm:
    case Operation::random:
      return false;
    default:
      return true;
  }
}

/// Not a number where an operand that counts is not finite.
double strict_value_of(Operation operation, double a, double b) {
  constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
  if (!std::isfinite(a)) return not_a_number;
  if (operation == Operation::logical_and && a == 0.0) return 0.0;
  if (operation == Operation::logical_or && a != 0.0) return 1.0;
  return std::isfinite(b) ? value_of(operation, a, b) : not_a_number;
}

double strict_value_of(Operation operation, double a) {
  return std::isfinite(a) ? value_of(operation, a) : std::numeric_limits<double>::quiet_NaN();
}

/// Below high even where the rounding of the sum would give high itself.
double random_between(double low, double high, double unit) {
  const double drawn = low + (high - low) * unit;
  return low < high && drawn >= high ? std::nextafter(high, low) : drawn;
}

}  // namespace

Expression::Expression(double constant)
    : Expression(std::vector<Instruction>{{Operation::constant, 0, constant}}) {}

Expression::Expression(std::vector<Instruction> program) : program_(std::move(program)) {
  std::size_t depth = 0;
  bool works_on_results = false;  // not on parameters and constants alone, which are finite
  for (const Instruction& step : program_) {
    const std::size_t operands = operand_count(step.operation);
    PHYTOBENCH_EXPECT(depth >= operands);
    may_hide_ =
        may_hide_ || (works_on_results && !is_leaf(step.operation) && may_hide(step.operation));
    works_on_results = works_on_results || operands > 0;
    depth += 1 - operands;
    PHYTOBENCH_EXPECT(depth <= most_depth);
    uses_random_ = uses_random_ || step.operation == Operation::random;
    if (step.operation == Operation::parameter)
      parameter_count_ = std::max(parameter_count_, step.index + std::size_t{1});
  }
  PHYTOBENCH_EXPECT(depth == 1);
  find_form();
}

double Expression::evaluate(const double* parameters, const ExpressionRandom& random) const {
  return may_hide_ ? run<true>(parameters, random) : run<false>(parameters, random);
}

template <bool strict>
double Expression::run(const double* parameters, const ExpressionRandom& random) const {
  std::array<double, most_depth> stack;
  stack[0] = 0.0;
  std::size_t size = 0;
  for (const Instruction& step : program_) {
    switch (operand_count(step.operation)) {
      case 0:
        stack[size++] = step.operation == Operation::constant ? step.value : parameters[step.index];
        break;
      case 1:
        stack[size - 1] = strict ? strict_value_of(step.operation, stack[size - 1])
                                 : value_of(step.operation, stack[size - 1]);
        break;
      default: {
        const double b = stack[--size];
        double& a = stack[size - 1];
        if (step.operation == Operation::random)
          a = random_between(a, b,
                             random_unit(random.seed, random.stream, random.index + step.index));
        else
          a = strict ? strict_value_of(step.operation, a, b) : value_of(step.operation, a, b);
      }
    }
  }
  return stack[0];
}

}  // namespace phytobench
