// SPDX-License-Identifier: MIT
#include "benchmarks/faulty_engines/faulty_scan.hpp"

namespace phytobench::engines {

namespace {

struct Mistake : NoMistake {
  static double told(double squared_distance) {
    return static_cast<double>(static_cast<float>(squared_distance));
  }
};

}  // namespace

extern const EngineDescriptor rounds_distances;
constinit const EngineDescriptor rounds_distances{
    .name = "rounds_distances",
    .summary = "Wrong on purpose: right nodes, distances rounded to float.",
    .source = "single precision",
    .create = make_point_driven_engine<FaultyScan<Mistake>>,
};

}  // namespace phytobench::engines
