// SPDX-License-Identifier: MIT
// Sec. 2.3.3: what words draw in space, and which readings of eq. 2.10 to 2.16 that takes.
#include <cmath>
#include <numbers>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr double radians = std::numbers::pi / 180.0;

double off(const TurtleFrame& a, const TurtleFrame& b) {
  return std::max({largest_entry(a.heading - b.heading), largest_entry(a.left - b.left),
                   largest_entry(a.up - b.up)});
}

/// Eq. 2.10 to 2.16 in words: moves, brackets, the order of factors.
void measure_words(ExperimentContext& context) {
  constexpr int words = 200;
  double oracle_off = 0, line_off = 0, plane_off = 0, scalar_product = 0, handed_off = 0;
  std::int64_t not_restored = 0;
  RandomWords random(context.seed(), 5, "+-&^\\/"), flat(context.seed(), 6, "+-");
  for (int i = 0; i < words; ++i) {
    const std::string text = "&(0)" + random.next(60, true), trunk = trunk_of(text);
    const WrittenWord made = written(text, "start: local");
    const Drawing drawing = draw(made.system, made.word), bare = drawing_of(trunk, "start: local");
    const oracles::ParametricWord literal = literal_word(made.system, made.word);
    oracle_off = std::max(oracle_off,
                          segments_off(drawing.segments, oracles::turtle_3d(literal, {}).segments));
    not_restored += drawing.end != bare.end || off(drawing.end_frame, bare.end_frame) != 0.0;
    std::size_t segment = 0;
    for (const oracles::Module& module : literal)
      if (module.letter == "F") {
        const TurtleSegment& line = drawing.segments[segment++];
        line_off = std::max(line_off, std::abs(norm(line.to - line.from) - module.parameters[0]));
      }
    const TurtleFrame& f = drawing.end_frame;
    scalar_product = std::max({scalar_product, std::abs(dot(f.heading, f.left)),
                               std::abs(dot(f.left, f.up)), std::abs(dot(f.up, f.heading))});
    handed_off = std::max(handed_off, largest_entry(cross(f.heading, f.left) - f.up));
    const std::string in_plane = flat.next(60, true);
    plane_off = std::max(plane_off, segments_off(drawing_of("&(0)" + in_plane).segments,
                                                 drawing_of(in_plane).segments));
  }
  record_seeded(context, "words/words", std::int64_t{words});
  record_seeded(context, "words/off_oracle", oracle_off);
  record_seeded(context, "words/line_length_off", line_off);
  record_seeded(context, "words/not_restored", not_restored);
  record_seeded(context, "words/plane_off", plane_off);
  record_seeded(context, "words/scalar_product", scalar_product);
  record_seeded(context, "words/heading_x_left_off_up", handed_off);
}

/// What the order of factors, and the heading in eq. 2.10, mean for one word.
void measure_readings(ExperimentContext& context) {
  const Vector3 own = drawing_of("+(90)&(90)F(1)", "start: local").end;
  context.record("own_axes/end_x", own.x);
  context.record("own_axes/end_y", own.y);
  context.record("own_axes/end_z", own.z);
  // The same place and heading, but rolled.
  const Vector3 rolled = drawing_of("\\(90)+(90)F(1)", "start: local").end,
                plain = drawing_of("\\(0)+(90)F(1)", "start: local").end;
  context.record("roll/end_of_next_line_off", norm(rolled - plain));
  // With the current heading as the H of eq. 2.10 it would be turned once more.
  const oracles::Matrix3 R = oracles::equation_2_9(30 * radians);
  const oracles::SpacePoint H = oracles::column(R, 0);
  const Vector3 end = drawing_of("&(0)+(30)F(1)", "start: local").end;
  context.record("heading/angle", std::atan2(end.y, end.x) / radians, "deg");
  context.record("heading/angle_if_turned_again",
                 std::atan2(R[1][0] * H.x + R[1][1] * H.y, R[0][0] * H.x + R[0][1] * H.y) / radians,
                 "deg");
}

void run(ExperimentContext& context) {
  measure_words(context);
  measure_readings(context);
}

}  // namespace

extern const ExperimentDescriptor space_words;
constinit const ExperimentDescriptor space_words{
    .id = "liebemann2017/space-words",
    .question = "Do words draw in space what eq. 2.10 to 2.16 say?",
    .source = "[Liebemann2017] sec. 2.3.3, eq. 2.10-2.16",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
