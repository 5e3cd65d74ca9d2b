// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <string_view>

namespace phytobench {

/// Text for LaTeX outside of mathematics: every character of LaTeX's own is escaped, letters and
/// signs beyond ASCII become commands of plain LaTeX, so that no package and no input encoding is
/// needed. A letter without a command is written as its code point, "U+4E00".
std::string latex_text(std::string_view utf8);

/// A number with a sign or an exponent as mathematics ("1e-06"); any other text as above.
std::string latex_value(std::string_view text);

/// An id in typewriter letters that may break between lines after a slash or hyphen.
std::string latex_id(std::string_view id);

}  // namespace phytobench
