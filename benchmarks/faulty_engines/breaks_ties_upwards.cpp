// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_engines/faulty_scan.hpp"

namespace phytobench::engines {

namespace {

struct Mistake : NoMistake {
  static bool wins(double candidate, double best) { return candidate <= best; }
};

}  // namespace

extern const EngineDescriptor breaks_ties_upwards;
constinit const EngineDescriptor breaks_ties_upwards{
    .name = "breaks_ties_upwards",
    .summary = "Wrong on purpose: of equally near nodes it takes the highest index.",
    .source = "a <= where a < belongs",
    .create = make_point_driven_engine<FaultyScan<Mistake>>,
};

}  // namespace phytobench::engines
