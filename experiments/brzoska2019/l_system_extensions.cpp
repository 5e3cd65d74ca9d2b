// SPDX-License-Identifier: MIT
// The three extensions that sec. 3.4.2 names, each tried on the smallest system that shows what is
// said of it, and all of them in one system.
#include <cmath>
#include <map>
#include <set>
#include <string>

#include <fmt/format.h>

#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

int draws_of(Tier tier) {
  return tier == Tier::full ? 100'000 : tier == Tier::quick ? 20'000 : 5'000;
}

Word drawn_by_seed(const LSystem& system, int steps, std::uint64_t seed) {
  DeriveOptions options;
  options.steps = steps;
  options.seed = seed;
  return derive(system, options);
}

void record_of_draws(ExperimentContext& context, const std::string& name, double value, int draws,
                     const std::string& unit) {
  context.record({.experiment = {},
                  .measurement = name,
                  .value = value,
                  .unit = unit,
                  .sample_size = draws,
                  .seed = context.seed()});
}

/// One system, two successors: which words come, and how often by their probabilities.
void record_stochastic(ExperimentContext& context) {
  const LSystem system = thesis_l_system("axiom: F\nF -> F[+F]F : 0.3\nF -> F[-F]F : 0.7\n");
  const int draws = draws_of(context.tier());
  std::map<std::string, int> times;
  for (int i = 0; i < draws; ++i) {
    if (i % 1000 == 0) context.progress(fmt::format("word {} of {}", i, draws));
    const std::uint64_t seed = (context.seed() << 32) + static_cast<std::uint64_t>(i);
    ++times[text_of(system, drawn_by_seed(system, 1, seed))];
  }
  record_of_draws(context, "stochastic/successors", static_cast<double>(times.size()), draws,
                  "words");
  const double expected = 0.3 * draws;
  record_of_draws(context, "stochastic/deviation",
                  (times["F[+F]F"] - expected) / std::sqrt(0.7 * expected), draws,
                  "standard errors");
  std::set<std::string> plants;
  for (std::uint64_t seed = 0; seed < 100; ++seed)
    plants.insert(text_of(system, drawn_by_seed(system, 4, context.seed() + seed)));
  record_of_draws(context, "stochastic/different_plants", static_cast<double>(plants.size()), 100,
                  "plants");
}

/// Whether `letters` become `becomes` in one step.
std::int64_t becomes(const std::string& production, const std::string& letters,
                     const std::string& word) {
  return word_after(thesis_l_system("axiom: " + letters + "\n" + production + "\n"), 1) == word;
}

void record_contexts(ExperimentContext& context) {
  const auto record = [&](const std::string& name, const std::string& production,
                          const std::string& letters, const std::string& word) {
    context.record("contexts/" + name, becomes(production, letters, word));
  };
  record("left_present", "l < a -> b", "la", "lb");
  record("left_missing", "l < a -> b", "xa", "xa");
  record("right_present", "a > r -> b", "ar", "br");
  record("right_missing", "a > r -> b", "ax", "ax");
  record("both_present", "l < a > r -> b", "lar", "lbr");
  record("one_of_both", "l < a > r -> b", "lax", "lax");
  // A signal that goes up a stem, a letter in each step, and into its branches.
  const LSystem signal = thesis_l_system("axiom: bc[cc]cc\nb < c -> b\nb -> a\nignore: a\n");
  for (int n = 1; n <= 3; ++n)
    context.record(fmt::format("contexts/signal-{}", n), word_after(signal, n));
}

void record_parameters(ExperimentContext& context) {
  const LSystem growing = thesis_l_system("axiom: F(1)\nF(x) -> F(x / 2)[+(10 * x)F(2 * x)]\n");
  for (int n = 0; n <= 2; ++n)
    context.record(fmt::format("parameters/n-{}", n), word_after(growing, n));
}

/// All in one system: chance, neighbours and numbers.
void record_combination(ExperimentContext& context) {
  const LSystem system = thesis_l_system(
      "axiom: R(1)A(1)\nA(x) -> F(x)A(x * 2) : 0.5\nA(x) -> F(x)B(x) : 0.5\n"
      "R(r) < F(x) : x < 4 -> F(x + r)\n");
  const LSystemKind kind = kind_of(system);
  context.record("combination/kinds",
                 std::int64_t{kind.stochastic} + kind.contextual + kind.parametric, "kinds");
  std::set<std::string> words;
  std::int64_t first_grown = 0;
  for (std::uint64_t seed = 0; seed < 64; ++seed) {
    const std::string word = text_of(system, drawn_by_seed(system, 4, context.seed() + seed));
    words.insert(word);
    first_grown += word.starts_with("R(1)F(4)");
  }
  context.record("combination/different_words", whole(words.size()), "words");
  context.record("combination/first_grown", first_grown, "words");
}

void run(ExperimentContext& context) {
  record_stochastic(context);
  record_contexts(context);
  record_parameters(context);
  record_combination(context);
}

}  // namespace

extern const ExperimentDescriptor l_system_extensions;
constinit const ExperimentDescriptor l_system_extensions{
    .id = "brzoska2019/l-system-extensions",
    .question = "Do chance, neighbours and numbers in L-systems do what the thesis says?",
    .source = "[Brzoska2019] sec. 3.4.2",
    .seconds = {0.1, 0.3, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
