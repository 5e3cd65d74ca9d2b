// SPDX-License-Identifier: MIT
#include "core/lsystem/expression_parser.hpp"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "core/contract/parameter_keys.hpp"
#include "core/contract/suggestion.hpp"
#include "core/lsystem/program_builder.hpp"

namespace phytobench {

namespace {

using Operation = Expression::Operation;

struct Function {
  std::string_view name;
  Operation operation;
  std::size_t arguments;
};

constexpr std::array functions{
    Function{"sin", Operation::sine, 1},         Function{"cos", Operation::cosine, 1},
    Function{"tan", Operation::tangent, 1},      Function{"atan", Operation::arc_tangent, 1},
    Function{"sqrt", Operation::square_root, 1}, Function{"abs", Operation::absolute, 1},
    Function{"floor", Operation::floor, 1},      Function{"ceil", Operation::ceiling, 1},
    Function{"exp", Operation::exponential, 1},  Function{"log", Operation::logarithm, 1},
    Function{"min", Operation::minimum, 2},      Function{"max", Operation::maximum, 2},
    Function{"random", Operation::random, 2},
};

const Function* function_named(std::string_view name) {
  const auto found = std::find_if(functions.begin(), functions.end(),
                                  [&](const Function& f) { return f.name == name; });
  return found == functions.end() ? nullptr : &*found;
}

struct BinaryOperator {
  std::string_view text;
  int strength;
  Operation operation;
};

constexpr int comparison_strength = 4;
constexpr int equality_strength = 3;

/// Longer ones before those that they begin with. The sign and ^ bind stronger than all of them.
constexpr std::array operators{
    BinaryOperator{"||", 1, Operation::logical_or},
    BinaryOperator{"&&", 2, Operation::logical_and},
    BinaryOperator{"==", equality_strength, Operation::equal},
    BinaryOperator{"!=", equality_strength, Operation::not_equal},
    BinaryOperator{"<=", comparison_strength, Operation::less_equal},
    BinaryOperator{">=", comparison_strength, Operation::greater_equal},
    BinaryOperator{"<", comparison_strength, Operation::less},
    BinaryOperator{">", comparison_strength, Operation::greater},
    BinaryOperator{"+", 5, Operation::add},
    BinaryOperator{"-", 5, Operation::subtract},
    BinaryOperator{"*", 6, Operation::multiply},
    BinaryOperator{"/", 6, Operation::divide},
    BinaryOperator{"%", 6, Operation::modulo},
};

class ExpressionParser {
 public:
  ExpressionParser(LineScanner& scanner, const ExpressionScope& scope)
      : scanner_(scanner), scope_(scope), builder_(scanner.line()) {}

  Expression parse() {
    read_binary(1);
    return builder_.finish();
  }

 private:
  const BinaryOperator* next_operator() const {
    for (const BinaryOperator& candidate : operators)
      if (scanner_.next_is(candidate.text)) return &candidate;
    if (scanner_.next_is("=")) scanner_.fail("a single '='; write '==' to compare");
    if (scanner_.next_is("&")) scanner_.fail("a single '&'; write '&&' for 'and'");
    if (scanner_.next_is("|")) scanner_.fail("a single '|'; write '||' for 'or'");
    return nullptr;
  }

  /// Everything that binds at least so strongly.
  void read_binary(int strength) {
    read_unary();
    int last_strength = 0;
    for (;;) {
      const BinaryOperator* next = next_operator();
      if (next == nullptr || next->strength < strength) return;
      const bool compares =
          next->strength == comparison_strength || next->strength == equality_strength;
      if (compares && next->strength == last_strength)
        scanner_.fail("a comparison with a comparison; write 'a < b && b < c'");
      last_strength = next->strength;
      const std::size_t place = scanner_.offset();
      scanner_.take(next->text);
      read_binary(next->strength + 1);
      builder_.add_binary(next->operation, place);
    }
  }

  void read_unary() {
    if (++nesting_ > most_nesting)
      scanner_.fail(
          fmt::format("nested deeper than {}; split the expression into constants", most_nesting));
    const std::size_t place = scanner_.offset();
    if (scanner_.take("-")) {
      read_unary();
      builder_.add_unary(Operation::negate, place);
    } else if (scanner_.take("!")) {
      read_unary();
      builder_.add_unary(Operation::logical_not, place);
    } else if (scanner_.take("+")) {
      read_unary();
    } else {
      read_power();
    }
    --nesting_;
  }

  void read_power() {
    read_primary();
    const std::size_t place = scanner_.offset();
    if (!scanner_.take("^")) return;
    read_unary();
    builder_.add_binary(Operation::power, place);
  }

  void read_primary() {
    const std::size_t place = scanner_.offset();
    if (scanner_.take("(")) {
      read_binary(1);
      if (!scanner_.take(")"))
        scanner_.fail(fmt::format("{} where ')' or an operator belongs; close the '(' of column {}",
                                  scanner_.next_shown(), scanner_.line().place(place).column));
    } else if (const auto number = scanner_.take_number()) {
      builder_.add_constant(*number, place);
    } else if (const std::string_view name = scanner_.take_name(); !name.empty()) {
      scanner_.take("(") ? read_call(name, place) : read_named(name, place);
    } else {
      scanner_.fail(fmt::format("{} where a number, a name or '(' belongs; complete the expression",
                                scanner_.next_shown()));
    }
  }

  void read_named(std::string_view name, std::size_t place) {
    const auto& parameters = scope_.parameters;
    const auto parameter = std::find(parameters.begin(), parameters.end(), name);
    if (parameter != parameters.end())
      return builder_.add_parameter(static_cast<std::size_t>(parameter - parameters.begin()),
                                    place);
    const auto constant = scope_.constants.find(name);
    if (constant == scope_.constants.end()) refuse_unknown(name, place);
    builder_.add_constant(constant->second, place);
  }

  [[noreturn]] void refuse_unknown(std::string_view name, std::size_t place) const {
    std::vector<std::string> known(scope_.parameters.begin(), scope_.parameters.end());
    for (const auto& constant : scope_.constants) known.push_back(constant.first);
    if (is_function_name(name))
      scanner_.line().fail(place, fmt::format("'{}' is a function; write {}(...)", name, name));
    scanner_.line().fail(
        place, fmt::format("unknown name '{}'{} (a parameter of this production, or a constant "
                           "given above as 'name = 2', is needed)",
                           in_one_line(name, 40), near_name(name, known)));
  }

  void read_call(std::string_view name, std::size_t place) {
    const Function* function = function_named(name);
    if (function == nullptr) refuse_function(name, place);
    std::size_t count = 0;
    if (!scanner_.take(")")) {
      do {
        read_binary(1);
        ++count;
      } while (scanner_.take(","));
      if (!scanner_.take(")"))
        scanner_.fail(fmt::format("{} where ',' or ')' belongs; close the brackets of {}()",
                                  scanner_.next_shown(), name));
    }
    if (function->operation == Operation::random) return call_random(count, place);
    if (count != function->arguments)
      scanner_.line().fail(
          place, fmt::format("{}() takes {} argument{}, not {}", name, function->arguments,
                             function->arguments == 1 ? "" : "s", count));
    function->arguments == 1 ? builder_.add_unary(function->operation, place)
                             : builder_.add_binary(function->operation, place);
  }

  void call_random(std::size_t count, std::size_t place) {
    if (scope_.random_calls == nullptr)
      scanner_.line().fail(place,
                           "random() has no place here; it is for the conditions and "
                           "successors of productions");
    if (count != 0 && count != 2)
      scanner_.line().fail(
          place, fmt::format("random() takes no argument or 2 (low, high), not {}", count));
    if (*scope_.random_calls == most_random_calls)
      scanner_.line().fail(place, fmt::format("a production calls random() more than {} times; "
                                              "split it in two",
                                              most_random_calls));
    if (count == 0) {
      builder_.add_constant(0.0, place);
      builder_.add_constant(1.0, place);
    }
    builder_.add_random(static_cast<std::size_t>((*scope_.random_calls)++), place);
  }

  [[noreturn]] void refuse_function(std::string_view name, std::size_t place) const {
    std::vector<std::string> known;
    for (const Function& function : functions) known.emplace_back(function.name);
    const bool is_value = scope_.constants.contains(name) ||
                          std::find(scope_.parameters.begin(), scope_.parameters.end(), name) !=
                              scope_.parameters.end();
    scanner_.line().fail(place, is_value
                                    ? fmt::format("'{}' is no function; write '{} * (' to multiply",
                                                  in_one_line(name, 40), in_one_line(name, 40))
                                    : fmt::format("unknown function '{}'{} (known: {})",
                                                  in_one_line(name, 40), near_name(name, known),
                                                  "sin cos tan atan sqrt abs floor ceil "
                                                  "exp log min max random"));
  }

  LineScanner& scanner_;
  const ExpressionScope& scope_;
  ProgramBuilder builder_;
  int nesting_ = 0;
};

}  // namespace

Expression parse_expression(LineScanner& scanner, const ExpressionScope& scope) {
  return ExpressionParser(scanner, scope).parse();
}

double parse_constant(LineScanner& scanner, const Constants& constants) {
  return parse_expression(scanner, {.constants = constants}).evaluate(nullptr);
}

bool is_function_name(std::string_view name) {
  return function_named(name) != nullptr;
}

std::string near_name(std::string_view wrong, const std::vector<std::string>& known) {
  return wrong.size() > 64 ? "" : did_you_mean(wrong, known);
}

}  // namespace phytobench
