// SPDX-License-Identifier: MIT
#include "core/lsystem/derive.hpp"

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "core/contract/errors.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/test_lsystems.hpp"

namespace phytobench {
namespace {

using Words = std::vector<std::string>;

Word derived(const LSystem& system, int steps) {
  DeriveOptions options;
  options.steps = steps;
  return derive(system, options);
}

std::string word_after(const std::string& text, int steps) {
  const LSystem system = parsed(text);
  return text_of(system, derived(system, steps));
}

/// The words of steps 0, 1, ..., each derived from the axiom.
Words words_of(const std::string& text, int steps) {
  Words words;
  for (int step = 0; step <= steps; ++step) words.push_back(word_after(text, step));
  return words;
}

/// What derive() says when it refuses.
std::string refusal(const std::string& text, const DeriveOptions& options) {
  const LSystem system = parsed(text);
  try {
    derive(system, options);
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}

std::string refusal(const std::string& text, int steps) {
  DeriveOptions options;
  options.steps = steps;
  return refusal(text, options);
}

bool contains(const std::string& text, const std::string& part) {
  return text.find(part) != std::string::npos;
}

const std::string anabaena =
    "alphabet: ar al br bl\naxiom: ar\n"
    "p1: ar -> al br\np2: al -> bl ar\np3: br -> ar\np4: bl -> al\n";

// [Liebemann2017] eq. 2.1.
TEST(DeriveWords, Anabaena) {
  EXPECT_EQ(words_of(anabaena, 5),
            (Words{"ar", "al br", "bl ar ar", "al al br al br", "bl ar bl ar ar bl ar ar",
                   "al al br al al br al br al al br al br"}));
}

TEST(DeriveWords, AnabaenaHasFibonacciLengths) {
  const LSystem system = parsed(anabaena);
  std::size_t length = 1, next = 2;
  for (int step = 0; step <= 12; ++step) {
    EXPECT_EQ(derived(system, step).size(), length);
    length = std::exchange(next, length + next);
  }
}

// [Liebemann2017] eq. 2.2: A(n + 1, 2^n), and the B of step k with 2^(k-1) + n - k and n - k times
// C behind it.
TEST(DeriveWords, ParametricSystem) {
  const std::string text =
      "axiom: A(1, 1)\np1: A(x, y) -> A(x + 1, y * 2)B(y)\np2: B(x) -> B(x + 1)C\n";
  EXPECT_EQ(words_of(text, 4), (Words{"A(1,1)", "A(2,2)B(1)", "A(3,4)B(2)B(2)C",
                                      "A(4,8)B(4)B(3)CB(3)CC", "A(5,16)B(8)B(5)CB(4)CCB(4)CCC"}));
  for (int n = 0; n <= 12; ++n) {
    std::string word = "A(" + std::to_string(n + 1) + "," + std::to_string(1 << n) + ")";
    for (int k = n; k >= 1; --k)
      word += "B(" + std::to_string((1 << (k - 1)) + n - k) + ")" +
              std::string(static_cast<std::size_t>(n - k), 'C');
    EXPECT_EQ(word_after(text, n), word) << n;
    EXPECT_EQ(derived(parsed(text), n).size(), static_cast<std::size_t>(1 + n + n * (n - 1) / 2));
  }
}

// [Brzoska2019] eq. 4.
TEST(DeriveWords, FibonacciWords) {
  EXPECT_EQ(words_of("axiom: b\nb -> a\na -> ab\n", 5),
            (Words{"b", "a", "ab", "aba", "abaab", "abaababa"}));
}

// [Brzoska2019] eq. 5: 8, 36, 148, ... modules.
TEST(DeriveWords, KochHasItsLengths) {
  const LSystem system = parsed("axiom: F\nF -> F+F--F+F\n");
  EXPECT_EQ(text_of(system, derived(system, 2)), "F+F--F+F+F+F--F+F--F+F--F+F+F+F--F+F");
  std::size_t segments = 1;
  for (int n = 0; n <= 6; ++n, segments *= 4) {
    const Word word = derived(system, n);
    EXPECT_EQ(symbol_counts(system, word)[*find_symbol(system, "F", 0)], segments);
    EXPECT_EQ(word.size(), segments + 4 * (segments - 1) / 3);
  }
}

TEST(Derive, KeepsSymbolsWithoutProduction) {
  EXPECT_EQ(word_after("axiom: F+(30)X[?P(0,0)]C\nF -> FF\n", 2), "FFFF+(30)X[?P(0,4)]C");
  EXPECT_EQ(word_after("axiom: AB(2.5)\n", 7), "AB(2.5)");
}

// [Liebemann2017] sec. 2.2.1.
TEST(Derive, MatchesLetterAndArity) {
  EXPECT_EQ(word_after("axiom: A(1)A(1,2,3)AA(1,2)\nA(x, y) -> B\n", 1), "A(1)A(1,2,3)AB");
}

TEST(Derive, ReplacesAllModulesAtOnce) {
  EXPECT_EQ(words_of("axiom: ABAB\nA -> B\nB -> A\n", 2), (Words{"ABAB", "BABA", "ABAB"}));
}

TEST(Derive, ErasesModules) {
  EXPECT_EQ(words_of("axiom: aBa\na -> \nB -> BB\n", 2), (Words{"aBa", "BB", "BBBB"}));
  EXPECT_EQ(word_after("axiom: a\na -> *\n", 3), "");
  EXPECT_EQ(word_after("axiom: a(1)\na(x) -> *\n", 3), "");
  EXPECT_EQ(word_after("axiom: a(1)\na(x) : x > 0 -> *\n", 3), "");
}

TEST(Derive, TriesProductionsInTheOrderOfTheText) {
  const std::string text = "axiom: A(1)A(5)A(9)\nA(x) : x < 4 -> S\nA(x) : x < 8 -> M\nA(x) -> L\n";
  EXPECT_EQ(word_after(text, 1), "SML");
}

TEST(Derive, StaysWithoutAFittingCondition) {
  EXPECT_EQ(word_after("axiom: A(0)\nA(x) : x < 3 -> A(x + 1)\n", 9), "A(3)");
}

TEST(Derive, TakesEveryValueButZeroForTrue) {
  EXPECT_EQ(word_after("axiom: A(-0.5)A(0)\nA(x) : x -> B\n", 1), "BA(0)");
}

TEST(Derive, PrefersProductionsWithContexts) {
  EXPECT_EQ(word_after("axiom: BAA\nA -> C\nB < A -> D\n", 1), "BDC");
}

TEST(Derive, WritesParametersOfEveryForm) {
  const std::string text =
      "axiom: A(3, 5)\nA(x, y) -> B(7, y, x + 1, y - 2, x * 2, y / 2, -x, x * y + 1, x ^ y)C\n";
  EXPECT_EQ(word_after(text, 1), "B(7,5,4,3,6,2.5,-3,16,243)C");
}

TEST(Derive, GivesParametersToModulesThatHadNone) {
  EXPECT_EQ(word_after("axiom: AAB(2)A\nA -> C(1, -4)\n", 1), "C(1,-4)C(1,-4)B(2)C(1,-4)");
}

TEST(Derive, AnswersQueries) {  // [Alsweis] sec. 3.4, L-System2
  const std::string text = "axiom: A\nA -> F(1)?P(x, y)-A\nF(k) -> F(k + 1)\n";
  EXPECT_EQ(words_of(text, 3), (Words{"A", "F(1)?P(0,1)-A", "F(2)?P(0,2)-F(1)?P(1,2)-A",
                                      "F(3)?P(0,3)-F(2)?P(2,3)-F(1)?P(2,2)-A"}));
}

TEST(Derive, LetsProductionsUseTheAnswers) {
  EXPECT_EQ(word_after("axiom: F(3)?P(0, 0)\n?P(x, y) -> B(x, y)\n", 1), "F(3)B(0,3)");
}

TEST(Derive, GivesEveryModuleAndStepRandomNumbersOfItsOwn) {
  const ExpressionRandom place = random_place_of(7, 3, 5);
  EXPECT_EQ(place.seed, 7u);
  EXPECT_EQ(place.stream, 7u);  // 2 * step + 1: the even ones choose productions
  EXPECT_EQ(place.index, 1280u);
}

TEST(Derive, ShowsEveryWord) {
  const LSystem system = parsed("axiom: F\nF -> FF\n");
  Words words;
  std::vector<int> steps;
  DeriveOptions options;
  options.steps = 3;
  options.each_word = [&](int step, const Word& word) {
    steps.push_back(step);
    words.push_back(text_of(system, word));
  };
  derive(system, options);
  EXPECT_EQ(steps, (std::vector<int>{0, 1, 2, 3}));
  EXPECT_EQ(words, (Words{"F", "FF", "FFFF", "FFFFFFFF"}));
}

TEST(Derive, CanBeInterrupted) {
  for (const char* text : {"axiom: F\nF -> F+F\n", "axiom: F(1)\nF(x) -> F(x)F(x)\n",
                           "axiom: F(1)\nF(x) : x > 0 -> F(x)F(x)\n"}) {
    const LSystem system = parsed(text);
    DeriveOptions options;
    options.steps = 20;
    int last = 0;
    options.go_on = [&](int step) {
      EXPECT_GE(step, 1);
      last = step;
      return step < 18;
    };
    EXPECT_THROW(derive(system, options), Interrupted) << text;
    EXPECT_GE(last, 18);
  }
}

TEST(Derive, AsksOftenWithinALongStep) {
  const LSystem system = parsed("axiom: F\np1 : F : 1 > 0 -> FF\n");
  DeriveOptions options;
  options.steps = 24;
  std::size_t asked_in_last_step = 0;
  options.go_on = [&](int step) {
    asked_in_last_step += step == 24 ? 1u : 0u;
    return true;
  };
  derive(system, options);
  EXPECT_GE(asked_in_last_step, 3u);
}

TEST(DeriveRefuses, LongWordsOfFixedSuccessorsAtOnce) {
  DeriveOptions options;
  options.steps = 1000;
  options.most_modules = 1000;
  int words = 0;
  options.each_word = [&](int, const Word&) { ++words; };
  const std::string message = refusal("axiom: F\nF -> FF\n", options);
  EXPECT_TRUE(contains(message, "test.lsys: the word of step 10 would have 1024 modules"))
      << message;
  EXPECT_TRUE(contains(message, "the 1000 allowed; 9 is the greatest")) << message;
  EXPECT_EQ(words, 0);
}

TEST(DeriveRefuses, EndlessGrowthWithoutMakingWords) {
  for (const char* growth : {"F -> FF\n", "F -> FFFFFFFFFFFFFFFFFFFF\n", "F -> F[+F]F\n"}) {
    const std::string message = refusal(std::string("axiom: F\n") + growth, 2'000'000'000);
    EXPECT_TRUE(contains(message, "more than the 100000000 allowed")) << message;
  }
}

TEST(DeriveRefuses, LongWordsOfOtherSystemsBeforeTheyAreMade) {
  DeriveOptions options;
  options.steps = 100;
  options.most_modules = 1000;
  std::size_t longest = 0;
  options.each_word = [&](int, const Word& word) { longest = std::max(longest, word.size()); };
  for (const char* growth :
       {"F(x) : x > 0 -> F(x)F(x)\n", "F(x) -> F(x)F(x) : 0.5\nF(x) -> F(x)F(x) : 0.5\n",
        "G < F(x) -> F(x)F(x)\nF(x) -> F(x)F(x)\n"}) {
    const std::string message = refusal(std::string("axiom: F(1)\n") + growth, options);
    EXPECT_TRUE(contains(message, "step 10 would have 1024 modules")) << message;
    EXPECT_EQ(longest, 512u);
  }
}

TEST(DeriveRefuses, ExactlyWhatIsTooLong) {
  DeriveOptions options;
  options.steps = 10;
  options.most_modules = 1024;
  EXPECT_EQ(refusal("axiom: F\nF -> FF\n", options), "");
  options.most_modules = 1023;
  EXPECT_NE(refusal("axiom: F\nF -> FF\n", options), "");
}

TEST(DeriveRefuses, ManyParameters) {
  DeriveOptions options;
  options.steps = 3;
  options.most_parameters = 20;
  const std::string message = refusal("axiom: F(1,2,3)\nF(x,y,z) -> F(x,y,z)F(x,y,z)\n", options);
  EXPECT_TRUE(contains(message, "step 3 would have 24 parameters, more than the 20")) << message;
}

TEST(DeriveRefuses, AxiomsThatAreTooLong) {
  DeriveOptions options;
  options.most_modules = 2;
  EXPECT_TRUE(contains(refusal("axiom: FFF\n", options), "step 0 would have 3 modules"));
  EXPECT_TRUE(contains(refusal("axiom: FFF\n", options), "not even the axiom fits"));
}

TEST(DeriveRefuses, DivisionByZeroNamingTheProduction) {
  const std::string message =
      refusal("axiom: B(2)A(1)\np1: B(x) -> B(x)\nshrink: A(x) -> C(0)A(x - 1, 1 / (x - 1))\n", 1);
  EXPECT_TRUE(contains(message, "test.lsys:3:9: shrink makes A(0,inf) of A(1)")) << message;
  EXPECT_TRUE(contains(message, "module 2 of the word before step 1")) << message;
  EXPECT_FALSE(contains(message, "\n"));
}

TEST(DeriveRefuses, TheStepInWhichItHappens) {
  EXPECT_TRUE(contains(refusal("axiom: A(3)\np: A(x) -> A(x - 1)B(1 / x)\n", 9), "before step 4"));
  EXPECT_TRUE(contains(refusal("axiom: A(1e300)\np: A(x) -> A(x * 1e5)\n", 9), "before step 2"));
}

TEST(DeriveRefuses, ParametersThatAreNoNumbers) {
  EXPECT_TRUE(contains(refusal("axiom: A(-1)\nA(x) -> A(sqrt(x))\n", 1), "A("));
  EXPECT_TRUE(contains(refusal("axiom: A(-1)B\nA(x) > B -> A(sqrt(x))\n", 1), "p1 makes"));
  EXPECT_TRUE(contains(refusal("axiom: C(0)A(-1)B\nC(y) < A(x) > B -> A(x / y)\n", 1),
                       "p1 makes A(-inf) of A(-1)"));
}

TEST(DeriveRefuses, ConditionsWithoutAValue) {
  const std::string message = refusal("axiom: B(0)A(0)\np7: A(x) : 1 / x -> B(0)\n", 1);
  EXPECT_TRUE(
      contains(message, "test.lsys:2:5: p7 has a condition without a finite value for A(0)"))
      << message;
  EXPECT_TRUE(contains(message, "module 2 of the word before step 1")) << message;
}

TEST(DeriveRefuses, ConditionsThatCompareWithWhatIsNoNumber) {
  for (const char* condition : {"1 / x < 2", "x / x == 1", "x == 0 && sqrt(x - 1) < 2"}) {
    const std::string message =
        refusal(std::string("axiom: B(0)A(0)\np7: A(x) : ") + condition + " -> B(0)\n", 1);
    EXPECT_TRUE(
        contains(message, "test.lsys:2:5: p7 has a condition without a finite value for A(0)"))
        << message;
  }
  EXPECT_EQ(refusal("axiom: A(0)\nA(x) : x > 0 && 1 / x < 2 -> B\n", 1), "");
}

TEST(DeriveRefuses, TheFirstFaultWithAnyNumberOfThreads) {
  std::string text = "axiom: ";
  for (int i = 0; i < 60'000; ++i) text += i == 30'000 || i == 50'000 ? "A(0)" : "A(1)";
  for (const char* production : {"\np: A(x) -> A(1 / x)\n", "\np: A(x) : 1 / x -> A(x)\n"})
    for (const int threads : {1, 2, 7}) {
      DeriveOptions options;
      options.steps = 1;
      options.threads = threads;
      const std::string message = refusal(text + production, options);
      EXPECT_TRUE(contains(message, "module 30001 of the word before step 1")) << message;
    }
}

TEST(DeriveRefuses, NestedContextsBeyondReason) {
  const std::string deep = std::string(100, '[') + "A" + std::string(100, ']');
  EXPECT_TRUE(
      contains(refusal("axiom: A\np: A > " + deep + " -> B\n", 1), "test.lsys:2:4: p nests"));
}

}  // namespace
}  // namespace phytobench
