// SPDX-License-Identifier: MIT
// Texts that are no L-systems: what is said, and that nothing else than InputError ever happens.
#include <fstream>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/test_lsystems.hpp"

namespace phytobench {
namespace {

std::string error_of(std::string_view text) {
  try {
    parse_lsystem(text, "test");
  } catch (const InputError& error) {
    return error.what();
  }
  return "no error";
}

/// The message begins with "test:<place>" and contains `part`.
void expect_error(const std::string& text, const std::string& place, const std::string& part) {
  const std::string message = error_of(text);
  EXPECT_TRUE(message.starts_with("test:" + place)) << text << "\ngives " << message;
  EXPECT_NE(message.find(part), std::string::npos) << text << "\ngives " << message;
  EXPECT_EQ(message.find('\n'), std::string::npos) << message;
}

/// The same for a line after the axiom.
void expect_line_error(const std::string& line, int column, const std::string& part) {
  expect_error("axiom: A\n" + line, "2:" + std::to_string(column) + ": ", part);
}

std::string repeated(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

TEST(ReadLSystemErrors, NamesUnbalancedBrackets) {
  expect_line_error("A -> B[C", 7, "'[' is never closed");
  expect_line_error("A -> B]C", 7, "']' without a '[' before it");
  expect_line_error("A -> [B{C]", 8, "'{' is never closed");
  expect_line_error("A -> B}", 7, "'}' without a '{'");
  expect_error("axiom: A[B", "1:9: ", "'[' is never closed");
  expect_line_error("A > B[C -> D", 6, "'[' is never closed");
  expect_line_error("A -> B(1", 9, "close the parameters of 'B'");
  expect_line_error("A -> B)", 7, "')' without a '('");
  expect_line_error("A -> (B)", 6, "'(' without a letter");
}

TEST(ReadLSystemErrors, NamesWhatIsWrongWithAProduction) {
  expect_line_error("A", 1, "neither a production with an arrow");
  expect_line_error("p1 : A B", 1, "unknown key 'p1' (and there is no arrow");
  expect_line_error("-> B", 1, "no predecessor");
  expect_line_error("p1 : -> B", 6, "no predecessor");
  expect_line_error("AB -> C", 1, "more than one module as predecessor");
  expect_line_error("A --> B", 3, "'-->' is no arrow; write '->'");
  expect_line_error("A --> B --> C", 3, "'-->' is no arrow");
  expect_line_error("p : A(x) : x > 1 --> B", 18, "'-->' is no arrow");
  expect_line_error("A > B --> C", 7, "or a blank before '->' if the first '-' is a symbol");
  expect_line_error("A < B < C -> D", 7, "'<' where the arrow");
  expect_line_error("A > B > C -> D", 7, "'>' where the arrow");
  expect_line_error("A[B] < C -> D", 2, "only the right context has brackets");
  expect_line_error("[ -> D", 1, "'[' before the arrow");
  expect_line_error("A(1) -> B", 3, "numbers go into the condition");
  expect_line_error("A(x) < B(x) -> C", 10, "a second parameter 'x'");
  expect_line_error("A(sin) -> C", 3, "'sin' is a function");
  expect_line_error("A(x) -> B(y)", 11, "unknown name 'y'; did you mean 'x'?");
  expect_line_error("A(length) -> B(lenght)", 16, "did you mean 'length'?");
  expect_line_error("A(x) : -> B", 8, "no condition after ':'");
  expect_line_error("A(x) : x > 1 x -> B", 14, "where an operator or the arrow belongs");
  expect_line_error("p : A : 1 : 2 -> B", 11, "a third ':'");
  expect_line_error("a b : A : 1 -> B", 1, "a label must be a word");
  expect_line_error("steps : A -> B", 1, "'steps' takes no arrow");
  expect_line_error("A -> B -> C", 9, "begin a new line if it is an arrow");
  expect_line_error("A -> B = 2", 8, "'=' has no place here");
  expect_line_error("A -> B, C", 7, "without commas");
  expect_line_error("A -> B*C", 7, "'*' is no letter");
  expect_line_error("A -> B#C", 7, "a comment needs a blank before it");
  expect_line_error("A -> ?X(x)", 6, "unknown query");
  expect_line_error("A -> ?P(x, y, z, w)", 6, "at most 3");
  expect_line_error("A -> [(3)]", 6, "takes no parameters");
  expect_line_error("A -> B − C", 8, "write '-'");
  expect_line_error("A -> B λ", 8, "declare it in a line 'alphabet: λ'");
  expect_line_error("A -> B(random(1))", 8, "random() takes no argument or 2");
}

TEST(ReadLSystemErrors, RefusesWhatMayBeConditionOrContext) {
  expect_error("n = 3\naxiom: A\nA : n > 2 -> B", "3:5: ", "may be a condition, or a predecessor");
  EXPECT_EQ(error_of("n = 3\naxiom: A\np : A : n > 2 -> B"), "no error");
  EXPECT_EQ(error_of("n = 3\naxiom: A\np : n > 2 : * -> B"), "no error");
}

TEST(ReadLSystemErrors, NamesProductionsThatCollide) {
  expect_error("axiom: A\nA -> B\nA -> C", "3:1: ", "a second production for 'A', as in line 2");
  expect_error("axiom: A\nA(x) -> B\nA(y) -> C", "3:1: ", "for 'A' with 1 parameter");
  expect_error("axiom: A\nA -> B : 0.5\nA -> C", "3:1: ", "a second production");
  expect_error("axiom: A\nA(x) : x > 1 -> B\nA(y) : y > 1 -> C", "3:1: ", "a second production");
  expect_error("axiom: A\nA(x) -> B\nA(y) : y > 1 -> C", "3:1: ", "never used");
  EXPECT_EQ(error_of("axiom: A\nA -> B\nA(x) -> C\nB < A -> C\nA > B -> C"), "no error");
  EXPECT_EQ(error_of("axiom: A\nA(x) : x > 1 -> B\nA(y) -> C"), "no error");
}

TEST(ReadLSystemErrors, NamesWrongProbabilities) {
  expect_error("axiom: A\nA -> B : 0.5\nA -> C : 0.4", "2:1: ", "add up to 0.9");
  expect_error("axiom: A\nA -> B : 0.5\nA -> C : 0.500000002", "2:1: ", "add up to 1.000000002");
  EXPECT_EQ(error_of("axiom: A\nA -> B : 1/3\nA -> C : 1/3\nA -> D : 1/3"), "no error");
  EXPECT_EQ(error_of("axiom: A\nA -> B : 0.5\nA -> C : 0.5000000005"), "no error");
  expect_line_error("A -> B : 0", 10, "the probability = 0 is not allowed");
  expect_line_error("A -> B : 1.5", 10, "the probability = 1.5 is not allowed");
  expect_line_error("A -> B : -0.5", 10, "the probability = -0.5 is not allowed");
  expect_line_error("A -> B :", 9, "the end where a number");
  expect_line_error("A -> B : 0.5 C", 14, "behind the probability");
  expect_line_error("A(x) -> B : x", 13, "unknown name 'x'");
}

TEST(ReadLSystemErrors, NamesMissingAndSecondStatements) {
  expect_error("", " no axiom", "axiom: F");
  expect_error("A -> B\n", " no axiom", "axiom: F");
  expect_error("axiom: # nothing\nA -> B", "1:1: ", "'axiom:' without a value");
  expect_error("axiom: A\nomega: B", "2:1: ", "a second axiom, as in line 1");
  expect_error("axiom: A\nsteps: 1\nsteps: 2", "3:1: ", "a second 'steps:', as in line 2");
  expect_error("axiom: A\na = 1\na = 2", "3:1: ", "a second constant 'a'");
}

TEST(ReadLSystemErrors, NamesWrongAxiomsAndConstants) {
  expect_error("axiom: A(x)", "1:10: ", "unknown name 'x'");
  expect_error("axiom: A(1/0)", "1:11: ", "this is infinite");
  expect_error("axiom: A(random())", "1:10: ", "random() has no place here");
  expect_line_error("angle = 30", 1, "'angle' is a key; write 'angle: ...'");
  expect_line_error("min = 30", 1, "'min' is a function");
  expect_line_error("a = ", 5, "the end where a number");
  expect_line_error("a = 3 b = 4", 7, "a constant has a line of its own");
  expect_line_error("a = b\nb = 1", 5, "unknown name 'b'");
}

TEST(ReadLSystemErrors, NamesWrongSettings) {
  expect_line_error("stps: 3", 1, "unknown key 'stps'; did you mean 'steps'?");
  expect_line_error("steps: 3 angel: 4", 10, "did you mean 'angle'?");
  expect_line_error("steps: -1", 8, "give a number >= 0 and <= 1000000, whole");
  expect_line_error("steps: 1.5", 8, "whole");
  expect_line_error("steps: 1000001", 8, "steps = 1000001 is not allowed");
  expect_line_error("steps: 3 4", 10, "behind the value of 'steps'");
  expect_line_error("step: 0", 7, "step = 0 is not allowed; give a number > 0");
  expect_line_error("width: -1", 8, "width = -1 is not allowed");
  expect_line_error("width_factor: 0", 15, "is not allowed");
  expect_line_error("angle: 1e400", 8, "too large or too small");
  expect_line_error("seed: -1", 7, "seed = -1 is not allowed");
  expect_line_error("draw: steps: 3", 1, "'draw:' without a value");
  expect_error("alphabet: br\naxiom: A\ndraw: br", "3:7: ", "'br' has more than one character");
  expect_line_error("draw: +", 7, "'+' already means something");
  expect_error("axiom: A\ndraw: F f\nmove: f", "3:7: ", "'f' is also named by 'draw:'");
  expect_line_error("turtle: word", 9, "did you mean 'words'?");
  expect_line_error("start: upward", 8, "did you mean 'upwards'?");
  expect_line_error("colours: brown", 10, "'brown' is no colour");
  expect_line_error("colours: #6b4a2b #12", 18, "'#12' is no colour");
  expect_line_error("ignore: [", 9, "brackets cannot be ignored");
  expect_error("axiom: A\nignore: +\nB < + -> C\n+ < A -> B",
               "4:5: ", "its context names '+', which 'ignore:' hides");
}

TEST(ReadLSystemErrors, NamesWrongAlphabets) {
  expect_line_error("alphabet: a(b", 11, "cannot be a letter");
  expect_line_error("alphabet: a[b", 11, "brackets stand alone");
  expect_line_error("alphabet: {ar, al} br", 20, "the set of letters ends before");
  expect_line_error("alphabet: " + std::string(40, 'a'), 11, "more than 32 characters");
}

TEST(ReadLSystemErrors, HintsAtCommentsThatOtherProgramsUnderstand) {
  expect_line_error("#ignore: +-", 1, "write 'ignore: + -'");
  expect_line_error("#define n 3", 1, "'name = 2' for a constant");
}

TEST(ReadLSystemErrors, CountsCharactersAndLines) {
  expect_error("# ω\n\nω : A\nω → [\n", "4:1: ", "'ω' is no letter");
  expect_error("ω : A\np : A → B → λ", "2:11: ", "'→' is no letter");
  expect_error("axiom: A\nA -> B\n  [C\n", "3:3: ", "'[' is never closed");
  expect_error("axiom: A\rA -> B\r  [C\r", "3:3: ", "'[' is never closed");
}

TEST(ReadLSystemErrors, RefusesWhatIsNoText) {
  expect_error(std::string("axiom: A\0B", 10), "1:9: ", "control character (code 0)");
  expect_error("axiom: A\nA -> \x80", "2:6: ", "not UTF-8");
  expect_error("axiom: A\nA -> \xf0\x9f", "2:6: ", "not UTF-8");
  expect_error("axiom: \x1b[31m", "1:8: ", "control character (code 27)");
}

TEST(ReadLSystemErrors, RefusesTooMuch) {
  std::string symbols = "axiom: A";
  for (std::size_t i = 1; i < most_symbols; ++i) symbols += "A(" + repeated(i - 1, "1,") + "1)";
  EXPECT_EQ(error_of(symbols), "no error");
  expect_error(symbols + "B", "1:", "more than 256 symbols");
  expect_line_error("A -> B(" + repeated(255, "1,") + "1)", 6, "more than 255 parameters");
  expect_line_error("A -> B(" + repeated(1000, "(") + "1", 72, "nested deeper than 64");
  expect_error(std::string(2 << 20, 'A'), " is larger than", "");
  std::string many = "axiom: A\n";
  for (int i = 0; i < 70000; ++i) many += "A(x):x>" + std::to_string(i) + "->\n";
  expect_error(many.substr(0, 1 << 20), "65537:1: ", "more than 65535 productions");
}

TEST(ReadLSystemErrors, RefusesFilesThatAreNone) {
  EXPECT_THROW(read_lsystem("/no/such/file.lsys"), InputError);
  EXPECT_THROW(read_lsystem("/"), InputError);
  const auto file = std::filesystem::path(testing::TempDir()) / "large.lsys";
  std::ofstream(file) << std::string(2 << 20, ' ');
  EXPECT_THROW(read_lsystem(file), InputError);
  std::ofstream(file) << "axiom: A\nA -> AB";
  EXPECT_EQ(read_lsystem(file).productions.size(), 1u);
  std::filesystem::remove(file);
}

/// Whether it is one: anything else than an L-system or an InputError of one line fails the test.
bool is_lsystem(const std::string& text) {
  try {
    parse_lsystem(text, "test");
    return true;
  } catch (const InputError& error) {
    EXPECT_EQ(std::string_view(error.what()).find('\n'), std::string_view::npos) << error.what();
    return false;
  }
}

constexpr const char* whole_systems[] = {stochastic_system, query_system, bush_system,
                                         expression_system};

TEST(ReadLSystemLaw, EveryBeginningIsReadOrRefused) {
  for (const std::string text : whole_systems) {
    EXPECT_TRUE(is_lsystem(text)) << error_of(text);
    for (std::size_t length = 0; length < text.size(); ++length) is_lsystem(text.substr(0, length));
  }
}

TEST(ReadLSystemLaw, EveryTextWithOneByteLessOrMoreIsReadOrRefused) {
  const std::string strange = std::string("\0\n\r\t \x80\xff()[]{}<>:;,=-*/^!?#&|0aA.~", 34);
  for (const std::string text : whole_systems)
    for (std::size_t at = 0; at < text.size(); ++at) {
      std::string changed = text;
      is_lsystem(changed.erase(at, 1));
      for (const char c : strange) {
        changed = text;
        changed[at] = c;
        is_lsystem(changed);
        is_lsystem(changed.insert(at, 1, text[at]));
      }
    }
}

TEST(ReadLSystemLaw, SwappedHalvesAreReadOrRefused) {
  for (const std::string text : whole_systems)
    for (std::size_t at = 0; at < text.size(); ++at)
      is_lsystem(text.substr(at) + text.substr(0, at));
}

}  // namespace
}  // namespace phytobench
