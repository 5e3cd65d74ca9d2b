// SPDX-License-Identifier: MIT
#pragma once

#include <optional>
#include <string>

#include "reference/claims.hpp"
#include "reports/judge/evidence.hpp"

namespace phytobench {

/// Correct digits of a measured number: min(15, -log10(|measured - published| / |published|)), the
/// log relative error of NIST's reference data sets, at least 0. `published` must not be 0.
double digits_of_agreement(double measured, double published);

/// The number a text consists of, with a decimal point or the works' decimal comma; nothing for any
/// other text.
std::optional<double> number_in(const std::string& text);

/// "all digits", or "2.9 digits": how far the measured number of a claim agrees with the published
/// one. Empty unless the claim has one of each: a published text that is one number other than 0,
/// and one check with one term on recorded values whose two bounds hold that number. Other checks
/// bound something else, such as a difference.
std::string shown_agreement(const Claim& claim, const Evidence& evidence);

}  // namespace phytobench
