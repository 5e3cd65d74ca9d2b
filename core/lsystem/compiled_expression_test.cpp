// SPDX-License-Identifier: MIT
#include "core/lsystem/compiled_expression.hpp"

#include <bit>
#include <cmath>
#include <limits>
#include <vector>

#include <gtest/gtest.h>

#include "core/lsystem/read_lsystem.hpp"

namespace phytobench {
namespace {

/// The expression over x and y that is written so.
Expression expression(const std::string& text) {
  const LSystem system = parse_lsystem("axiom: A(1, 2)\nA(x, y) -> B(" + text + ")", "test");
  return system.productions[0].successor[0].parameters[0];
}

std::uint64_t bits(double number) {
  // All that are no numbers count as one: their bits may depend on the order of operands.
  return std::isnan(number) ? 1u : std::bit_cast<std::uint64_t>(number);
}

const std::vector<double> numbers{0.0,
                                  -0.0,
                                  1.0,
                                  -1.0,
                                  0.1,
                                  3.0,
                                  -7.25,
                                  1e16,
                                  1e-16,
                                  -1e308,
                                  1e308,
                                  5e-324,
                                  0.30000000000000004,
                                  4.0,
                                  -4.0,
                                  1.0 / 3,
                                  1e-200,
                                  2.0};

TEST(CompiledExpressionLaw, GivesTheBitsOfItsProgram) {
  for (const char* text :
       {"0",     "-0",    "7",       "-2.5",      "x",        "y",      "-x",   "x+1",  "1+x",
        "x-0.1", "x*1.3", "3*y",     "x/2",       "x/3",      "2/x",    "x+y",  "x-y",  "y*x",
        "x/y",   "x<4",   "4<x",     "x<=4",      "x>y",      "x>=0.1", "x==4", "x!=y", "x%3",
        "x^2",   "2*x+1", "sqrt(x)", "x<4&&y>=2", "-(x+y)*2", "x+0",    "x*0"}) {
    const Expression plain = expression(text);
    const CompiledExpression compiled(plain);
    for (const double x : numbers)
      for (const double y : numbers) {
        const double parameters[] = {x, y};
        EXPECT_EQ(bits(compiled.evaluate(parameters, {})), bits(plain.evaluate(parameters)))
            << text << " at " << x << ", " << y;
      }
  }
}

TEST(CompiledExpression, KnowsLinearForms) {
  for (const char* text : {"7", "x", "x+1", "1+y", "x-2", "x*1.3", "3*y", "x/2", "-x"})
    EXPECT_NE(CompiledExpression(expression(text)).linear(), nullptr) << text;
  for (const char* text : {"x+y", "x<2", "2*x+1", "2/x", "sin(x)", "random(0, 1)"})
    EXPECT_EQ(CompiledExpression(expression(text)).linear(), nullptr) << text;
}

TEST(CompiledExpression, FindsShiftedParameters) {
  const double parameters[] = {10.0, 20.0, 30.0};
  for (const char* text : {"y", "y+1", "y*y", "y<25", "y^2+y"}) {
    const Expression plain = expression(text);
    EXPECT_EQ(CompiledExpression(plain, 1).evaluate(parameters + 1, {}), plain.evaluate(parameters))
        << text;
  }
}

TEST(CompiledExpression, DrawsTheSameRandomNumbers) {
  const Expression plain = expression("random(x, y) + random(0, 1)");
  const ExpressionRandom place{3, 5, 256};
  const double parameters[] = {1.0, 2.0};
  EXPECT_EQ(CompiledExpression(plain).evaluate(parameters, place),
            plain.evaluate(parameters, place));
  EXPECT_NE(plain.evaluate(parameters, place), plain.evaluate(parameters, {3, 5, 512}));
}

TEST(ReadsOutside, SeesParametersOfContexts) {
  const Expression both = expression("x + y");
  EXPECT_FALSE(reads_outside(both, 0, 2));
  EXPECT_TRUE(reads_outside(both, 0, 1));
  EXPECT_TRUE(reads_outside(both, 1, 1));
  EXPECT_FALSE(reads_outside(expression("3"), 0, 0));
}

}  // namespace
}  // namespace phytobench
