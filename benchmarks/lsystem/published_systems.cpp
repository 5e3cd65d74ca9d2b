// SPDX-License-Identifier: MIT
// The seven systems on which M. Zucker timed his programs ("Optimizing L-Systems", 2020), so that
// nanoseconds a segment can be compared. All but the last are common examples; his turtle draws a
// step for every letter unless a system names those that draw.
#include <array>

#include "benchmarks/lsystem/bench_systems.hpp"

namespace phytobench {

namespace {

constexpr auto zucker_systems = std::to_array<BenchSystem>({
    {"sierpinski_arrowhead",
     "axiom: A\n"
     "A -> B-A-B\n"
     "B -> A+B+A\n"
     "angle: 60  start: local\n"
     "draw: A B\n",
     17},
    {"sierpinski_triangle",
     "axiom: F-G-G\n"
     "F -> F-G+F+G-F\n"
     "G -> GG\n"
     "angle: 120  start: local\n"
     "draw: F G\n",
     16},
    {"dragon_every_letter",
     "axiom: FX\n"
     "X -> X+YF+\n"
     "Y -> -FX-Y\n"
     "angle: 90  start: local\n"
     "draw: F X Y\n",
     26},
    {"barnsley_fern",
     "axiom: X\n"
     "X -> F+[[X]-X]-F[-FX]+X\n"
     "F -> FF\n"
     "angle: 25  start: local\n"
     "draw: F X\n",
     13},
    {"sticks",
     "axiom: X\n"
     "X -> F[+X]F[-X]+X\n"
     "F -> FF\n"
     "angle: 20  start: local\n"
     "draw: F\n",
     16},
    {"hilbert",
     "axiom: L\n"
     "L -> +RF-LFL-FR+\n"
     "R -> -LF+RFR+FL-\n"
     "angle: 90  start: local\n"
     "draw: F\n",
     13},
    {"pentaplexity",
     "axiom: F++F++F++F++F\n"
     "F -> F++F++F+++++F-F++F\n"
     "angle: 36  start: local\n"
     "draw: F\n",
     9},
});

}  // namespace

std::span<const BenchSystem> published_systems() {
  return zucker_systems;
}

}  // namespace phytobench
