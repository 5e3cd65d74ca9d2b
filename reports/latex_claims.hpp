// SPDX-License-Identifier: MIT
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// All claims of a work as one longtable: claim, place, published, measured, verdict. What the run
/// lacks (`incomplete`, empty for a whole run) stands below them.
std::string latex_claim_table(const JudgedPaper& paper, bool without_varying,
                              const std::string& incomplete = "");

/// Commands by which a paper quotes a claim by its id, so that its numbers change with the run:
/// \phytobenchclaim{brzoska2019/eq-22/density} is what was measured, \phytobenchpublished,
/// \phytobenchverdict and \phytobenchbasis the rest. An id that does not exist is an error of
/// LaTeX; a claim without a measurement reads as its verdict in parentheses.
std::string latex_claim_macros(const JudgedRun& judged, bool without_varying);

/// A document that holds every table of the report, to be compiled as it is.
std::string latex_wrapper(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
