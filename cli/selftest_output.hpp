// SPDX-License-Identifier: MIT
// How `phytobench selftest` says what it found.
#pragma once

#include <string>

#include "benchmarks/comparison/instrument_verdict.hpp"
#include "cli/commands.hpp"

namespace phytobench::cli {

/// Schema phytobench/selftest-1: state (proven, not proven, broken), reasons; alike and handicapped
/// {wanted, compared, slower, faster, same, inconclusive, other}; usual, the same with
/// benchmarks, their names, that one comparison is made of; false_alarms of alike and usual and
/// found_handicaps {share, low, high}, with exact 95 % intervals, or null without comparisons;
/// handicap and found_handicap, the median that was seen of it, as shares; noise_floor, a share;
/// refusals [{benchmark, demanded, found, refused}]; seed, seconds, environment.
std::string selftest_json(const InstrumentCheck& check, const InstrumentVerdict& verdict,
                          const SelftestOptions& options);
std::string selftest_text(const InstrumentCheck& check, const InstrumentVerdict& verdict);

}  // namespace phytobench::cli
