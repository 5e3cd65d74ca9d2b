// SPDX-License-Identifier: MIT
// Plain sentences in the Markdown of a letter.
#pragma once

#include <string>

namespace phytobench {

/// The text with a backslash before what Markdown would take for markup, and only there, so that
/// formulas stay legible: "2 * r_i" and "a < b" are left alone, "*a*" and "<b>" are not.
std::string with_literal_markdown(const std::string& text);

/// The same with a full stop, unless it ends with one: "Put v = 0 into eq. 9.".
std::string as_sentence(const std::string& text);

/// What stands before the second sentence, as it is.
std::string first_sentence(const std::string& text);

}  // namespace phytobench
