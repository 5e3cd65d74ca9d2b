// SPDX-License-Identifier: MIT
// Sec. 2.3.1 and 2.3.2: what words draw in the plane, and what the turtle's state is good for.
#include <cmath>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "reference/oracles/turtle_2d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// What depends on the state alone, and what a module's parameters may hold.
void measure_state(ExperimentContext& context) {
  std::int64_t pairs = 0, different = 0, different_by_heading = 0;
  RandomWords random(context.seed(), 2, "+-");
  for (int i = 0; i < 50; ++i) {
    const std::string word = random.next(40, true);
    const Drawing plain = drawing_of(word), other = drawing_of("+(90)" + word);
    // Both ways lead back to the state at the start, every bit of it.
    for (const char* way : {"F(3)+(90)F(4)+(90)F(3)+(90)F(4)+(90)", "-(36.5)+(12.25)+(24.25)"}) {
      const Drawing later = drawing_of(way + word);
      const std::size_t before = later.segments.size() - plain.segments.size();
      bool same = true;
      for (std::size_t k = 0; k < plain.segments.size(); ++k)
        same = same && later.segments[k + before].from == plain.segments[k].from &&
               later.segments[k + before].to == plain.segments[k].to;
      ++pairs;
      different += !same;
      different_by_heading += other.segments[0].to != plain.segments[0].to;
    }
  }
  record_seeded(context, "state/pairs", pairs);
  record_seeded(context, "state/same_state_different_drawing", different);
  record_seeded(context, "state/other_heading_different_drawing", different_by_heading);
}

/// + and - as letters and in parameters; letters that mean nothing.
void measure_signs(ExperimentContext& context) {
  const WrittenWord made = written("F(5-2)+(30+60)F(2)-(100-10)F(1)");
  const Drawing drawing = draw(made.system, made.word);
  context.record("signs/modules", static_cast<std::int64_t>(made.word.size()));
  context.record("signs/turns", letter_count(made.system, made.word, "+") +
                                    letter_count(made.system, made.word, "-"));
  context.record("signs/end_x", drawing.end.x);
  context.record("signs/end_y", drawing.end.y);
  const Drawing with_letters = drawing_of("AF(3)B+(90)XF(2)A-(90)BF(1)X");
  context.record("signs/lines_with_other_letters_off",
                 segments_off(with_letters.segments, drawing.segments));
  context.record("signs/start_x", drawing.segments[0].from.x);
  context.record("signs/start_y", drawing.segments[0].from.y);
}

/// Eq. 2.3 and the brackets, in random words.
void measure_words(ExperimentContext& context) {
  constexpr int words = 200;
  std::int64_t letters = 0, segments = 0, one_line = 0, one_line_with_branches = 0;
  std::int64_t not_restored = 0, branches = 0;
  double oracle_off = 0.0, longest_off = 0.0;
  RandomWords random(context.seed(), 3, "+-");
  for (int i = 0; i < words; ++i) {
    const std::string text = random.next(60, true), trunk = trunk_of(text);
    const WrittenWord made = written(text);
    const Drawing drawing = draw(made.system, made.word), bare = drawing_of(trunk);
    const oracles::ParametricWord literal = literal_word(made.system, made.word);
    letters += letter_count(made.system, made.word, "F");
    branches += letter_count(made.system, made.word, "[");
    segments += static_cast<std::int64_t>(drawing.segments.size());
    one_line += is_one_line(bare);
    one_line_with_branches += is_one_line(drawing);
    not_restored += drawing.end != bare.end || drawing.end_frame.heading != bare.end_frame.heading;
    oracle_off = std::max(oracle_off,
                          segments_off(drawing.segments, oracles::turtle_2d(literal, {}).segments));
    std::size_t segment = 0;
    for (const oracles::Module& module : literal) {
      if (module.letter != "F") continue;
      const TurtleSegment& line = drawing.segments[segment++];
      longest_off =
          std::max(longest_off, std::abs(norm(line.to - line.from) - module.parameters[0]));
    }
  }
  record_seeded(context, "words/words", std::int64_t{words});
  record_seeded(context, "words/letters_F", letters);
  record_seeded(context, "words/branches", branches);
  record_seeded(context, "words/segments", segments);
  record_seeded(context, "words/one_line_without_branches", one_line);
  record_seeded(context, "words/one_line_with_branches", one_line_with_branches);
  record_seeded(context, "words/not_restored", not_restored);
  record_seeded(context, "words/line_length_off", longest_off);
  record_seeded(context, "words/off_oracle", oracle_off);
  const Drawing fork = drawing_of("F(1)[+(25)F(1)][F(1)][-(25)F(1)]");
  std::int64_t from_one_point = 0;
  for (std::size_t i = 1; i < fork.segments.size(); ++i)
    from_one_point += fork.segments[i].from == fork.segments[0].to;
  record_seeded(context, "words/lines_from_one_point", from_one_point);
}

void run(ExperimentContext& context) {
  measure_state(context);
  measure_signs(context);
  measure_words(context);
}

}  // namespace

extern const ExperimentDescriptor plane_words;
constinit const ExperimentDescriptor plane_words{
    .id = "liebemann2017/plane-words",
    .question = "Do words draw what the text says of F, [ and ], and of the turtle's state?",
    .source = "[Liebemann2017] sec. 2.3.1, 2.3.2, eq. 2.3",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
