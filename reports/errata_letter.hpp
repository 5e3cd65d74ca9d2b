// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Notes on a work that can be sent to its author, in Markdown: its errata in the order of the
/// work, each with a worked example and a way to check it by hand, and apart from them what is
/// sound as printed but not what the program of the work does; the assumptions as questions; what
/// was confirmed and what was not. Needs nothing of this suite to be read. Left out on request:
/// verdicts that rest on times, so that equal runs give equal bytes.
std::string errata_letter(const JudgedPaper& judged, bool without_varying);

/// The text with a backslash before what Markdown would take for markup, and only there, so that
/// formulas stay legible: "2 * r_i" and "a < b" are left alone, "*a*" and "<b>" are not.
std::string with_literal_markdown(const std::string& text);

}  // namespace phytobench
