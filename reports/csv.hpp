// SPDX-License-Identifier: MIT
#pragma once

#include <string>
#include <vector>

#include "reports/judge/judged_run.hpp"

namespace phytobench {

/// One RFC 4180 line: fields with commas, quotes or line ends are quoted.
std::string csv_line(const std::vector<std::string>& fields);

/// id, locator, kind, verdict, basis, published, measured, expected, reason. What rests on times is
/// left out on request.
std::string claims_csv(const JudgedRun& judged, bool without_varying);

/// measurement, value, unit, n, seed.
std::string records_csv(const RunContents& run);

}  // namespace phytobench
