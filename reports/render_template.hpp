// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include <nlohmann/json_fwd.hpp>

namespace phytobench {

enum class EscapeFor { html, markdown };

/// Fills a mustache template with a document. {{x}} is escaped for the format, {{{x}}} is not.
/// Throws ContractViolation if the template is broken.
std::string render_template(const std::string& text, const nlohmann::ordered_json& document,
                            EscapeFor format);

}  // namespace phytobench
