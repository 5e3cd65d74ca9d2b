// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_engines/faulty_scan.hpp"

namespace phytobench::engines {

namespace {

struct Mistake : NoMistake {
  static double measured(double squared_distance) {
    constexpr double kept = 0x1p45;  // of 53 bits, 45 are rounded away
    const double lifted = squared_distance * kept;
    return (squared_distance + lifted) - lifted;
  }
};

}  // namespace

extern const EngineDescriptor rounds_distances;
constinit const EngineDescriptor rounds_distances{
    .name = "rounds_distances",
    .summary = "Wrong on purpose: compares distances rounded to eight bits.",
    .source = "too little precision",
    .create = make_point_driven_engine<FaultyScan<Mistake>>,
};

}  // namespace phytobench::engines
