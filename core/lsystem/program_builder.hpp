// SPDX-License-Identifier: MIT
#pragma once

#include <vector>

#include "core/lsystem/expression.hpp"
#include "core/lsystem/source_lines.hpp"

namespace phytobench {

/// Writes the postfix program of an expression while it is read, and computes what has no
/// parameters on the way. `place` is the offset in the line, for messages. Throws InputError if the
/// program would need too deep a stack, and for a part without parameters that is not finite.
class ProgramBuilder {
 public:
  explicit ProgramBuilder(const SourceLine& line) : line_(line) {}

  void add_constant(double value, std::size_t place);
  void add_parameter(std::size_t index, std::size_t place);
  void add_unary(Expression::Operation operation, std::size_t place);
  void add_binary(Expression::Operation operation, std::size_t place);
  /// The call of random() of that index, with low and high added before.
  void add_random(std::size_t index, std::size_t place);

  Expression finish() { return Expression(std::move(program_)); }

 private:
  bool ends_with_constants(std::size_t count) const;
  void push(Expression::Instruction instruction, std::size_t place);
  void fold(std::size_t instructions, std::size_t place);

  const SourceLine& line_;
  std::vector<Expression::Instruction> program_;
  std::size_t depth_ = 0;
};

}  // namespace phytobench
