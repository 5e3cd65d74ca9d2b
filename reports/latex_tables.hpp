// SPDX-License-Identifier: MIT
// Tables for an appendix, in the manner of the package booktabs. Each file holds one tabular and
// nothing else, so that its reader decides on float, caption and size.
#pragma once

#include <string>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// A printed table of a work with what was measured beside each cell. Cells that were not measured,
/// or are times and are left out on request, show what is printed alone.
std::string latex_table(const JudgedTable& judged, bool without_varying);

/// Of a table of times, the cells as shares of the largest one, printed beside measured: times of
/// two machines can be compared in no other way. Empty for other tables and unmeasured ones.
std::string latex_share_table(const JudgedTable& judged, bool without_varying);

/// Number of claims by verdict and basis.
std::string latex_counts(const JudgedRun& judged, bool without_varying);

}  // namespace phytobench
