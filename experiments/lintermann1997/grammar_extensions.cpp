// SPDX-License-Identifier: MIT
// Sec. 2.1: what parameters, chance and context add to L-systems.
#include <algorithm>
#include <set>
#include <string>

#include "core/lsystem/drawing.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr int steps = 8;

/// Segments of how many lengths a word of that system draws.
std::int64_t lengths(const std::string& text) {
  const LSystem system = parse_lsystem(text, "example");
  std::set<double> different;
  for (const TurtleSegment& segment : draw(system, derived(system, steps)).segments)
    different.insert(norm(segment.to - segment.from));
  return static_cast<std::int64_t>(different.size());
}

/// Different words of the seeds that begin with the run's.
void record_words(ExperimentContext& context, const std::string& text, const std::string& name) {
  constexpr std::int64_t seeds = 20;
  const LSystem system = parse_lsystem(text, "example");
  std::set<std::string> words;
  std::int64_t not_repeated = 0;
  for (std::uint64_t i = 0; i < seeds; ++i) {
    const std::string word = text_of(system, derived(system, steps, context.seed() + i));
    not_repeated += word != text_of(system, derived(system, steps, context.seed() + i));
    words.insert(word);
  }
  Record different{.experiment = {},
                   .measurement = name + "/different_words",
                   .value = static_cast<std::int64_t>(words.size())};
  different.sample_size = seeds;
  different.seed = context.seed();
  context.record(different);
  context.record(name + "/words_that_their_seed_does_not_repeat", not_repeated);
}

/// Steps in which the signal b is not exactly one letter further to the right.
std::int64_t lost_signals() {
  const LSystem system = parse_lsystem("axiom: baaaaaaaaa\nb < a -> b\nb -> a\n", "signal");
  std::int64_t lost = 0;
  for (int n = 0; n <= steps; ++n) {
    const std::string word = text_of(system, derived(system, n));
    lost += std::count(word.begin(), word.end(), 'b') != 1 ||
            word.find('b') != static_cast<std::size_t>(n);
  }
  return lost;
}

void run(ExperimentContext& context) {
  context.record("parameters/lengths_of_lines", lengths("axiom: A(1)\nA(l) -> F(l)A(l * 2)\n"));
  context.record("no_parameters/lengths_of_lines", lengths("axiom: A\nA -> FA\n"));
  record_words(context, "axiom: A\nA -> F[+A]A : 0.5\nA -> F[-A]A : 0.5\n", "chance");
  record_words(context, "axiom: A\nA -> F[+A]A\n", "no_chance");
  context.record("context/steps_without_the_signal", lost_signals());
}

}  // namespace

extern const ExperimentDescriptor grammar_extensions;
constinit const ExperimentDescriptor grammar_extensions{
    .id = "lintermann1997/grammar-extensions",
    .question = "What do parameters, chance and context add to L-systems?",
    .source = "[Lintermann1997] sec. 2.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
