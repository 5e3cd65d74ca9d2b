// SPDX-License-Identifier: MIT
// What the parts of a production decide: contexts, condition and probabilities; and what chance and
// parameters add to L-systems without them.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/alsweis/chapter_3_l_systems.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::alsweis {

namespace {

/// Probabilities of p1 and p2 that are none, or do not add up to 1.
void record_probabilities(ExperimentContext& context) {
  constexpr std::pair<const char*, const char*> bad[] = {
      {"0.4", "0.5"}, {"0.6", "0.6"}, {"0.4", "0.4"},  {"-0.4", "1.4"},
      {"0", "0"},     {"1", "1"},     {"0.4", "0.61"}, {"0.4", "0.599999"}};
  std::int64_t refused = 0;
  for (const auto& [p1, p2] : bad) refused += is_refused(l_system_1_text(p1, p2));
  context.record("probabilities/bad", whole(std::size(bad)), "systems");
  context.record("probabilities/bad_refused", refused, "systems");
  context.record("probabilities/printed_refused", std::int64_t{is_refused(l_system_1_text())});
  context.record("probabilities/others_refused",
                 std::int64_t{is_refused(l_system_1_text("0.3", "0.7"))});
}

/// Whether p3 replaces the B of an axiom.
std::int64_t p3_applies(const std::string& axiom) {
  const LSystem system = l_system(l_system_1_text("0.4", "0.6", axiom));
  return word_after(system, 1).find('[') != std::string::npos;
}

void record_parts(ExperimentContext& context) {
  context.record("p3/all_parts_fit", p3_applies("A(1)B(3)A(5)"));
  context.record("p3/no_left_neighbour", p3_applies("B(3)A(5)"));
  context.record("p3/other_left_neighbour", p3_applies("B(1)B(3)A(5)"));
  context.record("p3/no_right_neighbour", p3_applies("A(1)B(3)"));
  context.record("p3/other_right_neighbour", p3_applies("A(1)B(3)B(5)"));
  context.record("p3/condition_fails", p3_applies("A(1)B(4)A(5)"));
  context.record("p3/condition_just_holds", p3_applies("A(1)B(3.999)A(5)"));
  context.record("p3/branch_between", p3_applies("A(1)[B(9)]B(3)[B(9)]A(5)"));
}

/// Words of 50 seeds: with chance, and of a system without.
void record_chance(ExperimentContext& context) {
  const LSystem by_chance = l_system(l_system_1_text());
  const LSystem without = l_system("axiom: F\nF -> F[+F]F[-F]F\n");
  std::set<std::string> words, words_without;
  for (std::uint64_t seed = 0; seed < 50; ++seed) {
    words.insert(word_after(by_chance, 3, context.seed() + seed));
    words_without.insert(word_after(without, 3, context.seed() + seed));
  }
  context.record("chance/different_words", whole(words.size()), "words");
  context.record("chance/different_words_without", whole(words_without.size()), "words");
}

double length_of(const TurtleSegment& segment) {
  return norm(segment.to - segment.from);
}

std::int64_t different_lengths(const Drawing& drawing) {
  std::set<std::int64_t> lengths;
  for (const TurtleSegment& segment : drawing.segments)
    lengths.insert(std::llround(1e6 * length_of(segment)));
  return whole(lengths.size());
}

/// Degrees by which headings miss the multiples of 22.5.
double off_the_angle(const Drawing& drawing) {
  double largest = 0.0;
  for (const TurtleSegment& s : drawing.segments) {
    const double degrees =
        std::atan2(s.to.y - s.from.y, s.to.x - s.from.x) * 180.0 / std::acos(-1.0);
    largest = std::max(largest, std::abs(std::remainder(degrees, 22.5)));
  }
  return largest;
}

/// Lengths and headings of systems without parameters, and of one with them.
void record_parameters(ExperimentContext& context) {
  const auto record = [&](const std::string& name, const std::string& text) {
    const LSystem system = l_system(text + "angle: 22.5\n");
    const Drawing drawing = draw(system, derived(system, 3));
    context.record(fmt::format("parameters/{}/lengths", name), different_lengths(drawing),
                   "lengths");
    context.record(fmt::format("parameters/{}/off_the_angle", name), off_the_angle(drawing),
                   "degrees");
  };
  record("without", "axiom: F\nF -> F[+F]F[-F]F\n");
  record("with", "axiom: F(1)\nF(x) -> F(x)[+(17 * x)F(x / 3)]F(x / 2)\n");
}

/// A branch for each pair of brackets: ends of the tree beside pairs of its word.
void record_branches(ExperimentContext& context) {
  const LSystem system = l_system("axiom: F\nF -> F[+F]F[-F]F\nangle: 25\n");
  std::int64_t other_tips = 0;
  for (int n = 0; n <= 5; ++n) {
    const Word word = derived(system, n);
    const std::string text = text_of(system, word);
    const auto pairs = std::count(text.begin(), text.end(), '[');
    other_tips += whole(tip_count(turtle_tree(system, word).skeleton)) != pairs + 1;
  }
  context.record("brackets/words", std::int64_t{6}, "words");
  context.record("brackets/words_of_other_ends", other_tips, "words");
}

void run(ExperimentContext& context) {
  record_probabilities(context);
  record_parts(context);
  record_chance(context);
  record_parameters(context);
  record_branches(context);
}

}  // namespace

extern const ExperimentDescriptor l_system_rules;
constinit const ExperimentDescriptor l_system_rules{
    .id = "alsweis/l-system-rules",
    .question = "What do contexts, conditions, probabilities and parameters decide?",
    .source = "[Alsweis] section 3.2",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
