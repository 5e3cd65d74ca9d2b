// SPDX-License-Identifier: MIT
// The commands of the turtle in the plane and in space, and its brackets.
#include <algorithm>
#include <cmath>
#include <set>
#include <string>
#include <utility>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/brzoska2019/thesis_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/turtle_2d.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// How far two turtles stand apart, in place or direction.
double difference(const Drawing& a, const Drawing& b) {
  return std::max({norm(a.end - b.end), norm(a.end_frame.heading - b.end_frame.heading),
                   norm(a.end_frame.left - b.end_frame.left),
                   norm(a.end_frame.up - b.end_frame.up)});
}

void record_plane_commands(ExperimentContext& context) {
  CounterStream stream(context.seed(), 1);
  double F_f = 0.0, plus_minus = 0.0, from_oracle = 0.0;
  std::int64_t drawn_otherwise = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 360.0 * stream.next_unit();
    const std::string before = "f" + random_letters(stream, "Ff+-", 50);
    F_f = std::max(F_f, difference(drawn_word(before + "F", angle),  //
                                   drawn_word(before + "f", angle)));
    plus_minus = std::max(
        {plus_minus, difference(drawn_word(before + "+-", angle), drawn_word(before, angle)),
         difference(drawn_word(before + "-+", angle), drawn_word(before, angle))});
    const Drawing ours = drawn_word(before, angle);
    drawn_otherwise += whole(ours.segments.size()) != std::count(before.begin(), before.end(), 'F');
    const auto literal =
        oracles::turtle_2d(oracles::modules_of(before), {.length = 1.0, .angle_deg = angle}).end;
    from_oracle = std::max(
        from_oracle, std::hypot(ours.end.x - literal.position.x, ours.end.y - literal.position.y));
  }
  context.record("plane/drawing_against_plain_move", F_f, "steps");
  context.record("plane/plus_against_minus", plus_minus);
  context.record("plane/words_with_other_lines", drawn_otherwise, "words");
  context.record("plane/differs_from_oracle", from_oracle, "steps");
  context.record("plane/four_right_angles",
                 difference(drawn_word("F++++", 90), drawn_word("F", 90)));
  context.record("plane/plus/heading_x", drawn_word("+", 90).end_frame.heading.x);
  context.record("plane/minus/heading_x", drawn_word("-", 90).end_frame.heading.x);
}

/// Headings that whole degrees give, and how far the last is from the first.
void record_directions(ExperimentContext& context) {
  std::set<std::pair<std::int64_t, std::int64_t>> headings;
  std::string word;
  for (int degrees = 1; degrees <= 360; ++degrees) {
    word += '+';
    const Vector3 heading = drawn_word(word, 1.0).end_frame.heading;
    headings.insert({std::llround(1e6 * heading.x), std::llround(1e6 * heading.y)});
  }
  context.record("plane/directions/different", whole(headings.size()), "directions");
  const Vector3 start = drawn_word("f", 1.0).end_frame.heading;
  context.record("plane/directions/after_a_full_turn",
                 norm(drawn_word(word, 1.0).end_frame.heading - start));
}

/// Letters with matching brackets.
std::string random_branch(UnitStream& stream, int depth) {
  std::string word = random_letters(stream, "Ff+-&^\\/|", 6);
  if (depth > 0)
    word += "[" + random_branch(stream, depth - 1) + "]" + random_branch(stream, depth - 1);
  return word;
}

void record_brackets(ExperimentContext& context) {
  CounterStream stream(context.seed(), 2);
  constexpr std::int64_t words = 200;
  std::int64_t other_state = 0, lines_of_jumps = 0;
  for (std::int64_t i = 0; i < words; ++i) {
    const std::string before = "F/" + random_branch(stream, 2), branch = random_branch(stream, 4);
    const Drawing with = drawn_word(before + "[" + branch + "]", 25.0);
    other_state += difference(with, drawn_word(before, 25.0)) != 0.0;
    const std::string all = before + branch;
    lines_of_jumps += whole(with.segments.size()) != std::count(all.begin(), all.end(), 'F');
  }
  context.record("brackets/words", words, "words");
  context.record("brackets/other_state", other_state, "words");
  context.record("brackets/other_number_of_lines", lines_of_jumps, "words");
}

void record_frame(ExperimentContext& context) {
  CounterStream stream(context.seed(), 3);
  const Drawing walk = drawn_word(random_letters(stream, "F+-|&^\\/", 100'000), 22.5);
  const TurtleFrame& frame = walk.end_frame;
  context.record("space/orthonormality_error", orthonormality_error(frame));
  context.record("space/heading_cross_left_against_up",
                 norm(cross(frame.heading, frame.left) - frame.up));
  const std::string some = random_letters(stream, "F+-|&^\\/", 2000);
  const auto literal =
      oracles::turtle_3d(oracles::modules_of(some), {.length = 1.0, .angle_deg = 33.0},
                         oracles::start_upwards)
          .end.position;
  const Vector3 end = drawn_word(some, 33.0).end;
  context.record("space/differs_from_oracle", norm(end - Vector3{literal.x, literal.y, literal.z}),
                 "steps");
}

void record_space_commands(ExperimentContext& context) {
  CounterStream stream(context.seed(), 4);
  for (const auto& [name, pair] : {std::pair{"turn", "+-"}, std::pair{"pitch", "&^"},
                                   std::pair{"roll", "\\/"}, std::pair{"half_turn", "||"}}) {
    double largest = 0.0;
    for (int i = 0; i < 50; ++i) {
      const double angle = 360.0 * stream.next_unit();
      const std::string before = "/" + random_letters(stream, "F+-|&^\\/", 20);
      const std::string there = pair, back(there.rbegin(), there.rend());
      for (const std::string& both : {there, back})
        largest = std::max(largest,
                           difference(drawn_word(before + both, angle), drawn_word(before, angle)));
    }
    context.record(fmt::format("space/undone/{}", name), largest);
  }
  // At 90 degrees the vectors change places; +1 and -1 say which way.
  const TurtleFrame start = drawn_word("f&^", 90).end_frame;
  const auto after = [](const std::string& command) {
    return drawn_word("f&^" + command, 90).end_frame;
  };
  context.record("space/plus/heading_to_left", dot(after("+").heading, start.left));
  context.record("space/minus/heading_to_left", dot(after("-").heading, start.left));
  context.record("space/down/heading_to_up", dot(after("&").heading, start.up));
  context.record("space/up/heading_to_up", dot(after("^").heading, start.up));
  context.record("space/backslash/up_to_left", dot(after("\\").up, start.left));
  context.record("space/slash/up_to_left", dot(after("/").up, start.left));
  context.record("space/bar/heading_to_heading", dot(after("|").heading, start.heading));
  context.record("space/bar/up_to_up", dot(after("|").up, start.up));
}

void run(ExperimentContext& context) {
  record_plane_commands(context);
  record_directions(context);
  record_brackets(context);
  record_frame(context);
  record_space_commands(context);
}

}  // namespace

extern const ExperimentDescriptor turtle;
constinit const ExperimentDescriptor turtle{
    .id = "brzoska2019/turtle",
    .question = "Does the turtle obey the thesis' commands in the plane and in space?",
    .source = "[Brzoska2019] sec. 3.4.2, fig. 12, 15",
    .seconds = {0.3, 0.3, 0.3},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
