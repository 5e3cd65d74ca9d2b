// SPDX-License-Identifier: MIT
// Sec. 2.3.3 keeps the turtle's matrix as a product: how far rounding takes it from a rotation.
#include <array>
#include <cmath>

#include "core/lsystem/drawing_measures.hpp"
#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/drawn_systems.hpp"
#include "experiments/liebemann2017/random_words.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// Random turns about all three axes, as a word of six symbols with one parameter each.
WrittenWord random_turns(std::uint64_t seed, std::size_t count) {
  WrittenWord made = written("+(1)-(1)&(1)^(1)\\(1)/(1)", "start: local");
  CounterStream stream(seed, 7);
  made.word.symbols.resize_for_overwrite(count);
  made.word.parameters.resize_for_overwrite(count);
  for (std::size_t i = 0; i < count; ++i) {
    made.word.symbols[i] = static_cast<SymbolIndex>(6.0 * stream.next_unit());
    made.word.parameters[i] = 360.0 * stream.next_unit();
  }
  return made;
}

/// R' = R R_X as printed, entries rounded to Real after each product, and never repaired.
template <class Real>
double error_of_products(const WrittenWord& turns) {
  using Matrix = std::array<std::array<Real, 3>, 3>;
  Matrix R{{{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}};
  for (std::size_t n = 0; n < turns.word.symbols.size(); ++n) {
    oracles::SpaceTurtle one;
    one.turn(turns.system.symbols[turns.word.symbols[n]].letter, turns.word.parameters[n]);
    Matrix product{};
    for (std::size_t i = 0; i < 3; ++i)
      for (std::size_t j = 0; j < 3; ++j)
        for (std::size_t k = 0; k < 3; ++k)
          product[i][j] += R[i][k] * static_cast<Real>(one.R[k][j]);
    R = product;
  }
  oracles::Matrix3 wide{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t j = 0; j < 3; ++j) wide[i][j] = static_cast<double>(R[i][j]);
  return oracles::distance_from_orthonormal(wide);
}

void run(ExperimentContext& context) {
  constexpr std::size_t turns_of_figure_2_6 = 55'762;  // more than all its modules could turn
  std::vector<std::size_t> counts{1'000, turns_of_figure_2_6, 1'000'000};
  for (const std::size_t count : counts) {
    context.progress(fmt::format("{} turns", count));
    const WrittenWord turns = random_turns(context.seed(), count);
    const auto record = [&](const char* name, double value) {
      record_seeded(context, fmt::format("turns-{}/{}", count, name), value);
    };
    record("engine", orthonormality_error(draw(turns.system, turns.word).end_frame));
    record("products", error_of_products<double>(turns));
    record("products_in_single_precision", error_of_products<float>(turns));
  }
}

}  // namespace

extern const ExperimentDescriptor frame_drift;
constinit const ExperimentDescriptor frame_drift{
    .id = "liebemann2017/frame-drift",
    .question = "How far from a rotation do many turns take the turtle's matrix?",
    .source = "[Liebemann2017] sec. 2.3.3",
    .seconds = {0.6, 0.6, 0.6},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
