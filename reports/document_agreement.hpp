// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "reference/claims.hpp"
#include "reports/judge/evidence.hpp"

namespace phytobench {

/// The number a text consists of, with a decimal point or the works' decimal comma; nothing for any
/// other text.
std::optional<double> number_in(const std::string& text);

/// "all digits" if the computed number rounds to the published one, else how many of the printed
/// digits agree: "2 of 4 digits", the whole part of log_relative_error(). Empty unless the claim
/// has one number of each kind: a published text that is one number other than 0, and one check
/// with one term on recorded values whose two bounds hold that number. Other checks bound something
/// else, such as a difference. Empty, too, for sampled values: what chance adds is no digit.
std::string shown_agreement(const Claim& claim, const Evidence& evidence);

}  // namespace phytobench
