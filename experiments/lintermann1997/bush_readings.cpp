// SPDX-License-Identifier: MIT
// Sentences of sec. 2.1 on the bush taken at their word: which symbols are deleted at the end, how
// often a production is applied, and which of ! and ' is for colour and which for thickness.
#include <cmath>
#include <set>
#include <string>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr int steps = 5;

/// The drawing after all of `letters` have been deleted from the word.
void record_deletion(ExperimentContext& context, const std::string& word,
                     const std::string& letters, const std::string& name) {
  std::string text = "axiom: " + word + "\nangle: 22.5\n";
  for (const char letter : letters) text += std::string(1, letter) + " -> *\n";
  const LSystem system = parse_lsystem(text, "remaining nonterminals");
  const Drawing drawing = draw(system, derived(system, 1));
  std::vector<Vector3> bases;
  for (const TurtlePolygon& leaf : drawing.polygons)
    bases.push_back(corners_of(drawing, leaf).front());
  context.record(name + "/segments", static_cast<std::int64_t>(drawing.segments.size()));
  context.record(name + "/leaves", static_cast<std::int64_t>(drawing.polygons.size()));
  context.record(name + "/places_of_leaves",
                 static_cast<std::int64_t>(distinct_point_count(bases, 1e-9)));
}

/// Symbols that are replaced in the first `steps` steps: each is one application of a production.
std::int64_t applications(const LSystem& system) {
  const GrowthForecast growth = *growth_forecast(system, steps);
  std::uint64_t replaced = 0;
  for (int n = 0; n < steps; ++n)
    for (const char* letter : {"A", "F", "S", "L"})
      replaced +=
          growth.steps[static_cast<std::size_t>(n)].symbols[*find_symbol(system, letter, 0)];
  return static_cast<std::int64_t>(replaced);
}

/// Letters that draw between the primes of a leaf and the bracket that ends their meaning.
void record_leaf_primes(ExperimentContext& context, const std::string& word) {
  std::int64_t primes = 0, lines = 0;
  for (auto at = word.find("['"); at != std::string::npos; at = word.find("['", at + 1))
    for (std::size_t i = at; word[i] != ']'; ++i) {
      primes += word[i] == '\'';
      lines += word[i] == 'F';
    }
  context.record("leaf_primes", primes);
  context.record("lines_behind_leaf_primes", lines);
}

void record_pens(ExperimentContext& context, const Drawing& drawing, const std::string& name) {
  std::set<std::int64_t> widths;
  std::set<std::uint16_t> colours, leaf_colours;
  for (const TurtleSegment& segment : drawing.segments) {
    widths.insert(std::llround(1e6 * static_cast<double>(segment.width)));
    colours.insert(segment.colour);
  }
  for (const TurtlePolygon& leaf : drawing.polygons) leaf_colours.insert(leaf.colour);
  context.record(name + "/widths", static_cast<std::int64_t>(widths.size()));
  context.record(name + "/colours", static_cast<std::int64_t>(colours.size()));
  context.record(name + "/leaf_colours", static_cast<std::int64_t>(leaf_colours.size()));
}

void run(ExperimentContext& context) {
  const LSystem system = bush_system(bush_of_the_book());
  const Word five = derived(system, steps), one = derived(system, 1);
  const std::string word = text_of(system, five);
  record_deletion(context, word, "AFSL", "all_deleted");
  record_deletion(context, word, "ASL", "F_stays");
  record_deletion(context, word, "", "none_deleted");
  context.record("applications_in_5_steps", applications(system));
  record_leaf_primes(context, word);
  record_pens(context, draw(system, five), "n-5");
  record_pens(context, draw(system, one), "n-1");
}

}  // namespace

extern const ExperimentDescriptor bush_readings;
constinit const ExperimentDescriptor bush_readings{
    .id = "lintermann1997/bush-readings",
    .question = "What do the sentences around the bush's grammar come to, taken at their word?",
    .source = "[Lintermann1997] sec. 2.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
