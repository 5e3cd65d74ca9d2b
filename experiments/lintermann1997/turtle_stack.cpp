// SPDX-License-Identifier: MIT
// Table 1, brackets: after ] the turtle is what it was at [, and has drawn no line on its way back.
#include <algorithm>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "core/lsystem/drawing.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

Drawing drawn(const std::string& word) {
  const LSystem system = parse_lsystem(
      fmt::format("axiom: {}\nangle: 22.5\nturtle: cpfg\nstart: local\n", word), "brackets");
  return draw(system, derived(system, 0));
}

/// Something in brackets, chosen at random among all commands but braces, nested three deep.
std::string random_branch(UnitStream& random, int depth) {
  constexpr std::string_view letters = "Ff+-&^\\/|!'[";
  std::string branch = "[";
  for (int i = 0; i < 12; ++i) {
    const char letter = letters[static_cast<std::size_t>(random.next_unit() * 12)];
    if (letter != '[') branch += letter;
    if (letter == '[' && depth > 0) branch += random_branch(random, depth - 1);
  }
  return branch + "]";
}

bool same(const TurtleSegment& a, const TurtleSegment& b) {
  return a.from == b.from && a.to == b.to && a.width == b.width && a.colour == b.colour;
}

void run(ExperimentContext& context) {
  constexpr int branches = 200;
  std::int64_t changed = 0, other_lines = 0;
  for (std::uint64_t i = 0; i < branches; ++i) {
    CounterStream random(context.seed(), i);
    const std::string branch = random_branch(random, 3);
    const Drawing with = drawn("+!'F" + branch + "&F"), without = drawn("+!'F&F");
    changed += !same(with.segments.back(), without.segments.back());
    const auto lines = std::count(branch.begin(), branch.end(), 'F');
    other_lines +=
        with.segments.size() != without.segments.size() + static_cast<std::size_t>(lines);
  }
  Record state{
      .experiment = {}, .measurement = "branches_that_change_what_follows", .value = changed};
  state.sample_size = branches;
  state.seed = context.seed();
  context.record(state);
  Record lines{
      .experiment = {}, .measurement = "branches_with_lines_of_their_own", .value = other_lines};
  lines.sample_size = branches;
  lines.seed = context.seed();
  context.record(lines);
}

}  // namespace

extern const ExperimentDescriptor turtle_stack;
constinit const ExperimentDescriptor turtle_stack{
    .id = "lintermann1997/turtle-stack",
    .question = "Do brackets store and restore all of the turtle's state?",
    .source = "[Lintermann1997] table 1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
