// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

#include "reports/judge/judge.hpp"

namespace phytobench {

/// The verdict as a CSS class.
std::string verdict_class(Verdict verdict);

/// Everything a report says about one claim. A hidden one (it rests on times that are left out)
/// keeps only what does not vary.
nlohmann::ordered_json claim_document(const Judgement& judgement, bool hidden);

}  // namespace phytobench
