// SPDX-License-Identifier: MIT
// Names of the places inside a report that links lead to.
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// A text as a CSS class or part of an anchor: everything but letters and digits becomes one '-'.
std::string slug(std::string_view text);

std::string claim_anchor(std::string_view claim_id);
std::string erratum_anchor(std::string_view paper, std::string_view id);
std::string assumption_anchor(std::string_view paper, std::string_view id);
std::string topic_anchor(std::string_view paper, std::string_view topic);
std::string experiment_anchor(std::string_view experiment);

/// The id without the key of its work: "eq-17/implementation-reading".
std::string short_claim_id(std::string_view claim_id);

}  // namespace phytobench
