// SPDX-License-Identifier: MIT
// Measurements on which a claim holds, made from those of a run. With them each claim can be tried
// both ways, whatever the run has measured and however short it was.
#pragma once

#include <map>
#include <optional>
#include <string>

#include "reference/claims.hpp"
#include "reports/judge/evidence.hpp"

namespace phytobench {

/// One value for each measurement. A time is its median, as if all rounds had taken that long.
using Measurements = std::map<std::string, RecordValue>;

/// What `claim` rests on, as far as the run has it. Of many measurements that are only counted
/// (`matches`), those that are equal to the text, and one other.
Measurements measurements_of(const Claim& claim, const Evidence& evidence);

Verdict verdict_on(const Claim& claim, const Measurements& measurements);

/// Whether it is reproduced, with or without an erratum.
bool holds(const Claim& claim, const Measurements& measurements);

/// `measurements`, completed and changed until the claim holds. Nothing if no such values were
/// found: then the checks contradict each other, or their bounds exclude everything.
std::optional<Measurements> fulfilled(const Claim& claim, Measurements measurements);

}  // namespace phytobench
