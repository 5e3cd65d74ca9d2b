// SPDX-License-Identifier: MIT
// Sec. 4.2.1: what expressions and constants mean that are typed into the form.
#include <string>
#include <utility>
#include <vector>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/editor_form.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "experiments/liebemann2017/word_systems.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

std::string word_of(const std::string& expression) {
  return word_after(parse_lsystem("axiom: A(" + expression + ")\n", "expression"), 0);
}

/// A sum of products and quotients, without brackets, beside the value of the usual rules: first
/// each term from left to right, then the terms from left to right.
struct RandomExpression {
  std::string text;
  double value = 0.0;
};
RandomExpression random_expression(RandomWords& random, bool replace_constant) {
  constexpr double c = -2.5;
  RandomExpression made;
  const auto next = [&]() -> std::pair<std::string, double> {
    if (random.below(3) == 0) return {replace_constant ? "-2.5" : "c", c};
    const double number = (1 + random.below(80)) / 8.0;
    return {fmt::format("{}", number), number};
  };
  const int terms = 1 + random.below(4);
  for (int t = 0; t < terms; ++t) {
    const bool minus = t > 0 && random.below(2) == 0;
    if (t > 0) made.text += minus ? "-" : "+";
    auto [text, term] = next();
    for (int factor = random.below(4); factor > 0; --factor) {
      const bool divide = random.below(2) == 0;
      const auto [factor_text, value] = next();
      text += (divide ? "/" : "*") + factor_text;
      term = divide ? term / value : term * value;
    }
    made.text += text;
    made.value = t == 0 ? term : minus ? made.value - term : made.value + term;
  }
  return made;
}

void measure_expressions(ExperimentContext& context) {
  const std::pair<const char*, const char*> examples[] = {
      {"product_before_sum", "1+2*3"}, {"sum_after_product", "2*3+1"},     {"differences", "8-3-2"},
      {"quotients", "16/4/2"},         {"quotient_and_product", "8/2*4"},  {"signs", "-2*3--4"},
      {"brackets", "(1+2)*3"},         {"brackets_written_out", "1*3+2*3"}};
  for (const auto& [name, expression] : examples)
    context.record(std::string("examples/") + name, word_of(expression));
  constexpr int expressions = 400;
  std::int64_t differ = 0, in_successor_differ = 0, as_text_differ = 0;
  RandomWords random(context.seed(), 10, "+"), again(context.seed(), 10, "+");
  for (int i = 0; i < expressions; ++i) {
    const RandomExpression e = random_expression(random, false);
    const LSystem axiom = parse_lsystem("c = -2.5\naxiom: A(" + e.text + ")\n", "axiom");
    differ += axiom.axiom[0].parameters[0] != e.value;
    const LSystem successor =
        parse_lsystem("axiom: A(-2.5)\nA(c) -> B(" + e.text + ")\n", "successor");
    in_successor_differ += derived(successor, 1).parameters[0] != e.value;
    const RandomExpression replaced = random_expression(again, true);
    const LSystem text = parse_lsystem("axiom: A(" + replaced.text + ")\n", "text");
    as_text_differ += text.axiom[0].parameters[0] != e.value;
  }
  record_seeded(context, "random/expressions", std::int64_t{expressions}, "expressions");
  record_seeded(context, "random/in_axiom_differ", differ, "expressions");
  record_seeded(context, "random/in_successor_differ", in_successor_differ, "expressions");
  record_seeded(context, "random/constants_as_text_differ", as_text_differ, "expressions");
}

/// Constants that are called like letters, parameters, or the beginning of each other.
void measure_constants(ExperimentContext& context) {
  const auto hash = [](const Form& form) {
    const LSystem system = entered(form);
    return word_hash(system, derived(system, 6));
  };
  const std::string with = hash(equation_2_17_form("a", "d", "lr"));
  const LSystem numbers = parse_lsystem(
      "axiom: /(45)A\nA -> F(50)[&(18.95)F(50)A]/(137.5)[&(18.95)F(50)A]/(137.5)[&(18.95)F(50)A]\n"
      "F(l) -> F(l * 1.3)\n",
      "numbers");
  context.record("constants/numbers_instead_differ",
                 std::int64_t{word_hash(numbers, derived(numbers, 6)) != with});
  std::int64_t renamed = 0, renamed_differ = 0;
  const std::vector<std::vector<std::string>> names = {
      {"A", "F", "lr"}, {"F", "A", "ll"}, {"l2", "l3", "l4"}, {"x", "xx", "xxx"}};
  for (const auto& name : names) {
    renamed_differ += hash(equation_2_17_form(name[0], name[1], name[2])) != with;
    ++renamed;
  }
  context.record("constants/renamed", renamed, "systems");
  context.record("constants/renamed_differ", renamed_differ, "systems");
  context.record("constants/one_begins_the_other",
                 word_after(parse_lsystem("l = 2\nlr = 1.5\naxiom: A(l * lr)\n", "text"), 0));
  // The text l * lr after l has been replaced by 2 wherever it stands.
  context.record("constants/shorter_replaced_first_refused",
                 std::int64_t{is_refused("lr = 1.5\naxiom: A(2 * 2r)\n")});
  context.record("constants/like_a_parameter",
                 word_after(parse_lsystem("x = 7\naxiom: A(1)\nA(x) -> B(x + 1)\n", "text"), 1));
  context.record("constants/in_predecessor_refused",
                 std::int64_t{is_refused("axiom: A(7)\nA(7) -> B\n")});
  context.record("constants/unknown_refused", std::int64_t{is_refused("axiom: A(c)\n")});
}

void run(ExperimentContext& context) {
  measure_expressions(context);
  measure_constants(context);
}

}  // namespace

extern const ExperimentDescriptor expression_language;
constinit const ExperimentDescriptor expression_language{
    .id = "liebemann2017/expression-language",
    .question = "What are expressions and constants worth?",
    .source = "[Liebemann2017] sec. 4.2.1, 4.2.2",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
