// SPDX-License-Identifier: MIT
#include "core/lsystem/expression.hpp"

#include <cmath>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/expression_parser.hpp"
#include "core/random/counter_stream.hpp"

namespace phytobench {
namespace {

using Form = Expression::Form;
using Operation = Expression::Operation;

const std::vector<std::string> names{"x", "y", "l"};

Expression expression_of(const std::string& text, const Constants& constants = {}) {
  const SourceLine line{"test", text, {{0, 1}}};
  LineScanner scanner(line);
  int calls = 0;
  Expression expression = parse_expression(
      scanner, {.constants = constants, .parameters = names, .random_calls = &calls});
  if (!scanner.at_end()) scanner.fail("rest");
  return expression;
}

double value(const std::string& text, double x = 0.0, double y = 0.0) {
  const double parameters[] = {x, y, 0.0};
  return expression_of(text).evaluate(parameters);
}

std::string error_of(const std::string& text) {
  try {
    expression_of(text);
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

void expect_error(const std::string& text, const std::string& part) {
  EXPECT_NE(error_of(text).find(part), std::string::npos) << text << " gives " << error_of(text);
}

TEST(Expression, HasTheUsualPrecedence) {
  EXPECT_EQ(value("1+2*3"), 7.0);  // [Liebemann2017] sec. 4.2.1
  EXPECT_EQ(value("(1+2)*3"), 9.0);
  EXPECT_EQ(value("10 - 4 - 3"), 3.0);
  EXPECT_EQ(value("16 / 4 / 2"), 2.0);
  EXPECT_EQ(value("2^3^2"), 512.0);
  EXPECT_EQ(value("-2^2"), -4.0);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2 * -3"), -6.0);
  EXPECT_EQ(value("--3"), 3.0);
  EXPECT_EQ(value("7 % 4 * 2"), 6.0);
  EXPECT_EQ(value("-7 % 4"), -3.0);
  EXPECT_EQ(value("1 + 1 == 2"), 1.0);
  EXPECT_EQ(value("!0 + 1"), 2.0);
  EXPECT_EQ(value("1 || 0 && 0"), 1.0);
  EXPECT_EQ(value("1 < 2 == 1"), 1.0);
}

TEST(Expression, DoesTheSameWithParametersAsWithNumbers) {
  for (const double x : {-2.5, 0.0, 3.0})
    for (const double y : {-1.0, 0.5, 4.0}) {
      EXPECT_EQ(value("x + y * x - y / 4", x, y), x + y * x - y / 4.0);
      EXPECT_EQ(value("x < y", x, y), x < y ? 1.0 : 0.0);
      EXPECT_EQ(value("x <= y && !(x >= y)", x, y), x < y ? 1.0 : 0.0);
      EXPECT_EQ(value("x > y || x == y", x, y), x >= y ? 1.0 : 0.0);
      EXPECT_EQ(value("x != y", x, y), x != y ? 1.0 : 0.0);
      EXPECT_EQ(value("min(x, y) + max(x, y)", x, y), x + y);
      EXPECT_EQ(value("abs(x) - floor(y) + ceil(y)", x, y),
                std::abs(x) - std::floor(y) + std::ceil(y));
      EXPECT_EQ(value("exp(x) + sqrt(y * y) + x ^ 2", x, y), std::exp(x) + std::abs(y) + x * x);
    }
  EXPECT_EQ(value("log(x)", 1.0), 0.0);
  EXPECT_EQ(value("x % y", 7.5, 2.0), 1.5);
}

TEST(Expression, TakesEverythingButZeroForTrue) {
  EXPECT_EQ(value("x && y", -3.0, 0.5), 1.0);
  EXPECT_EQ(value("x || y", 0.0, 0.0), 0.0);
  EXPECT_EQ(value("!x", 0.25), 0.0);
}

TEST(Expression, IsExactAtQuarterTurns) {
  const double sines[] = {0.0, 1.0, 0.0, -1.0};
  for (int quarter = -8; quarter <= 8; ++quarter) {
    const double degrees = 90.0 * quarter;
    EXPECT_EQ(value("sin(x)", degrees), sines[(quarter + 8) % 4]);
    EXPECT_EQ(value("cos(x)", degrees), sines[(quarter + 9) % 4]);
    EXPECT_FALSE(std::signbit(value("sin(x)", degrees)) && quarter % 2 == 0);
  }
}

TEST(ExpressionLaw, SineAndCosineLieOnTheCircle) {
  constexpr double rounding = 4e-16;
  for (double degrees = -719.9; degrees <= 720.0; degrees += 0.7123) {
    const double sine = value("sin(x)", degrees), cosine = value("cos(x)", degrees);
    EXPECT_NEAR(sine * sine + cosine * cosine, 1.0, rounding);
    EXPECT_NEAR(value("cos(x - 90)", degrees), sine, 1e-14);
    EXPECT_NEAR(value("tan(x)", degrees) * cosine, sine, rounding);
    EXPECT_NEAR(sine, std::sin(degrees * std::acos(-1.0) / 180.0), 1e-14);
  }
  EXPECT_NEAR(value("atan(1)"), 45.0, 1e-14);
}

TEST(Expression, IsNotFiniteWhereTheArithmeticIsNot) {
  EXPECT_TRUE(std::isinf(value("1 / x", 0.0)));
  EXPECT_TRUE(std::isnan(value("sqrt(x)", -1.0)));
  EXPECT_TRUE(std::isnan(value("sin(x)", INFINITY)));
}

/// What would be lost in a comparison, a choice, a truth or a further operation.
TEST(Expression, IsNotFiniteWhereAPartOfItIsNot) {
  for (const char* text :
       {"1 / x < 2", "1 / x > 2", "2 == 1 / x", "1 / x != 1", "!(1 / x)", "min(1 / x, 2)",
        "max(2, sqrt(x - 1))", "2 / (1 / x)", "atan(1 / x)", "exp(log(x))", "5 % (1 / x)",
        "(1 / x) ^ 0", "x * 1e200 < 1 / x", "1 / x && 1", "1 / x || 1", "x == 0 && 1 / x > 2",
        "x != 0 || 1 / x > 2", "1 / x > 2 && x != 0"})
    EXPECT_FALSE(std::isfinite(value(text, 0.0))) << text;
  EXPECT_TRUE(std::isnan(value("x * x > 1", 1e200)));
}

TEST(Expression, AsksTheRightSideOfAndAndOrOnlyWhereItDecides) {
  EXPECT_EQ(value("x != 0 && 1 / x > 2", 0.0), 0.0);
  EXPECT_EQ(value("x == 0 || 1 / x > 2", 0.0), 1.0);
  EXPECT_EQ(value("!(x != 0 && 1 / x > 2)", 0.0), 1.0);
  EXPECT_EQ(value("x != 0 && 1 / x > 2", 0.25), 1.0);
  EXPECT_EQ(value("x == 0 || 1 / x > 2", 4.0), 0.0);
  EXPECT_EQ(value("2 / (1 / x)", 4.0), 8.0);
}

TEST(Expression, FindsFormsThatNeedNoProgram) {
  EXPECT_EQ(expression_of("2 * 3 + 1").form(), Form::constant);
  EXPECT_EQ(expression_of("2 * 3 + 1").form_constant(), 7.0);
  EXPECT_EQ(expression_of("y").form(), Form::parameter);
  EXPECT_EQ(expression_of("y").form_parameter(), 1);
  EXPECT_EQ(expression_of("y + 2").form(), Form::sum);
  EXPECT_EQ(expression_of("y - 2").form_constant(), -2.0);
  EXPECT_EQ(expression_of("2 * y").form(), Form::product);
  EXPECT_EQ(expression_of("-y").form_constant(), -1.0);
  EXPECT_EQ(expression_of("l * lr", {{"lr", 1.3}}).form_constant(), 1.3);
  EXPECT_EQ(expression_of("y / 4").form_constant(), 0.25);
  EXPECT_EQ(expression_of("y / 3").form(), Form::general);
  EXPECT_EQ(expression_of("2 - y").form(), Form::general);
  EXPECT_EQ(expression_of("x + y").form(), Form::general);
}

TEST(ExpressionLaw, FormsGiveTheBitsOfTheProgram) {
  for (const char* text : {"y", "y + 0.1", "0.1 + y", "y - 0.1", "y * 0.1", "0.1 * y", "y / 8",
                           "y / -0.25", "-y", "0.1"}) {
    const Expression expression = expression_of(text);
    ASSERT_NE(expression.form(), Form::general) << text;
    for (const double y : {0.0, 0.3, -7.1, 1e300, 5e-324}) {
      const double parameters[] = {99.0, y, 99.0};
      const double c = expression.form_constant(), p = parameters[expression.form_parameter()];
      const double by_form = expression.form() == Form::constant    ? c
                             : expression.form() == Form::parameter ? p
                             : expression.form() == Form::sum       ? p + c
                                                                    : p * c;
      EXPECT_EQ(by_form, expression.evaluate(parameters)) << text << " at " << y;
    }
  }
}

TEST(Expression, CountsParametersAndRandomCalls) {
  EXPECT_EQ(expression_of("3").parameter_count(), 0u);
  EXPECT_EQ(expression_of("x + y").parameter_count(), 2u);
  EXPECT_FALSE(expression_of("x").uses_random());
  EXPECT_TRUE(expression_of("x + random()").uses_random());
}

TEST(Expression, DrawsRandomNumbersByTheirPlace) {
  const ExpressionRandom place{.seed = 5, .stream = 3, .index = 512};
  const double parameters[] = {10.0, 20.0, 0.0};
  EXPECT_EQ(expression_of("random()").evaluate(parameters, place), random_unit(5, 3, 512));
  EXPECT_EQ(expression_of("0 * random() + random()").evaluate(parameters, place),
            random_unit(5, 3, 513));
  EXPECT_EQ(expression_of("random(x, y)").evaluate(parameters, place),
            10.0 + 10.0 * random_unit(5, 3, 512));
}

TEST(ExpressionLaw, RandomNumbersStayBelowTheirEnd) {
  const double high = std::nextafter(1.0, 2.0);
  const double parameters[] = {1.0, high, 0.0};
  for (std::uint64_t i = 0; i < 100; ++i)
    EXPECT_EQ(expression_of("random(x, y)").evaluate(parameters, {.index = i}), 1.0);
}

TEST(Expression, HidesAConstantBehindAParameterOfItsName) {
  const double parameters[] = {4.0, 0.0, 0.0};
  EXPECT_EQ(expression_of("x + n", {{"x", 100.0}, {"n", 1.0}}).evaluate(parameters), 5.0);
}

// [Liebemann2017] sec. 4.2.1: constants whose names are parts of others.
TEST(Expression, ReadsWholeNames) {
  const Constants constants{{"a", 1.0}, {"ab", 20.0}, {"b", 300.0}, {"a_b", 4000.0}, {"r", 7.0}};
  EXPECT_EQ(expression_of("a + ab + b + a_b", constants).evaluate(nullptr), 4321.0);
  const double parameters[] = {0.0, 0.0, 50.0};
  EXPECT_EQ(expression_of("l * lr", {{"lr", 1.5}, {"r", 7.0}}).evaluate(parameters), 75.0);
}

TEST(Expression, SaysWhatIsWrongAndWhere) {
  expect_error("x + legth", "test:1:5: unknown name 'legth'");
  expect_error("x + yy", "did you mean 'y'?");
  expect_error("sinn(x)", "unknown function 'sinn'; did you mean 'sin'?");
  expect_error("x(3)", "'x' is no function; write 'x * ('");
  expect_error("sin + 1", "'sin' is a function");
  expect_error("min(x)", "min() takes 2 arguments, not 1");
  expect_error("sin()", "sin() takes 1 argument, not 0");
  expect_error("sin(x, y)", "sin() takes 1 argument, not 2");
  expect_error("random(x)", "random() takes no argument or 2");
  expect_error("random(2, 1)", "needs low <= high");
  expect_error("(x + 1", "close the '(' of column 1");
  expect_error("sin(x", "close the brackets of sin()");
  expect_error("x +", "test:1:4: the end where a number");
  expect_error("x * / y", "test:1:5: '/' where a number");
  expect_error("", "the end where a number");
  expect_error("x = 1", "write '=='");
  expect_error("x & y", "write '&&'");
  expect_error("x | y", "write '||'");
  expect_error("1 < x < 3", "write 'a < b && b < c'");
  expect_error("1 == x == 3", "a comparison with a comparison");
  expect_error("1e999", "too large or too small");
  expect_error("2 x", "rest");
  expect_error("0x10", "rest");
}

TEST(Expression, RefusesPartsThatAreNeverFinite) {
  expect_error("x + 1 / 0", "test:1:7: this is infinite");
  expect_error("sqrt(-1)", "this is not a number");
  expect_error("0 * log(0)", "this is infinite");
  expect_error("10 ^ 10 ^ 10", "this is infinite");
}

TEST(Expression, RefusesAbsurdNesting) {
  const auto repeated = [](std::size_t count, const std::string& text) {
    std::string all;
    for (std::size_t i = 0; i < count; ++i) all += text;
    return all;
  };
  EXPECT_EQ(value(repeated(60, "(") + "1" + repeated(60, ")")), 1.0);
  for (const char* opening : {"(", "-", "!", "2^", "sin("})
    for (const std::size_t count : {std::size_t{65}, std::size_t{100000}})
      expect_error(repeated(count, opening) + "1", "nested deeper than 64");
  // Each bracket keeps two numbers waiting.
  expect_error(repeated(40, "x+y*(") + "1" + repeated(40, ")"), "more than 64 numbers at once");
  EXPECT_EQ(value("0" + repeated(10000, "+x"), 1.0), 10000.0);
}

TEST(Expression, RefusesMoreRandomCallsThanAModuleHasNumbers) {
  std::string sum = "random()";
  for (int i = 1; i < most_random_calls; ++i) sum += "+random()";
  EXPECT_TRUE(expression_of(sum).uses_random());
  expect_error(sum + "+random()", "more than 256 times");
}

TEST(Expression, DemandsAProgramThatLeavesOneValue) {
  using Program = std::vector<Expression::Instruction>;
  EXPECT_THROW(Expression(Program{}), ContractViolation);
  EXPECT_THROW(Expression(Program{{Operation::add}}), ContractViolation);
  EXPECT_THROW(Expression(Program{{Operation::constant}, {Operation::constant}}),
               ContractViolation);
  EXPECT_THROW(Expression(Program(65, {Operation::constant})), ContractViolation);
  EXPECT_EQ(Expression(2.5).evaluate(nullptr), 2.5);
  EXPECT_EQ(Expression().evaluate(nullptr), 0.0);
}

}  // namespace
}  // namespace phytobench
