// SPDX-License-Identifier: MIT
#include <algorithm>
#include <map>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "core/lsystem/derive.hpp"
#include "core/lsystem/literal_derivation.hpp"
#include "core/lsystem/random_lsystems.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "core/lsystem/test_lsystems.hpp"

namespace phytobench {
namespace {

Word word_of(const LSystem& system, int steps, std::uint64_t seed = 0, int threads = 1) {
  DeriveOptions options;
  options.steps = steps;
  options.seed = seed;
  options.threads = threads;
  return derive(system, options);
}

std::string text_after(const std::string& text, int steps) {
  const LSystem system = parsed(text);
  return text_of(system, word_of(system, steps));
}

/// Systems whose words after the steps given fill many blocks.
struct LargeSystem {
  const char* name;
  const char* text;
  int steps;
};
const LargeSystem large_systems[] = {
    {"d0l", "axiom: F\nF -> F+F--F+F\n", 9},
    {"uneven", "axiom: AB\nA -> ABBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBBC\nB -> BA\nC -> *\n", 6},
    {"parametric", "axiom: A(1, 2)\nA(x, y) -> A(x + 1, y / 3)[+(y)B(x * 0.5)]A(y, x - y)C\n", 15},
    {"random calls", "axiom: A(1)\nA(x) -> A(random(0, x))+(random(-1, 1))A(x)\n", 16},
    {"conditional", "axiom: A(14)\nA(x) : x > 1 -> A(x * 0.9)B(x)A(x - 0.5)\nB(x) -> B(x + 1)\n",
     17},
    {"stochastic", "axiom: A\nA -> AA : 0.7\nA -> A[B]A : 0.3\n", 18},
    {"contextual",
     "ignore: +\naxiom: A(1)B(2)A(3)\n"
     "A(x) < B(y) > A(z) -> B(x / 2)[+A(z / 3)]A(y / 2)B(z / 2)\nB(x) > [A(y)] -> A(y)B(x)A(x)\n"
     "A(x) -> A(x)[+B(1)]B(x / 2)\n",
     16},
};

TEST(DeriveLaw, WordsAreTheSameForAnyNumberOfThreads) {
  for (const LargeSystem& large : large_systems) {
    const LSystem system = parsed(large.text);
    const Word alone = word_of(system, large.steps, 5);
    EXPECT_GT(alone.size(), 100'000u) << large.name;
    const std::string hash = word_hash(system, alone);
    for (const int threads : {2, 3, 7})
      EXPECT_EQ(word_hash(system, word_of(system, large.steps, 5, threads)), hash)
          << large.name << ", " << threads << " threads";
  }
}

/// Hashes of words derived literally and by derive(), after as many steps as stay short.
std::pair<std::string, std::string> both_ways(const std::string& text, std::uint64_t seed) {
  const LSystem system = parsed(text);
  LiteralDerivation literal(system, seed);
  int steps = 0;
  while (steps < 8 && literal.word().size() < 1500) {
    literal.step();
    ++steps;
  }
  return {word_hash(system, literal_word_of(system, steps, seed)),
          word_hash(system, word_of(system, steps, seed))};
}

TEST(DeriveLaw, RandomSystemsAreDerivedAsDefined) {
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    RandomSystemOptions options;
    options.parametric = (seed & 1) != 0;
    options.contexts = (seed & 2) != 0;
    options.probabilities = (seed & 4) != 0;
    options.conditional = (seed & 8) != 0;
    options.random_calls = (seed & 16) != 0;
    const std::string text = RandomSystem(seed, options).text();
    const auto [literal, fast] = both_ways(text, seed);
    EXPECT_EQ(literal, fast) << text;
  }
}

TEST(DeriveLaw, LongWordsAreDerivedAsDefined) {
  for (const LargeSystem& large : large_systems) {
    const LSystem system = parsed(large.text);
    EXPECT_EQ(word_hash(system, literal_word_of(system, large.steps, 5)),
              word_hash(system, word_of(system, large.steps, 5, 2)))
        << large.name;
  }
}

TEST(DeriveLaw, TheLiteralDerivationTellsSystemsApart) {
  const LSystem right = parsed("axiom: AB[C]\nA > B[C] -> CA\nB -> BB\n");
  const LSystem wrong = parsed("axiom: AB[C]\nA > [C] -> CA\nB -> BB\n");
  EXPECT_EQ(word_hash(right, literal_word_of(right, 2, 0)), word_hash(right, word_of(right, 2)));
  EXPECT_NE(word_hash(right, literal_word_of(right, 2, 0)), word_hash(wrong, word_of(wrong, 2)));
}

TEST(DeriveLaw, ManyStepsAtOnceGiveTheWordOfEachStep) {
  for (std::uint64_t seed = 0; seed < 300; ++seed) {
    const std::string text = RandomSystem(seed, {}).text();
    const LSystem system = parsed(text);
    DeriveOptions options;
    options.steps = 7;
    std::vector<std::string> words;
    options.each_word = [&](int, const Word& word) { words.push_back(word_hash(system, word)); };
    derive(system, options);
    for (int step = 0; step <= 7; ++step)
      ASSERT_EQ(word_hash(system, word_of(system, step)), words[static_cast<std::size_t>(step)])
          << text;
  }
}

TEST(DeriveLaw, ManyStepsAtOnceGiveLongWords) {
  for (const LargeSystem& large : large_systems) {
    const LSystem system = parsed(large.text);
    DeriveOptions options;
    options.steps = large.steps;
    options.seed = 5;
    std::string last;
    options.each_word = [&](int, const Word& word) { last = word_hash(system, word); };
    derive(system, options);
    EXPECT_EQ(word_hash(system, word_of(system, large.steps, 5)), last) << large.name;
  }
}

// A pass of one production after the other would give AAAA; one from left to right abb.
TEST(DeriveLaw, RewritingIsParallel) {
  EXPECT_EQ(text_after("axiom: ABAB\nA -> B\nB -> A\n", 1), "BABA");
  EXPECT_EQ(text_after("axiom: ABAB\nB -> A\nA -> B\n", 1), "BABA");
  EXPECT_EQ(text_after("axiom: b\nb -> a\na -> ab\n", 1), "a");
  EXPECT_EQ(text_after("axiom: ab\na -> ab\nb -> a\n", 1), "aba");
}

TEST(DeriveLaw, ContextFreeWordsAreWordsOfTheirPieces) {
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    RandomSystemOptions options;
    options.parametric = (seed & 1) != 0;
    options.conditional = (seed & 2) != 0;
    RandomSystem random(seed, options);
    const std::string productions = RandomSystem::productions_in(random.text());
    const std::string x = random.word(), y = random.word();
    const auto word = [&](const std::string& axiom) {
      return text_after("axiom: " + axiom + "\n" + productions, 5);
    };
    EXPECT_EQ(word(x + y), word(x) + word(y)) << productions;
  }
}

TEST(DeriveLaw, SystemsWithoutProductionsKeepTheirAxiom) {
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    RandomSystemOptions options;
    options.parametric = (seed & 1) != 0;
    const std::string axiom = "axiom: " + RandomSystem(seed, options).word() + "\n";
    EXPECT_EQ(text_after(axiom, 9), text_after(axiom, 0));
  }
}

// [Alsweis] sec. 3.2, L-System1.
const std::string stochastic_text =
    "axiom: A(1)B(3)A(5)\n"
    "p1: A(x) -> A(x + 1) : 0.4\np2: A(x) -> B(x - 1) : 0.6\n"
    "p3: A(x) < B(y) > A(z) : y < 4 -> B(x + z)[A(y)]\n";

using Chances = std::map<std::string, double>;

/// What an A becomes in so many steps: it lives on with 0.4, or turns into a B that stays.
Chances fates(int value, int steps) {
  Chances chances;
  double alive = 1.0;
  for (int step = 0; step < steps; ++step, alive *= 0.4)
    chances["B(" + std::to_string(value + step - 1) + ")"] = alive * 0.6;
  chances["A(" + std::to_string(value + steps) + ")"] = alive;
  return chances;
}

/// p3 fires in the first step and never again: its B is 6 then, and the A that it makes one step
/// younger.
Chances exact_outcomes(int steps) {
  Chances outcomes;
  for (const auto& [first, p] : fates(1, steps))
    for (const auto& [inner, q] : fates(3, steps - 1))
      for (const auto& [last, r] : fates(5, steps))
        outcomes[first + "B(6)[" + inner + "]" + last] = p * q * r;
  return outcomes;
}

/// Pearson's statistic of 20,000 seeds; fails if something occurs that has no chance.
double chi_square(int steps, const Chances& chances) {
  constexpr int seeds = 20'000;
  const LSystem system = parsed(stochastic_text);
  std::map<std::string, int> counts;
  for (int seed = 0; seed < seeds; ++seed)
    ++counts[text_of(system, word_of(system, steps, static_cast<std::uint64_t>(seed)))];
  double statistic = 0.0;
  for (const auto& [outcome, chance] : chances) {
    const double expected = seeds * chance;
    statistic += (counts[outcome] - expected) * (counts[outcome] - expected) / expected;
  }
  EXPECT_EQ(counts.size(), chances.size());
  return statistic;
}

TEST(DeriveLaw, OneStepHasItsFourOutcomes) {
  const Chances exact = exact_outcomes(1);
  EXPECT_EQ(exact.size(), 4u);
  EXPECT_NEAR(exact.at("B(0)B(6)[A(3)]B(4)"), 0.36, 1e-15);
  EXPECT_NEAR(exact.at("A(2)B(6)[A(3)]A(6)"), 0.16, 1e-15);
  EXPECT_LT(chi_square(1, exact), 16.27);  // 1 in 1000 with 3 degrees of freedom
}

TEST(DeriveLaw, TwoStepsHaveTheirEighteenOutcomes) {
  const Chances exact = exact_outcomes(2);
  EXPECT_EQ(exact.size(), 18u);
  EXPECT_NEAR(exact.at("B(0)B(6)[B(2)]B(4)"), 27.0 / 125.0, 1e-15);
  EXPECT_NEAR(exact.at("A(3)B(6)[A(4)]A(7)"), 32.0 / 3125.0, 1e-15);
  EXPECT_LT(chi_square(2, exact), 40.79);  // 1 in 1000 with 17 degrees of freedom
}

TEST(DeriveLaw, TheTestOfChancesSeesWrongOnes) {
  Chances wrong = exact_outcomes(1);
  wrong.at("B(0)B(6)[A(3)]B(4)") -= 0.02;
  wrong.at("A(2)B(6)[A(3)]A(6)") += 0.02;
  EXPECT_GT(chi_square(1, wrong), 16.27);
}

TEST(DeriveLaw, TheProductionWithContextsFiresOnce) {
  const LSystem system = parsed(stochastic_text);
  for (std::uint64_t seed = 0; seed < 200; ++seed) {
    const std::string word = text_of(system, word_of(system, 5, seed));
    EXPECT_EQ(std::count(word.begin(), word.end(), '['), 1) << word;
    EXPECT_NE(word.find("B(6)["), std::string::npos) << word;
  }
}

TEST(DeriveLaw, LargeGroupsKeepTheirProbabilities) {
  const LSystem system = parsed("axiom: " + std::string(10'000, 'A') +
                                "\nA -> B : 0.2\nA -> C : 0.5\nA -> D : 0.05\nA -> E : 0.25\n");
  const std::string word = text_of(system, word_of(system, 1));
  double statistic = 0.0;
  for (const auto& [letter, expected] :
       std::map<char, double>{{'B', 2000.0}, {'C', 5000.0}, {'D', 500.0}, {'E', 2500.0}}) {
    const double count = static_cast<double>(std::count(word.begin(), word.end(), letter));
    statistic += (count - expected) * (count - expected) / expected;
  }
  EXPECT_LT(statistic, 16.27);  // 1 in 1000 with 3 degrees of freedom
}

TEST(DeriveLaw, ChoicesOfModulesAndStepsAreIndependent) {
  // Of a thousand modules in a row about half go each way, and the next step chooses anew.
  const LSystem system = parsed("axiom: " + std::string(1000, 'A') +
                                "\nA -> B : 0.5\nA -> C : 0.5\nB -> A : 0.5\nB -> B : 0.5\n"
                                "C -> A : 0.5\nC -> C : 0.5\n");
  const std::string first = text_of(system, word_of(system, 1));
  const auto bs = std::count(first.begin(), first.end(), 'B');
  EXPECT_NEAR(static_cast<double>(bs), 500.0, 66.0);  // four standard deviations
  const std::string second = text_of(system, word_of(system, 2));
  int changed_b = 0;
  for (std::size_t i = 0; i < first.size(); ++i)
    changed_b += first[i] == 'B' && second[i] == 'A' ? 1 : 0;
  EXPECT_NEAR(changed_b, static_cast<double>(bs) / 2, 48.0);
}

TEST(DeriveLaw, TheSeedDecidesChoices) {
  const LSystem system = parsed("axiom: AAAAAAAAAAAAAAAA\nA -> B : 0.5\nA -> C : 0.5\n");
  EXPECT_EQ(text_of(system, word_of(system, 1, 1)), text_of(system, word_of(system, 1, 1)));
  EXPECT_NE(text_of(system, word_of(system, 1, 1)), text_of(system, word_of(system, 1, 2)));
}

}  // namespace
}  // namespace phytobench
