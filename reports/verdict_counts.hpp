// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judge.hpp"

namespace phytobench {

/// Whether a claim holds only because a parameter was chosen to meet a number: such a verdict is
/// counted apart from the plain ones.
bool is_fitted(const Judgement& judgement);

inline constexpr const char* fitted_row = "reproduced, fitted";

/// Whether the run measured anything that the claim rests on.
bool has_measurement(const Judgement& judgement);

}  // namespace phytobench
