// SPDX-License-Identifier: MIT
// Options that several races have, under the same names and limits.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include <CLI/CLI.hpp>

#include "cli/command_line/command_line.hpp"
#include "cli/command_line/list_options.hpp"

namespace phytobench::cli {

inline void add_names(CLI::App& race, const std::string& option, std::vector<std::string>& names,
                      const std::string& help) {
  as_one_list_of_names(race.add_option(option, names, help))->capture_default_str();
}

inline void add_thread_counts(CLI::App& race, std::vector<int>& threads, const std::string& help) {
  as_one_list_of_names(race.add_option("--threads", threads, help))
      ->capture_default_str()
      ->check(CLI::Range(1, 1024));
}

/// Seconds, beyond which nothing is begun.
inline void add_budget(CLI::App& race, double& seconds, const std::string& help) {
  race.add_option("--budget", seconds, help)->capture_default_str()->check(CLI::Range(1e-6, 1e6));
}

inline void add_rounds(CLI::App& race, int& rounds) {
  race.add_option("--rounds", rounds, "Timed rounds")
      ->capture_default_str()
      ->check(CLI::Range(1, 1000));
}

inline void add_rounds_or_none(CLI::App& race, int& rounds) {
  race.add_option("--rounds", rounds, "Timed rounds; 0: what fits into a minute, 3 to 25")
      ->capture_default_str()
      ->check(CLI::Range(0, 1000));
}

inline void add_seed(CLI::App& race, std::uint64_t& seed, const std::string& help) {
  race.add_option("--seed", seed, help)->capture_default_str()->check(whole_number);
}

inline void add_json(CLI::App& race, bool& json) {
  race.add_flag("--json", json, "One JSON document");
}

}  // namespace phytobench::cli
