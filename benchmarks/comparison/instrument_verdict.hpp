// SPDX-License-Identifier: MIT
// What the self-test's counts say of the instrument.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "benchmarks/comparison/instrument_check.hpp"
#include "core/statistics/estimate.hpp"

namespace phytobench {

/// What must hold of an instrument that can be trusted.
inline constexpr double most_false_alarms = 0.05;  ///< share of slower or faster among equal sides
inline constexpr double least_found = 0.9;         ///< share of slower among handicapped sides

enum class InstrumentState {
  proven,    ///< all that must hold was seen to hold
  unproven,  ///< nothing shows that it is broken; the machine was too noisy, or time too short
  broken,
};

std::string_view name_of(InstrumentState state);

struct InstrumentVerdict {
  InstrumentState state = InstrumentState::unproven;
  std::vector<std::string> reasons;  ///< a sentence for all that is not as it must be
};

/// False alarms in the sense of most_false_alarms, of all comparisons of equal sides, with the
/// exact 95 % interval; at least one comparison.
Estimate false_alarms(const InstrumentCheck& check);

/// Handicaps that were found, alike.
Estimate found_handicaps(const InstrumentCheck& check);

/// Broken: a broken benchmark was not refused; false alarms are more often than allowed or losses
/// found more seldom by more than chance, by the 95 % intervals. Losses that were inconclusive do
/// not count where equal sides differ by more than half the handicap: that is the machine.
/// Unproven: a share is not what it must be, but might be by chance, or most comparisons of the
/// steady benchmark with itself were inconclusive, or time ended first.
InstrumentVerdict judge_instrument(const InstrumentCheck& check);

}  // namespace phytobench
