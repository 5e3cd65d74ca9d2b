// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// Notes on a work that can be sent to its author, in Markdown: first its strongest errata, then
/// all in the order of the work, each with a worked example and a way to check it by hand, and
/// apart from them what is sound as printed but not what the program of the work does; the
/// assumptions as questions; what was confirmed and what was not. Needs nothing of this suite to be
/// read. Left out on request: verdicts that rest on times, so that equal runs give equal bytes.
std::string errata_letter(const JudgedPaper& judged, bool without_varying);

}  // namespace phytobench
