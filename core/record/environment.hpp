// SPDX-License-Identifier: MIT
#pragma once

#include <cstdint>
#include <string>
#include <vector>

namespace phytobench {

/// A library or tool and the version in use; empty version: not there.
struct Component {
  std::string name;
  std::string version;
  std::string purpose;
};

/// Libraries linked into core, with versions asked at run time where the library can tell.
std::vector<Component> linked_components();

/// How busy the machine is and what it is.
struct Machine {
  std::string processor;
  std::vector<std::string> caches;  ///< "L1d 48 KiB", ...
  int logical_processors = 0;
  double memory_gib = 0.0;
  std::string kernel;
  bool virtual_machine = false;
  double load_1min = 0.0;
  double load_5min = 0.0;
};

Machine this_machine();

/// environment.json: what must be known to judge and to repeat a run.
std::string environment_json(const std::string& command_line, std::uint64_t seed, int threads);

/// The first thing that must be equal in both parts of one resumed run and is not (commit,
/// compiler, flags, threads, processor), as "commit abc instead of def"; empty if all agree or
/// `before` holds none of it.
std::string difference_of_origin(const std::string& before, const std::string& now);

}  // namespace phytobench
