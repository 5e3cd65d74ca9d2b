// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace phytobench {

enum class GateOutcome { passed, failed, skipped };

/// What a gate says of one benchmark.
struct GateCase {
  std::string name;
  GateOutcome outcome = GateOutcome::passed;
  std::string message;  ///< shown by test runners; may be empty where it passed
};

/// One test case for each benchmark. The suite is named after the command that was run: "compare",
/// "bench counters" or "bench instructions"; its last word begins the cases' classes.
std::string gate_junit(std::string_view command, const std::vector<GateCase>& cases);

}  // namespace phytobench
