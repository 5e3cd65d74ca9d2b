// SPDX-License-Identifier: MIT
// Sec. 2.3.1: how + and - turn the turtle in the plane.
#include <cmath>
#include <numbers>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "reference/oracles/turtle_2d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

constexpr int angles = 400;  // of 0.9 degrees: four of them are right ones
constexpr double radians = std::numbers::pi / 180.0;

Vector3 turned(char symbol, double d_deg, const char* start) {
  return drawing_of(fmt::format("{}({})", symbol, d_deg), start).end_frame.heading;
}

/// The matrix that a symbol multiplies headings by: its columns are what it makes of two of them.
struct TurnMatrix {
  Vector3 of_x, of_y;

  TurnMatrix(char symbol, double d_deg)
      : of_x(turned(symbol, d_deg, "start: local")),
        of_y(turned(symbol, d_deg, "start: upwards")) {}
  double determinant() const { return of_x.x * of_y.y - of_y.x * of_x.y; }
};

double off(const Vector3& heading, const oracles::PlanePoint& printed) {
  return std::max(std::abs(heading.x - printed.x), std::abs(heading.y - printed.y));
}

/// Eq. 2.4 and 2.5.
void measure_turns(ExperimentContext& context) {
  double plus_off = 0, minus_off = 0, determinant_off = 0;
  std::int64_t below_half = 0, left = 0, right = 0, not_undone = 0, quarters_off = 0;
  for (int i = 1; i <= angles; ++i) {
    const double d = 360.0 * i / angles;
    const TurnMatrix plus('+', d), minus('-', d);
    const oracles::PlaneTurtle along_x{{}, {1, 0}}, along_y{{}, {0, 1}};
    plus_off = std::max({plus_off, off(plus.of_x, along_x.equation_2_4(d * radians)),
                         off(plus.of_y, along_y.equation_2_4(d * radians))});
    minus_off = std::max({minus_off, off(minus.of_x, along_x.equation_2_5(d * radians)),
                          off(minus.of_y, along_y.equation_2_5(d * radians))});
    determinant_off = std::max(
        {determinant_off, std::abs(plus.determinant() - 1.0), std::abs(minus.determinant() - 1.0)});
    for (const char* pair : {"+({0})-({0})", "-({0})+({0})"})
      not_undone +=
          drawing_of(fmt::format(fmt::runtime(pair), d)).end_frame.heading != Vector3{0, 1, 0};
    if (i % (angles / 4) == 0)
      quarters_off += plus.of_x != Vector3{std::round(std::cos(d * radians)),
                                           std::round(std::sin(d * radians)), 0.0};
    if (2 * i >= angles) continue;
    ++below_half;
    left += plus.of_x.y > 0.0 && plus.of_y.x < 0.0;
    right += minus.of_x.y < 0.0 && minus.of_y.x > 0.0;
  }
  context.record("turns/angles", std::int64_t{angles});
  context.record("turns/plus_off", plus_off);
  context.record("turns/minus_off", minus_off);
  context.record("turns/determinant_off", determinant_off);
  context.record("turns/not_undone", not_undone);
  context.record("turns/quarters_off", quarters_off);
  context.record("turns/below_half_a_turn", below_half);
  context.record("turns/to_the_left", left);
  context.record("turns/to_the_right", right);
}

/// The heading after many turns, by the engine and by multiplying printed matrices.
void measure_unit_length(ExperimentContext& context) {
  const std::int64_t turns = context.tier() == Tier::full ? 1'000'000 : 100'000;
  WrittenWord made = written("+(1)-(1)");
  RandomWords random(context.seed(), 1, "+-");
  made.word.symbols.resize_for_overwrite(static_cast<std::size_t>(turns));
  made.word.parameters.resize_for_overwrite(static_cast<std::size_t>(turns));
  oracles::PlaneTurtle printed;
  for (std::size_t i = 0; i < made.word.symbols.size(); ++i) {
    made.word.symbols[i] = static_cast<SymbolIndex>(random.below(2));
    made.word.parameters[i] = random.angle_deg();
    printed.turn(made.system.symbols[made.word.symbols[i]].letter, made.word.parameters[i]);
  }
  const Vector3 heading = draw(made.system, made.word).end_frame.heading;
  record_seeded(context, "unit/turns", turns);
  record_seeded(context, "unit/length_off", std::abs(norm(heading) - 1.0));
  record_seeded(context, "unit/printed_length_off",
                std::abs(std::hypot(printed.H.x, printed.H.y) - 1.0));
  record_seeded(context, "unit/heading_off_printed", off(heading, printed.H));
}

void run(ExperimentContext& context) {
  measure_turns(context);
  measure_unit_length(context);
}

}  // namespace

extern const ExperimentDescriptor plane_turtle;
constinit const ExperimentDescriptor plane_turtle{
    .id = "liebemann2017/plane-turtle",
    .question = "Do + and - turn the turtle in the plane as eq. 2.4 and 2.5 say?",
    .source = "[Liebemann2017] sec. 2.3.1, eq. 2.4, 2.5",
    .seconds = {0.3, 0.3, 1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
