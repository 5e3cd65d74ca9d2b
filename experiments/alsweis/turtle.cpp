// SPDX-License-Identifier: MIT
// The turtle of section 3.2 by its four formulas, its brackets, and the queries of section 3.4 that
// tell an L-system where it stands.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "core/random/counter_stream.hpp"
#include "experiments/alsweis/chapter_3_l_systems.hpp"
#include "experiments/experiment.hpp"
#include "reference/oracles/alsweis_lsystems.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::alsweis {

namespace {

namespace literal = oracles::alsweis;

constexpr double right_angle = 90.0;

double difference(const Drawing& a, const Drawing& b) {
  return std::max({norm(a.end - b.end), norm(a.end_frame.heading - b.end_frame.heading),
                   norm(a.end_frame.up - b.end_frame.up)});
}

/// (x, y, alpha) by the four formulas as printed, d = 1; ours starts upwards.
Vector3 place_by_formulas(const std::string& word, double delta) {
  double x = 0.0, y = 0.0, alpha = 0.5 * std::acos(-1.0);
  for (const char command : word) {
    if (command == 'F' || command == 'f') {
      x += std::cos(alpha);
      y += std::sin(alpha);
    }
    if (command == '+') alpha += delta;
    if (command == '-') alpha -= delta;
  }
  return {x, y, 0.0};
}

void record_commands(ExperimentContext& context) {
  CounterStream stream(context.seed(), 1);
  double off = 0.0, F_f = 0.0, undone = 0.0;
  std::int64_t other_lines = 0, other_state = 0;
  for (int i = 0; i < 200; ++i) {
    const double angle = 180.0 * stream.next_unit();
    const std::string word = "F" + random_letters(stream, "Ff+-", 60);
    const Drawing ours = drawn_word(word, angle);
    off = std::max(off, norm(ours.end - place_by_formulas(word, angle * std::acos(-1.0) / 180.0)));
    F_f = std::max(F_f, difference(drawn_word(word + "F", angle), drawn_word(word + "f", angle)));
    undone = std::max(undone, difference(drawn_word(word + "+-", angle), ours));
    const std::string branch = random_letters(stream, "Ff+-", 20);
    const Drawing with_branch = drawn_word(word + "[" + branch + "]", angle);
    other_state += difference(with_branch, ours) != 0.0;
    const std::string all = word + branch;
    other_lines += whole(with_branch.segments.size()) != std::count(all.begin(), all.end(), 'F');
  }
  context.record("commands/off_the_formulas", off, "d");
  context.record("commands/drawing_against_plain_move", F_f, "d");
  context.record("commands/plus_against_minus", undone);
  context.record("commands/four_right_angles",
                 difference(drawn_word("F++++", right_angle), drawn_word("F", right_angle)));
  context.record("brackets/other_state", other_state, "words");
  context.record("brackets/other_number_of_lines", other_lines, "words");
}

/// Letters one after the other: what a word draws is what its halves draw, the second begun where
/// the first ended. Read from its end the word would draw something else.
void record_order(ExperimentContext& context) {
  CounterStream stream(context.seed(), 2);
  double largest = 0.0, least_backwards = 1e9;
  for (int i = 0; i < 100; ++i) {
    const std::string first = "F+" + random_letters(stream, "F+-", 30);
    const std::string second = random_letters(stream, "F+-", 30) + "FFF";
    const Drawing a = drawn_word(first, 40.0), b = drawn_word(second, 40.0);
    const Vector3 right = cross(a.end_frame.heading, a.end_frame.up);
    const Vector3 moved = a.end + b.end.y * a.end_frame.heading + b.end.x * right;
    largest = std::max(largest, norm(drawn_word(first + second, 40.0).end - moved));
    const std::string whole_word = first + second;
    const std::string backwards(whole_word.rbegin(), whole_word.rend());
    least_backwards = std::min(
        least_backwards, difference(drawn_word(backwards, 40.0), drawn_word(whole_word, 40.0)));
  }
  context.record("order/halves_against_whole", largest, "d");
  context.record("order/least_difference_backwards", least_backwards, "d");
}

void record_l_system_2(ExperimentContext& context) {
  const LSystem system = l_system(l_system_2_text);
  std::int64_t differ = 0;
  for (int n = 0; n <= 6; ++n) {
    const std::string word = word_after(system, n);
    differ += word != literal::word_of_lsystem_2(n);
    if (n >= 1 && n <= 3) context.record(fmt::format("l-system-2/n-{}/word", n), word);
    for (const double angle : {90.0, 60.0, 22.5}) {
      LSystem turned = system;
      turned.turtle.angle_deg = angle;
      context.record(fmt::format("l-system-2/n-{}/angle-{}/length", n, angle),
                     total_length(draw(turned, derived(turned, n))), "d");
    }
  }
  context.record("l-system-2/words_that_differ_from_oracle", differ, "words");
  const LSystemKind kind = kind_of(system);
  context.record("l-system-2/productions_with_contexts", std::int64_t{kind.contextual});
  context.record("l-system-2/asks_its_turtle", std::int64_t{kind.queries});
  context.artifact("l-system-2.svg", drawing_svg(draw(system, derived(system, 12)),
                                                 "L-system 2 after 12 steps, 90 degrees"));
}

/// Answers in space, behind random commands.
void record_queries(ExperimentContext& context) {
  CounterStream stream(context.seed(), 3);
  double not_orthonormal = 0.0, left_handed = 0.0, off = 0.0, other_in_plane = 0.0;
  for (int i = 0; i < 100; ++i) {
    const std::string walk = "/" + random_letters(stream, "FFf+-&^\\/|", 100);
    LSystem system = l_system("axiom: " + walk + "?P(0,0,0)?H(0,0,0)?L(0,0,0)?U(0,0,0)?P(0,0)\n");
    system.turtle.angle_deg = 180.0 * stream.next_unit();
    Word word = axiom_word(system);
    answer_queries(system, word);
    const auto answer = [&](std::size_t k) {
      return Vector3{word.parameters[3 * k], word.parameters[3 * k + 1],
                     word.parameters[3 * k + 2]};
    };
    const TurtleFrame frame{answer(1), answer(2), answer(3)};
    not_orthonormal = std::max(not_orthonormal, orthonormality_error(frame));
    left_handed = std::max(left_handed, norm(cross(frame.heading, frame.left) - frame.up));
    const auto end = oracles::turtle_3d(oracles::modules_of(walk),
                                        {.length = 1.0, .angle_deg = system.turtle.angle_deg},
                                        oracles::start_upwards)
                         .end;
    off = std::max(off, norm(answer(0) - Vector3{end.position.x, end.position.y, end.position.z}));
    other_in_plane = std::max({other_in_plane, std::abs(word.parameters[12] - answer(0).x),
                               std::abs(word.parameters[13] - answer(0).y)});
  }
  context.record("queries/not_orthonormal", not_orthonormal);
  context.record("queries/heading_cross_left_against_up", left_handed);
  context.record("queries/place_off_the_oracle", off, "d");
  context.record("queries/two_coordinates_against_three", other_in_plane, "d");
}

void run(ExperimentContext& context) {
  record_commands(context);
  record_order(context);
  record_l_system_2(context);
  record_queries(context);
}

}  // namespace

extern const ExperimentDescriptor turtle;
constinit const ExperimentDescriptor turtle{
    .id = "alsweis/turtle",
    .question = "Does the turtle move by its formulas, and tell where it stands?",
    .source = "[Alsweis] sections 3.2, 3.4",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::alsweis
