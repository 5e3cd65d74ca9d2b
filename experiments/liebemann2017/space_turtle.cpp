// SPDX-License-Identifier: MIT
// Sec. 2.3.3: which way the turtle turns, pitches and rolls in space.
#include <array>
#include <cmath>
#include <numbers>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int angles = 400;  // of 0.9 degrees
constexpr double radians = std::numbers::pi / 180.0;

TurtleFrame frame_of(const std::string& turns, const std::string& settings = "start: local") {
  return drawing_of(turns, settings).end_frame;
}
std::string turn(char symbol, double d_deg) {
  return fmt::format("{}({})", symbol, d_deg);
}

double off(const TurtleFrame& frame, const oracles::Matrix3& R) {
  const Vector3 columns[] = {frame.heading, frame.left, frame.up};
  double greatest = 0.0;
  for (std::size_t j = 0; j < 3; ++j) {
    const oracles::SpacePoint c = oracles::column(R, j);
    greatest = std::max(greatest, largest_entry(columns[j] - Vector3{c.x, c.y, c.z}));
  }
  return greatest;
}

struct Turn {
  char symbol, back;
  const char* name;
  oracles::Matrix3 (*printed)(double);
  double sign;                              // eq. 2.11 to 2.16
  oracles::Matrix3 (*of_the_book)(double);  // The Algorithmic Beauty of Plants, p. 19
};
constexpr Turn turns[] = {
    {'+', '-', "left", oracles::equation_2_9, 1, oracles::abop_R_U},
    {'-', '+', "right", oracles::equation_2_9, -1, oracles::abop_R_U},
    {'&', '^', "down", oracles::equation_2_8, 1, oracles::abop_R_L},
    {'^', '&', "up", oracles::equation_2_8, -1, oracles::abop_R_L},
    {'\\', '/', "roll_left", oracles::equation_2_7, 1, oracles::abop_R_H},
    {'/', '\\', "roll_right", oracles::equation_2_7, -1, oracles::abop_R_H},
};

/// Whether the frame, by less than half a turn away from the axes, has gone where the words say.
bool goes_as_said(const std::string& name, const TurtleFrame& f) {
  if (name == "left") return f.heading.y > 0 && f.left.x < 0;
  if (name == "right") return f.heading.y < 0 && f.left.x > 0;
  if (name == "down") return f.heading.z < 0 && f.up.x > 0;
  if (name == "up") return f.heading.z > 0 && f.up.x < 0;
  if (name == "roll_left") return f.up.y > 0 && f.left.z < 0;
  return f.up.y < 0 && f.left.z > 0;
}

void measure_turns(ExperimentContext& context) {
  context.record("turns/angles", std::int64_t{angles});
  context.record("turns/below_half_a_turn", std::int64_t{angles / 2 - 1});
  for (const Turn& t : turns) {
    double printed_off = 0, book_off = 0, not_transposed = 0, undone_off = 0;
    std::int64_t as_said = 0;
    for (int i = 1; i <= angles; ++i) {
      const double d = 360.0 * i / angles;
      const TurtleFrame frame = frame_of(turn(t.symbol, d));
      const oracles::Matrix3 printed = t.printed(t.sign * d * radians),
                             book = t.of_the_book(t.sign * d * radians);
      printed_off = std::max(printed_off, off(frame, printed));
      book_off = std::max(
          book_off, off(frame_of(turn(t.symbol, d), "start: local turtle: abop_matrices"), book));
      for (std::size_t row = 0; row < 3; ++row)
        for (std::size_t column = 0; column < 3; ++column)
          not_transposed =
              std::max(not_transposed, std::abs(book[row][column] - printed[column][row]));
      undone_off = std::max(
          undone_off, off(frame_of(turn(t.symbol, d) + turn(t.back, d)), oracles::start_local));
      if (2 * i < angles) as_said += goes_as_said(t.name, frame);
    }
    const std::string name = fmt::format("turns/{}/", t.name);
    context.record(name + "off_printed", printed_off);
    context.record(name + "off_the_book", book_off);
    context.record(name + "not_transposed", not_transposed);
    context.record(name + "undone_off", undone_off);
    context.record(name + "as_said", as_said);
  }
  // About its own axis by the right-hand rule: the angle of what R_X(30) does.
  const auto degrees = [](double y, double x) { return std::atan2(y, x) / radians; };
  const TurtleFrame about_U = frame_of("+(30)"), about_L = frame_of("&(30)"),
                    about_H = frame_of("\\(30)");
  context.record("right_hand_rule/about_U", degrees(about_U.heading.y, about_U.heading.x), "deg");
  context.record("right_hand_rule/about_L", degrees(about_L.up.x, about_L.up.z), "deg");
  context.record("right_hand_rule/about_H", degrees(about_H.left.z, about_H.left.y), "deg");
}

/// Quarter turns only permute the axes and change their signs.
void measure_quarter_turns(ExperimentContext& context) {
  RandomWords random(context.seed(), 4, "+");
  std::vector<std::array<int, 9>> found;
  std::int64_t inexact = 0;
  std::string word;
  constexpr int words = 400;
  for (int i = 0; i < words; ++i) {
    word += fmt::format("{}(90)", "+-&^\\/"[random.below(6)]);
    const TurtleFrame frame = frame_of("&(90)^(90)" + word);
    std::array<int, 9> entries{};
    std::size_t k = 0;
    for (const Vector3& v : {frame.heading, frame.left, frame.up})
      for (const double entry : {v.x, v.y, v.z}) {
        entries[k++] = static_cast<int>(std::lround(entry));
        inexact += entry != std::round(entry);
      }
    if (std::find(found.begin(), found.end(), entries) == found.end()) found.push_back(entries);
  }
  record_seeded(context, "quarter_turns/words", std::int64_t{words});
  record_seeded(context, "quarter_turns/inexact_entries", inexact);
  record_seeded(context, "quarter_turns/orientations", static_cast<std::int64_t>(found.size()));
}

void run(ExperimentContext& context) {
  measure_turns(context);
  measure_quarter_turns(context);
}

}  // namespace

extern const ExperimentDescriptor space_turtle;
constinit const ExperimentDescriptor space_turtle{
    .id = "liebemann2017/space-turtle",
    .question = "Which way do the matrices of eq. 2.7 to 2.16 turn the turtle?",
    .source = "[Liebemann2017] sec. 2.3.3, eq. 2.7-2.16",
    .seconds = {0.5, 0.5, 0.5},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
