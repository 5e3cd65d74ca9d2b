// SPDX-License-Identifier: MIT
// For tests: systems without parameters, made without the parser.
#pragma once

#include <cmath>
#include <map>
#include <string>
#include <vector>

#include "core/lsystem/lsystem.hpp"

namespace phytobench {

using TestProductions = std::map<char, std::string>;

inline SymbolIndex test_symbol(LSystem& system, char letter) {
  const std::string name(1, letter);
  if (const auto known = find_symbol(system, name, 0)) return *known;
  system.symbols.push_back({name, 0});
  return static_cast<SymbolIndex>(system.symbols.size() - 1);
}

inline LSystem test_system(const std::string& name, const std::string& axiom,
                           const TestProductions& productions, double angle_deg) {
  LSystem system;
  system.source = name;
  for (const char letter : axiom) system.axiom.push_back({test_symbol(system, letter), {}});
  for (const auto& [letter, successor] : productions) {
    Production production;
    production.predecessor.symbol = test_symbol(system, letter);
    for (const char c : successor) production.successor.push_back({test_symbol(system, c), {}});
    production.group = static_cast<std::uint16_t>(system.productions.size());
    system.productions.push_back(production);
  }
  system.ignored.assign(system.symbols.size(), false);
  system.turtle.angle_deg = angle_deg;
  return system;
}

struct TestCase {
  LSystem system;
  int steps = 0;
};

inline TestCase test_case(const std::string& name, const std::string& axiom,
                          const TestProductions& productions, double angle_deg, int steps,
                          const std::string& draws = "F", const std::string& moves = "f") {
  LSystem system = test_system(name, axiom, productions, angle_deg);
  system.turtle.draws = draws;
  system.turtle.moves = moves;
  return {system, steps};
}

inline TestCase with_settings(TestCase test, TurtleStart start, TurtleConvention convention,
                              double step) {
  test.system.source += ", other settings";
  test.system.turtle.start = start;
  test.system.turtle.convention = convention;
  test.system.turtle.step = step;
  return test;
}

inline std::vector<TestCase> planar_test_cases() {
  const TestCase bush = test_case("bush", "F", {{'F', "FF-[-F+F+F]+[+F-F-F]"}}, 22.5, 4);
  const TestCase dragon = test_case("dragon", "FX", {{'X', "X+YF+"}, {'Y', "-FX-Y"}}, 90, 11);
  return {
      test_case("island", "F-F-F-F", {{'F', "F-F+F+FF-F-F+F"}}, 90, 4),
      test_case("gasket", "A", {{'A', "B+A+B"}, {'B', "A-B-A"}}, 60, 8, "AB"),
      test_case("hilbert", "A", {{'A', "+BF-AFA-FB+"}, {'B', "-AF+BFB+FA-"}}, 90, 6),
      dragon,
      test_case("gosper", "A", {{'A', "A-B--B+A++AA+B-"}, {'B', "+A-BB--B-A++A+B"}}, 60, 4, "AB"),
      test_case("branches", "F", {{'F', "F[+F]F[-F][F]"}}, 25.7, 5),
      test_case("plant", "X", {{'X', "F-[[X]+X]+F[+FX]-X"}, {'F', "FF"}}, 22.5, 6),
      bush,
      with_settings(bush, TurtleStart::local, TurtleConvention::abop_matrices, 0.25),
      with_settings(dragon, TurtleStart::local, TurtleConvention::cpfg, 3.0),
      test_case("islands and lakes", "F+F+F+F",
                {{'F', "F+f-FF+F+FF+Ff+FF-f+FF-F-FF-Ff-FFF"}, {'f', "ffffff"}}, 90, 2),
      test_case("no fraction of a turn", "F", {{'F', "F+F-[F|F]F"}}, std::sqrt(2.0) * 31, 5),
      test_case("angle of seconds", "F", {{'F', "F+F--F+F"}}, 0.0125, 6),
      test_case("backwards", "F|F", {{'F', "|F+F|[-F]F"}}, -450.0, 5),
      test_case("large angle", "F", {{'F', "F+F-F"}}, 1234.5, 6),
      test_case("angle of nothing", "F+F", {{'F', "F-F|"}}, 0, 5),
      test_case("turns only at last", "FA", {{'A', "-[B]A"}, {'B', "+FC"}, {'C', "f"}, {'-', "+"}},
                36, 30),
      test_case("one after the other", "A", {{'A', "F+A"}}, 5, 700),
      test_case("one in the other", "A", {{'A', "F[+A]-"}}, 5, 700),
      test_case("many that draw little", "A", {{'A', "FB[A]"}, {'B', "+B-f"}}, 90, 60),
      test_case("polygons and pens", "F", {{'F', "!F'{.-f+G.}[!'f]F"}}, 30, 6, "FG"),
      test_case("moves only", "f", {{'f', "f+f[f]"}}, 90, 4),
      test_case("draws nothing", "ABC[A]", {{'A', "B[C]"}}, 90, 4),
      test_case("vanishes", "FFA", {{'F', ""}, {'A', "A[+]F"}}, 90, 6),
      test_case("stays", "F+F[F]", {}, 90, 9),
      test_case("underived", "F+F", {{'F', "FF"}}, 90, 0),
      test_case("one", "F", {}, 90, 0),
  };
}

inline std::vector<TestCase> spatial_test_cases() {
  const TestCase bush = test_case("bush in space", "A",
                                  {{'A', "[&FL!A]/////'[&FL!A]///////'[&FL!A]"},
                                   {'F', "S/////F"},
                                   {'S', "FL"},
                                   {'L', "['''^^{-f+f+f-|-f+f+f}]"}},
                                  22.5, 6);
  const TestCase cube = test_case("hilbert in space", "A",
                                  {{'A', "B-F+CFC+F-D&F^D-F+&&CFC+F+B//"},
                                   {'B', "A&F^CFB^F^D^^-F-D^|F^B|FC^F^A//"},
                                   {'C', "|D^|F^B-F+C^F^A&&FA&F^C+F+B^F^D//"},
                                   {'D', "|CFB-F+B|FA&F^A&&FB-F+B|FC//"}},
                                  90, 3);
  return {bush,
          with_settings(bush, TurtleStart::local, TurtleConvention::abop_matrices, 0.5),
          with_settings(bush, TurtleStart::upwards, TurtleConvention::cpfg, 2.0),
          cube,
          with_settings(cube, TurtleStart::local, TurtleConvention::lpfg_uncorrected, 4.0),
          test_case("many turns", "A", {{'A', "F+&/F-^\\A"}}, 17, 400),
          test_case("never in the plane", "F", {{'F', "F/F&F"}}, 33, 6)};
}

inline std::vector<TestCase> all_test_cases() {
  std::vector<TestCase> all = planar_test_cases();
  for (TestCase& test : spatial_test_cases()) all.push_back(std::move(test));
  return all;
}

}  // namespace phytobench
