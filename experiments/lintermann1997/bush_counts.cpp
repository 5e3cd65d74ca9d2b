// SPDX-License-Identifier: MIT
// The bush of sec. 2.1: how many of each symbol the L-system has made after so many steps.
#include <map>
#include <string>

#include <fmt/format.h>

#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

namespace oracle = oracles::lintermann1997;
using Counts = std::map<std::string, std::int64_t>;

constexpr int article_step = 5;
constexpr int last_step = 7;    // of the same figure in the book
constexpr int many_steps = 20;  // counted, not derived

const std::map<std::string, std::string> names = {
    {"A", "A"},      {"F", "F"},     {"S", "S"},     {"L", "L"},
    {"{", "leaves"}, {"f", "moves"}, {"[", "pairs"}, {"!", "exclamation_marks"},
    {"'", "primes"}, {"&", "down"},  {"^", "up"},    {"+", "plus"},
    {"-", "minus"},  {"|", "bars"},
};

const std::string letters_that_grow = "AFSL{";  // those whose numbers say all others

Counts counts_of(const LSystem& system, const Word& word) {
  Counts counts;
  const std::vector<std::uint64_t> per_symbol = symbol_counts(system, word);
  for (std::size_t i = 0; i < per_symbol.size(); ++i)
    counts[system.symbols[i].letter] = static_cast<std::int64_t>(per_symbol[i]);
  return counts;
}

Counts closed_forms(int n, const BushPrint& print) {
  const auto leaves = oracle::bush_polygons(n), groups = oracle::bush_groups(n);
  std::map<std::string, oracles::Count> counts = {
      {"A", oracle::bush_A(n)},
      {"F", oracle::bush_F(n)},
      {"S", oracle::bush_S(n)},
      {"L", oracle::bush_L(n)},
      {"[", oracle::bush_pairs(n)},
      {"]", oracle::bush_pairs(n)},
      {"!", groups},
      {"&", groups},
      {"'", oracle::bush_primes(n, print)},
      {"/", oracle::bush_slashes(n, print)},
      {"{", leaves},
      {"}", leaves},
      {"^", 2 * leaves},
      {"f", 6 * leaves},
      {"+", 4 * leaves},
      {"-", 3 * leaves},
      {"|", leaves},
  };
  Counts whole;
  for (const auto& [letter, count] : counts) whole[letter] = static_cast<std::int64_t>(count);
  return whole;
}

int occurrences(const std::string& text, const std::string& part) {
  int count = 0;
  for (auto at = text.find(part); at != std::string::npos; at = text.find(part, at + part.size()))
    ++count;
  return count;
}

void count_print(ExperimentContext& context, const BushPrint& print, const std::string& name,
                 bool with_symbols) {
  const LSystem system = bush_system(print);
  std::int64_t differing_counts = 0, differing_words = 0;
  for (int n = 1; n <= last_step; ++n) {
    const Word word = derived(system, n);
    const std::string text = text_of(system, word);
    const Counts counts = counts_of(system, word);
    for (const auto& [letter, count] : closed_forms(n, print))
      differing_counts += counts.at(letter) != count;
    differing_counts += word.size() != oracle::bush_letters(n, print);
    if (n <= article_step)
      differing_words +=
          text != oracles::liebemann2017::joined(derive_in_parallel(oracle::bush(print), n));
    const std::string step = fmt::format("n-{}/", n);
    if (n == article_step || n == last_step) {
      context.record(name + step + "slashes", counts.at("/"));
      context.record(name + step + "letters", static_cast<std::int64_t>(word.size()));
    }
    if (!with_symbols) continue;
    context.record(step + "newest_groups", std::int64_t{occurrences(text, "[&FL!A]")});
    for (const auto& [letter, symbol] : names)
      if (n == article_step || n == last_step ||
          letters_that_grow.find(letter) != std::string::npos)
        context.record(step + symbol, counts.at(letter));
  }
  context.record(name + "differs_from_closed_forms", differing_counts);
  context.record(name + "differs_from_oracle_words", differing_words);
}

void run(ExperimentContext& context) {
  count_print(context, bush_of_the_book(), "slashes-5-7-5/", true);
  count_print(context, bush_as_printed(), "slashes-8-8-8/", false);

  const LSystem system = bush_system(bush_of_the_book());
  const GrowthForecast growth = *growth_forecast(system, many_steps);
  const auto count = [&](const char* letter, int n) {
    return static_cast<double>(
        growth.steps[static_cast<std::size_t>(n)].symbols[*find_symbol(system, letter, 0)]);
  };
  context.record("n-20/F_of_each_A", count("F", many_steps) / count("A", many_steps));
  context.record("n-20/F_over_F_of_step_before",
                 count("F", many_steps) / count("F", many_steps - 1));
  context.record("n-20/leaves_over_leaves_of_step_before",
                 count("{", many_steps) / count("{", many_steps - 1));
}

}  // namespace

extern const ExperimentDescriptor bush_counts;
constinit const ExperimentDescriptor bush_counts{
    .id = "lintermann1997/bush-counts",
    .question = "How many symbols of each kind has the bush after so many steps?",
    .source = "[Lintermann1997] sec. 2.1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
