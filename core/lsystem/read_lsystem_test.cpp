// SPDX-License-Identifier: MIT
#include "core/lsystem/read_lsystem.hpp"

#include <gtest/gtest.h>

#include "core/lsystem/test_lsystems.hpp"

namespace phytobench {
namespace {

/// "A(1,2)B": the letters with their number of parameters, "A/2 B/0".
template <class Module>
std::string shape_of(const LSystem& system, const std::vector<Module>& modules) {
  std::string text;
  for (const Module& module : modules) {
    const Symbol& symbol = system.symbols[module.symbol];
    text += symbol.letter;
    if (symbol.arity > 0) text += "/" + std::to_string(symbol.arity) + " ";
  }
  return text;
}

std::string successor_of(const LSystem& system, std::size_t production) {
  return shape_of(system, system.productions[production].successor);
}

double parameter_of(const LSystem& system, std::size_t production, std::size_t module,
                    std::vector<double> values) {
  return system.productions[production].successor[module].parameters[0].evaluate(values.data());
}

TEST(ReadLSystem, ReadsTheExampleOfItsHeader) {
  const LSystem system = parse_lsystem(
      "# a comment\n"
      "alphabet: ar al br bl   # another\n"
      "lr = 1.3\n"
      "axiom: A(1, lr)\n"
      "p1 : A(x) < B(y) > A(z) : y < 4 -> B(x + z)[A(y)] : 1\n"
      "steps: 8    angle: 22.5    step: 2    width: 3    width_factor: 0.5    seed: 9\n"
      "ignore: + - /\n"
      "draw: F G    move: f\n"
      "turtle: cpfg\n"
      "start: local\n"
      "colours: #6b4a2b #457d29\n",
      "test");
  EXPECT_EQ(system.source, "test");
  ASSERT_EQ(system.axiom.size(), 1u);
  EXPECT_EQ(system.axiom[0].parameters, (std::vector<double>{1.0, 1.3}));
  ASSERT_EQ(system.productions.size(), 1u);
  const Production& production = system.productions[0];
  EXPECT_EQ(production.label, "p1");
  EXPECT_EQ(shape_of(system, production.left), "A/1 ");
  EXPECT_EQ(shape_of(system, production.right), "A/1 ");
  EXPECT_EQ(production.left[0].first_parameter, 0);
  EXPECT_EQ(production.predecessor.first_parameter, 1);
  EXPECT_EQ(production.right[0].first_parameter, 2);
  EXPECT_EQ(production.parameter_count, 3);
  EXPECT_EQ(production.place.line, 5);
  EXPECT_EQ(production.place.column, 13);
  EXPECT_EQ(production.probability, 1.0);
  const double values[] = {1.0, 3.0, 5.0};
  EXPECT_EQ(production.condition->evaluate(values), 1.0);
  EXPECT_EQ(successor_of(system, 0), "B/1 [A/1 ]");
  EXPECT_EQ(parameter_of(system, 0, 0, {1.0, 3.0, 5.0}), 6.0);
  EXPECT_EQ(system.steps, 8);
  EXPECT_EQ(system.seed, 9u);
  EXPECT_EQ(system.turtle.angle_deg, 22.5);
  EXPECT_EQ(system.turtle.step, 2.0);
  EXPECT_EQ(system.turtle.width, 3.0);
  EXPECT_EQ(system.turtle.width_factor, 0.5);
  EXPECT_EQ(system.turtle.draws, "FG");
  EXPECT_EQ(system.turtle.moves, "f");
  EXPECT_EQ(system.turtle.convention, TurtleConvention::cpfg);
  EXPECT_EQ(system.turtle.start, TurtleStart::local);
  EXPECT_EQ(system.turtle.colours, (std::vector<std::string>{"#6b4a2b", "#457d29"}));
}

TEST(ReadLSystem, ReadsTheAnabaenaWithAndWithoutIndices) {  // [Liebemann2017] eq. 2.1
  for (const char* alphabet : {"alphabet: a_r a_l b_r b_l", "V : {a_r, a_l, b_r, b_l}"}) {
    const LSystem system = parse_lsystem(std::string(alphabet) +
                                             "\nω : a_r\n"
                                             "p_1 : a_r → a_l b_r\n"
                                             "p_2 : a_l → b_l a_r\n"
                                             "p_3 : b_r → a_r\n"
                                             "p_4 : b_l → a_l\n",
                                         "test");
    EXPECT_EQ(system.symbols.size(), 4u);
    EXPECT_EQ(successor_of(system, 0), "a_lb_r");
    EXPECT_EQ(system.productions[3].label, "p_4");
  }
}

TEST(ReadLSystem, ReadsParametricProductions) {  // [Liebemann2017] eq. 2.2
  const LSystem system = parse_lsystem(
      "ω : A(1, 1)\n"
      "p_1 : A(x, y) -> A(x + 1, y * 2) B(y)\n"
      "p_2 : B(x) -> B(x + 1) C\n",
      "test");
  EXPECT_EQ(successor_of(system, 0), "A/2 B/1 ");
  EXPECT_EQ(successor_of(system, 1), "B/1 C");
  EXPECT_EQ(parameter_of(system, 0, 0, {3.0, 4.0}), 4.0);
  EXPECT_EQ(parameter_of(system, 0, 1, {3.0, 4.0}), 4.0);
}

TEST(ReadLSystem, ReadsConstantsOfTwoLetters) {  // [Liebemann2017] eq. 2.17
  const LSystem system = parse_lsystem(
      "d = 137.5\na = 18.95\nl_r = 1.3\n"
      "omega : A\n"
      "p_1 : A -> F(50)[&(a)F(50)A]/(d)[&(a)F(50)A]/(d)[&(a)F(50)A]\n"
      "p_2 : F(l) -> F(l * l_r)\n",
      "test");
  EXPECT_EQ(successor_of(system, 0), "F/1 [&/1 F/1 A]//1 [&/1 F/1 A]//1 [&/1 F/1 A]");
  EXPECT_EQ(system.productions[0].successor[2].parameters[0].form_constant(), 18.95);
  EXPECT_EQ(parameter_of(system, 1, 0, {2.0}), 2.6);
}

TEST(ReadLSystem, ReadsTheBushWithItsOwnArrow) {  // [Lintermann1997] sec. 2.1
  const LSystem system = parse_lsystem(
      "ω : A\n"
      "p_1 : A ::= [&FL!A]////////'[&FL!A]////////'[&FL!A]\n"
      "p_2 : F ::= S////////F\n"
      "p_3 : S ::= FL\n"
      "p_4 : L ::= ['''^^{-f + f + f - | - f + f + f}]\n",
      "test");
  EXPECT_EQ(successor_of(system, 0), "[&FL!A]////////'[&FL!A]////////'[&FL!A]");
  EXPECT_EQ(successor_of(system, 3), "['''^^{-f+f+f-|-f+f+f}]");
}

TEST(ReadLSystem, ReadsSetsOfLettersThatLackSome) {  // [Brzoska2019] eq. 6
  const LSystem system = parse_lsystem(
      "V : {F, -, +, [,]}\n"
      "ω : X\n"
      "p_1 : F → FF\n"
      "p_2 : X → F[+++FX]F[---FX]F[++F-FX][F-FX]\n",
      "test");
  EXPECT_EQ(successor_of(system, 1), "F[+++FX]F[---FX]F[++F-FX][F-FX]");
  // Eq. 4 and 5.
  EXPECT_EQ(parse_lsystem("V : {a, b}\nω : b\np_1 : b → a\np_2 : a → ab", "test").symbols.size(),
            2u);
  EXPECT_EQ(successor_of(parse_lsystem("V : {F, -, +}\nω : F\np : F → F + F - -F + F", "test"), 0),
            "F+F--F+F");
}

TEST(ReadLSystem, ReadsProbabilitiesAndContexts) {  // [Alsweis] L-System1
  const LSystem system = parse_lsystem(stochastic_system, "test");
  EXPECT_EQ(shape_of(system, system.axiom), "A/1 B/1 A/1 ");
  ASSERT_EQ(system.productions.size(), 3u);
  EXPECT_EQ(system.productions[0].probability, 0.4);
  EXPECT_EQ(system.productions[0].group, system.productions[1].group);
  EXPECT_NE(system.productions[0].group, system.productions[2].group);
  EXPECT_FALSE(system.productions[2].probability);
}

TEST(ReadLSystem, LetsQueriesHaveNamesThatStandForNothing) {  // [Alsweis] L-System2
  const LSystem system = parse_lsystem(query_system, "test");
  EXPECT_EQ(successor_of(system, 0), "F/1 ?P/2 -A");
  EXPECT_EQ(parameter_of(system, 0, 1, {}), 0.0);
  EXPECT_EQ(parameter_of(parse_lsystem("axiom: A(1)\nA(x) -> ?P(x, y)", "t"), 0, 0, {7.0}), 7.0);
}

// [Liebemann2017] sec. 4.2.1: replacing constants as text would change letters and other names.
TEST(ReadLSystem, KeepsLettersAndNamesApartFromConstantsOfThatName) {
  const LSystem system = parse_lsystem(
      "A = 3\nF = 0.5\nl = 7\nlr = 2\nr = 100\n"
      "axiom: A(A)F\n"
      "p1 : A(x) -> A(x * lr)F(F)[A(A - x)]\n"
      "F(l) -> F(l * lr)\n",
      "test");
  EXPECT_EQ(shape_of(system, system.axiom), "A/1 F");
  EXPECT_EQ(system.axiom[0].parameters[0], 3.0);
  EXPECT_EQ(successor_of(system, 0), "A/1 F/1 [A/1 ]");
  EXPECT_EQ(parameter_of(system, 0, 0, {5.0}), 10.0);
  EXPECT_EQ(parameter_of(system, 0, 1, {5.0}), 0.5);
  EXPECT_EQ(parameter_of(system, 0, 3, {5.0}), -2.0);
  EXPECT_EQ(parameter_of(system, 1, 0, {1.5}), 3.0);
}

TEST(ReadLSystem, TellsLabelsFromPredecessors) {
  const auto first = [](const std::string& text) {
    return parse_lsystem("n = 3\naxiom: A(1)\n" + text, "test");
  };
  EXPECT_EQ(first("A -> B").productions[0].label, "p1");
  EXPECT_EQ(first("p : A -> B").productions[0].label, "p");
  EXPECT_EQ(first("p : A(x) < B -> C").productions[0].label, "p");
  for (const char* text : {"A(x) : x > 1 -> B", "A : n == 3 -> B", "p : A(x) : x > 1 -> B"})
    EXPECT_TRUE(first(text).productions[0].condition) << text;
  for (const char* text : {"A(x) : * -> B", "A : * -> B", "p : A : * -> B", "* < A > * : * -> B"}) {
    EXPECT_FALSE(first(text).productions[0].condition) << text;
    EXPECT_EQ(first(text).symbols[first(text).productions[0].predecessor.symbol].letter, "A");
  }
  EXPECT_EQ(first("0 < 0 > 1 -> 1[+F1F1]").productions[0].left.size(), 1u);
}

TEST(ReadLSystem, ReadsBranchesInRightContexts) {
  const LSystem system = parse_lsystem("axiom: S\nBC < S > G[H]M -> X", "test");
  EXPECT_EQ(shape_of(system, system.productions[0].left), "BC");
  EXPECT_EQ(shape_of(system, system.productions[0].right), "G[H]M");
}

TEST(ReadLSystem, AllowsEmptySuccessorsAndCrossingBrackets) {
  for (const char* text : {"axiom: A\nA ->", "axiom: A\nA -> *", "axiom: A\nA → ε"})
    EXPECT_TRUE(parse_lsystem(text, "test").productions[0].successor.empty()) << text;
  EXPECT_EQ(successor_of(parse_lsystem("axiom: A\nA -> [+A{.].C.}", "test"), 0), "[+A{.].C.}");
}

TEST(ReadLSystem, TakesEveryLineEndAndLinesThatGoOn) {
  const std::string text = "axiom: A\nA -> B\n  [C]  # rest\n\n # more\n\tD\nB -> A";
  std::string carriage = text, both;
  for (char& c : carriage) c = c == '\n' ? '\r' : c;
  for (const char c : text) both += c == '\n' ? "\r\n" : std::string(1, c);
  for (const std::string& variant : {text, carriage, both, "\xef\xbb\xbf" + text}) {
    const LSystem system = parse_lsystem(variant, "test");
    EXPECT_EQ(successor_of(system, 0), "B[C]D");
    EXPECT_EQ(system.productions[1].place.line, 7);
  }
}

TEST(ReadLSystem, TakesExpressionsForSettings) {
  const LSystem system = parse_lsystem("n = 7\nsteps: n - 2 angle: -360 / n\naxiom: A", "test");
  EXPECT_EQ(system.steps, 5);
  EXPECT_EQ(system.turtle.angle_deg, -360.0 / 7.0);
}

TEST(ReadLSystem, HidesIgnoredLettersWhateverTheirParameters) {
  const LSystem system = parse_lsystem("ignore: +-/\naxiom: A+(3)+B", "test");
  EXPECT_EQ(system.ignored, (std::vector<bool>{false, true, true, false}));
}

TEST(ReadLSystem, LetsDrawAndMoveTakeLettersFromEachOthersDefault) {
  const LSystem one = parse_lsystem("axiom: A\ndraw: f", "test");
  EXPECT_EQ(one.turtle.draws + ":" + one.turtle.moves, "f:");
  const LSystem other = parse_lsystem("axiom: A\nmove: G F", "test");
  EXPECT_EQ(other.turtle.draws + ":" + other.turtle.moves, ":GF");
}

TEST(ReadLSystem, DeclaresLettersBeyondAscii) {
  const LSystem system = parse_lsystem("alphabet: α αβ\naxiom: ααβα", "test");
  EXPECT_EQ(shape_of(system, system.axiom), "ααβα");
  EXPECT_EQ(system.axiom.size(), 3u);
}

TEST(ReadLSystem, KeepsGroupsOfDifferentConditionsApart) {
  const LSystem system = parse_lsystem(
      "axiom: A(1)\n"
      "A(x) : x > 1 -> B : 0.5\n"
      "A(y) : y > 1 -> C : 0.5\n"
      "A(x) : x > 0 -> B : 0.25\n"
      "A(x) : x > 0 -> B : 3 / 4\n"
      "A(x) -> C\n",
      "test");
  const auto& productions = system.productions;
  EXPECT_EQ(productions[0].group, productions[1].group);
  EXPECT_EQ(productions[2].group, productions[3].group);
  EXPECT_NE(productions[0].group, productions[2].group);
  EXPECT_NE(productions[2].group, productions[4].group);
}

}  // namespace
}  // namespace phytobench
