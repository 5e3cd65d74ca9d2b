// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <functional>
#include <string>
#include <vector>

#include "benchmarks/comparison/stored_result.hpp"
#include "benchmarks/comparison/timed_side.hpp"

namespace phytobench {

/// This machine, as a stored result names it.
ResultMachine this_result_machine();

struct ResultRequest {
  TimedSide* side = nullptr;
  SideOrigin origin;
  ResultMachine machine;
  std::vector<std::string> names;  ///< benchmarks of the side; at least one
  std::string reference;           ///< one of them that other times are divided by; empty: none
  std::uint64_t seed = 0;          ///< of the order of benchmarks in each process
  int processes = 12;              ///< >= 1
  int samples = 5;                 ///< of each benchmark in each process; >= 1
  double sample_ms = 10.0;         ///< > 0
  std::function<void(const std::string&)> show_progress = {};  ///< may be empty
  std::function<bool()> is_interrupted = {};                   ///< may be empty
};

/// Times one build, to be stored or compared with what was. A wrong answer gets no time, and the
/// benchmark an objection; so does one that workers die of, see WorkerDeaths: nothing is kept of a
/// process that died. Throws Interrupted, with nothing kept, and what the side throws besides.
StoredResult measure_result(const ResultRequest& request);

}  // namespace phytobench
