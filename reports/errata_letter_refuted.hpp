// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// A statement that does not hold, as a line of a letter: where it stands, what it says, what was
/// printed, what was looked for and why, and what was measured. In sentences, without names of
/// claims and measurements, which mean nothing to an author.
std::string refuted_entry(const Judgement& judgement, const JudgedPaper& work);

}  // namespace phytobench
