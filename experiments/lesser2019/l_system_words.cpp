// SPDX-License-Identifier: MIT
// Sec. 5.1.1: the L-system of the example, and its turtle.
#include <string>

#include <fmt/format.h>

#include "core/lsystem/derive.hpp"
#include "core/lsystem/read_lsystem.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::lesser2019 {

namespace {

/// Where a turtle ends that begins at the origin and looks up; + turns it to the right by a right
/// angle, as the thesis says, or to the left, as the book that it cites.
struct Turtle {
  std::int64_t x = 0, y = 0, heading_x = 0, heading_y = 1, lines = 0;

  void follow(const std::string& commands, bool plus_is_right) {
    for (const char sign : commands) {
      if (sign == 'F') {
        x += heading_x;
        y += heading_y;
        ++lines;
        continue;
      }
      const bool is_right = (sign == '+') == plus_is_right;
      const std::int64_t before = heading_x;
      heading_x = is_right ? heading_y : -heading_y;
      heading_y = is_right ? -before : before;
    }
  }
};

void run(ExperimentContext& context) {
  const LSystem system = parse_lsystem("axiom: b\na -> ab\nb -> a\n", "sec. 5.1.1");
  for (int steps = 0; steps <= 5; ++steps) {
    const std::string word = text_of(system, derive(system, {.steps = steps}));
    context.record(fmt::format("words/{}", steps), word);
    context.record(fmt::format("lengths/{}", steps), static_cast<std::int64_t>(word.size()),
                   "letters");
  }
  for (const bool plus_is_right : {true, false}) {
    Turtle turtle;
    turtle.follow("F+F-F", plus_is_right);
    const std::string name = plus_is_right ? "turtle/printed/" : "turtle/cited/";
    context.record(name + "lines", turtle.lines, "lines");
    context.record(name + "end-x", turtle.x, "lines");
    context.record(name + "end-y", turtle.y, "lines");
    context.record(name + "heading-x", turtle.heading_x);
    context.record(name + "heading-y", turtle.heading_y);
  }
}

}  // namespace

extern const ExperimentDescriptor l_system_words;
constinit const ExperimentDescriptor l_system_words{
    .id = "lesser2019/l-system-words",
    .question = "Which words does the L-system of the example make?",
    .source = "[Lesser2019] sec. 5.1.1",
    .seconds = {0.01, 0.01, 0.01},
    .run = run,
};

}  // namespace phytobench::experiments::lesser2019
