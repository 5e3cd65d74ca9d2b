// SPDX-License-Identifier: MIT
// Sec. 4.2.1: the systems of ch. 2 typed into the form of the L-system actor.
#include <string>

#include "experiments/experiment.hpp"
#include "experiments/liebemann2017/editor_form.hpp"
#include "experiments/liebemann2017/word_systems.hpp"
#include "reference/oracles/liebemann2017_lsystems.hpp"
#include "reference/oracles/liebemann2017_parametric_lsystems.hpp"

namespace phytobench::experiments::liebemann2017 {

namespace {

/// Brackets of a text that are not those around the parameters of a module.
std::int64_t brackets_within_expressions(const std::string& text) {
  std::int64_t within = 0;
  int open = 0;
  for (const char c : text) {
    if (c == '(') within += open++ > 0;
    if (c == ')') --open;
  }
  return within;
}

/// The systems of ch. 2 typed in, beside the literal ones.
void measure_form(ExperimentContext& context) {
  namespace literal = oracles::liebemann2017;
  const Form island{"F-F-F-F", {}, {{"F", "", "F+F-F-FF+F+F-F"}}};
  const Form plant_a{"F", {}, {{"F", "", "FF-[-F+F+F]+[+F-F-F]"}}};
  const Form plant_b{"F", {}, {{"F", "", "F[-F]F[+F][F]"}}};
  const Form parametric{"A(1,1)", {}, {{"A", "x,y", "A(x+1,y*2)B(y)"}, {"B", "x", "B(x+1)C"}}};
  std::int64_t differ = 0, systems = 0, brackets = 0;
  const auto compare = [&](const Form& form, const oracles::ParametricWord& expected, int n) {
    const LSystem system = entered(form);
    differ += literal_word(system, derived(system, n)) != expected;
    brackets += brackets_within_expressions(text_of(form));
    ++systems;
  };
  const auto plain = [](const literal::D0LSystem& G, int n) {
    return oracles::modules_of(literal::derive_in_parallel(G, n));
  };
  compare(island, plain(literal::equation_2_6(), 3), 3);
  compare(plant_a, plain(literal::figure_2_5a(), 4), 4);
  compare(plant_b, plain(literal::figure_2_5b(), 5), 5);
  compare(parametric, literal::derive(literal::equation_2_2(), 4), 4);
  compare(equation_2_17_form("a", "d", "lr"),
          literal::derive(literal::equation_2_17(18.95, 137.5, 1.3), 8), 8);
  context.record("form/systems", systems, "systems");
  context.record("form/differs_from_oracle", differ, "systems");
  context.record("form/brackets_within_expressions", brackets, "brackets");
  const LSystem figure_4_1 = entered(plant_b);
  context.record("form/figure_4_1_letters_F", letter_count(figure_4_1, derived(figure_4_1, 5), "F"),
                 "letters");
  // Letters of eq. 2.1 with one sign each: r and R for a_r and a_l, s and S for b_r and b_l.
  const Form one_sign{"r", {}, {{"r", "", "Rs"}, {"R", "", "Sr"}, {"s", "", "r"}, {"S", "", "R"}}};
  std::string expected;
  for (const std::string& cell : literal::derive_in_parallel(literal::equation_2_1(), 10))
    expected += cell == "ar" ? 'r' : cell == "al" ? 'R' : cell == "br" ? 's' : 'S';
  context.record("form/one_sign_for_each_cell_differs",
                 std::int64_t{word_after(entered(one_sign), 10) != expected});
}

/// Which numbers of derivations are accepted.
void measure_steps(ExperimentContext& context) {
  const auto refused = [](const std::string& steps) {
    return std::int64_t{is_refused("axiom: F\nF -> FF\nsteps: " + steps + "\n")};
  };
  context.record("steps/none_refused", refused("0"));
  context.record("steps/one_refused", refused("1"));
  context.record("steps/half_refused", refused("0.5"));
  context.record("steps/negative_refused", refused("-1"));
  context.record("steps/none/word", word_after(koch_system(koch_step(0)), 0));
}

void run(ExperimentContext& context) {
  measure_form(context);
  measure_steps(context);
}

}  // namespace

extern const ExperimentDescriptor typed_systems;
constinit const ExperimentDescriptor typed_systems{
    .id = "liebemann2017/typed-systems",
    .question = "Do the fields for axiom, constants and productions hold the systems of ch. 2?",
    .source = "[Liebemann2017] sec. 4.2.1, fig. 4.1",
    .seconds = {0.1, 0.1, 0.1},
    .run = run,
};

}  // namespace phytobench::experiments::liebemann2017
