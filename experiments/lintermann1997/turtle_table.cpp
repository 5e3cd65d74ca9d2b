// SPDX-License-Identifier: MIT
// Table 1: what each command of the turtle does, turns by the right-hand rule about its own axes.
#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <string>

#include <fmt/format.h>

#include "core/lsystem/drawing.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

using oracles::Matrix3;
constexpr double angle_deg = 22.5;
constexpr double step = 2.5;

/// H = +x, L = +y, U = +z, so that the turtle's own axes are those of the table.
Drawing drawn(const std::string& word, const std::string& convention = "cpfg") {
  const LSystem system =
      parse_lsystem(fmt::format("axiom: {}\nangle: {}\nstep: {}\nstart: local\nturtle: {}\n", word,
                                angle_deg, step, convention),
                    "table 1");
  return draw(system, derived(system, 0));
}

/// Right-handed, about axis 0, 1 or 2 (x, y, z).
Matrix3 right_hand_turn(std::size_t axis, double degrees) {
  const double c = std::cos(degrees * std::numbers::pi / 180);
  const double s = std::sin(degrees * std::numbers::pi / 180);
  const std::size_t a = (axis + 1) % 3, b = (axis + 2) % 3;
  Matrix3 R{};
  R[axis][axis] = 1;
  R[a][a] = R[b][b] = c;
  R[a][b] = -s;
  R[b][a] = s;
  return R;
}

double difference(const TurtleFrame& frame, const Matrix3& R) {
  const std::array<Vector3, 3> columns{frame.heading, frame.left, frame.up};
  double largest = 0.0;
  for (std::size_t j = 0; j < 3; ++j) {
    const oracles::SpacePoint p = oracles::column(R, j);
    largest = std::max(largest, norm(columns[j] - Vector3{p.x, p.y, p.z}));
  }
  return largest;
}

struct Turn {
  const char* symbol;
  const char* name;
  const char* inverse;
  std::size_t axis;
  double sign;
};
constexpr std::array<Turn, 6> turns{{
    {"+", "plus", "-", 2, 1},
    {"-", "minus", "+", 2, -1},
    {"&", "ampersand", "^", 1, 1},
    {"^", "caret", "&", 1, -1},
    {"\\", "backslash", "/", 0, 1},
    {"/", "slash", "\\", 0, -1},
}};

void record_turns(ExperimentContext& context) {
  double undone = 0.0;
  for (const Turn& turn : turns) {
    const Matrix3 R = right_hand_turn(turn.axis, turn.sign * angle_deg);
    for (const char* convention : {"cpfg", "words"})
      context.record(fmt::format("{}/{}/difference", convention, turn.name),
                     difference(drawn(turn.symbol, convention).end_frame, R));
    const TurtleFrame back = drawn(std::string(turn.symbol) + turn.inverse).end_frame;
    undone = std::max(undone, difference(back, right_hand_turn(0, 0)));
  }
  context.record("turns_and_their_inverses/difference", undone);
  context.record("cpfg/plus/heading_to_the_left", drawn("+").end_frame.heading.y);
  context.record("cpfg/ampersand/heading_upwards", drawn("&").end_frame.heading.z);
  for (const char* convention : {"cpfg", "words"})
    context.record(fmt::format("{}/backslash/left_side_upwards", convention),
                   drawn("\\", convention).end_frame.left.z);
}

/// Turns one after the other, about the turtle's axes and about axes that stay.
void record_axes(ExperimentContext& context) {
  const TurtleFrame frame = drawn("+&").end_frame;
  const Matrix3 plus = right_hand_turn(2, angle_deg), down = right_hand_turn(1, angle_deg);
  context.record("axes/own/difference", difference(frame, oracles::product(plus, down)));
  context.record("axes/fixed/difference", difference(frame, oracles::product(down, plus)));
}

void record_moves(ExperimentContext& context) {
  for (const char* letter : {"F", "f"}) {
    const Drawing drawing = drawn(fmt::format("+{}", letter));
    const Vector3 heading = drawing.end_frame.heading;
    const std::string name = letter[0] == 'F' ? "draw/" : "move/";
    context.record(name + "lines", static_cast<std::int64_t>(drawing.segments.size()));
    context.record(name + "distance_from_d_along_heading", norm(drawing.end - step * heading));
  }
  const TurtleFrame back = drawn("+|").end_frame, ahead = drawn("+").end_frame;
  context.record("turn_around/heading_against_old", dot(back.heading, ahead.heading));
  context.record("turn_around/up_against_old", dot(back.up, ahead.up));
  context.record("turn_around/turn_about_z/difference",
                 difference(back, right_hand_turn(2, angle_deg + 180)));
}

void record_polygons(ExperimentContext& context) {
  const Drawing outline = drawn("{f+f+f}"), both = drawn("{F+F+F}F"), open = drawn("f+f+f");
  context.record("fill/polygons", static_cast<std::int64_t>(outline.polygons.size()));
  context.record("fill/corners", static_cast<std::int64_t>(outline.polygons.at(0).count));
  context.record("fill/lines", static_cast<std::int64_t>(outline.segments.size()));
  context.record("fill_and_draw/polygons", static_cast<std::int64_t>(both.polygons.size()));
  context.record("fill_and_draw/lines", static_cast<std::int64_t>(both.segments.size()));
  context.record("no_braces/polygons", static_cast<std::int64_t>(open.polygons.size()));
}

/// Commands of the bush that no row of the table has: | is taken for the row without a symbol.
void record_missing_rows(ExperimentContext& context) {
  const std::string rows = "Ff+-&^\\/|[]{}";
  const LSystem bush = bush_system(bush_of_the_book());
  std::string missing;
  for (const Symbol& symbol : bush.symbols) {
    const bool replaced = std::any_of(
        bush.productions.begin(), bush.productions.end(), [&](const Production& production) {
          return bush.symbols[production.predecessor.symbol].letter == symbol.letter;
        });
    if (!replaced && rows.find(symbol.letter) == std::string::npos) missing += symbol.letter;
  }
  std::sort(missing.begin(), missing.end());
  context.record("commands_of_the_bush_without_a_row", missing);
}

void run(ExperimentContext& context) {
  record_turns(context);
  record_axes(context);
  record_moves(context);
  record_polygons(context);
  record_missing_rows(context);
}

}  // namespace

extern const ExperimentDescriptor turtle_table;
constinit const ExperimentDescriptor turtle_table{
    .id = "lintermann1997/turtle-table",
    .question = "Do the turtle's commands do what table 1 says?",
    .source = "[Lintermann1997] table 1",
    .seconds = {0.2, 0.2, 0.2},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
