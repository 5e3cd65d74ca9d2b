// SPDX-License-Identifier: MIT
// Contracts that stay on in release: cheap conditions on inputs (expect) and results (ensure).
// Files and command lines are validated with InputError instead: a user is not a bug.
#pragma once

#include <string>

#include "core/contract/errors.hpp"

namespace phytobench {

[[noreturn]] inline void contract_failed(const char* kind, const char* condition, const char* file,
                                         int line) {
  throw ContractViolation(std::string(file) + ":" + std::to_string(line) + ": " + kind +
                          " failed: " + condition + " (a bug in phytobench, please report it)");
}

}  // namespace phytobench

/// What a function demands of its caller.
#define PHYTOBENCH_EXPECT(condition) \
  ((condition) ? void()              \
               : ::phytobench::contract_failed("expectation", #condition, __FILE__, __LINE__))

/// What a function promises about its result.
#define PHYTOBENCH_ENSURE(condition) \
  ((condition) ? void() : ::phytobench::contract_failed("promise", #condition, __FILE__, __LINE__))
