// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

namespace phytobench {

/// The worker's command line, see worker_protocol.hpp.
struct WorkerOptions {
  std::string command;  ///< list, verify, counters, calibrate, sample or once
  std::vector<std::string> names;
  std::vector<std::string> plugins;  ///< files
  double sample_ms = 10.0;
  double handicap = 0.0;
  bool with_selftest = false;
};

/// Throws InputError for what it does not know, and for numbers out of range.
WorkerOptions worker_options(const std::vector<std::string>& arguments);

}  // namespace phytobench
