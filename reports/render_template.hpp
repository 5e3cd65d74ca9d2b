// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>
#include <map>
#include <string>
#include <string_view>

#include <nlohmann/json_fwd.hpp>

namespace phytobench {

enum class EscapeFor { html, markdown };

/// Parts of templates by name.
using Partials = std::map<std::string, std::string>;

/// The text with every {{> name}} replaced by that part, parts inside parts too. One that is absent
/// leaves nothing, not even its line. Throws ContractViolation if a part contains itself.
std::string with_partials(std::string_view text, const Partials& partials);

/// Fills a mustache template with a document. {{x}} is escaped for the format, {{{x}}} is not.
/// Throws ContractViolation if the template is broken.
std::string render_template(const std::string& text, const nlohmann::ordered_json& document,
                            EscapeFor format);

/// Fills the template `folder`/<format>/report.mustache, whose parts are its neighbours
/// <name>.mustache, where <format> is html or md. Throws InputError if it is not there.
std::string render_report(const std::filesystem::path& folder,
                          const nlohmann::ordered_json& document, EscapeFor format);

}  // namespace phytobench
