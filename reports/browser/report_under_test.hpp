// SPDX-License-Identifier: MIT
#pragma once

#include <filesystem>

namespace phytobench {

/// Writes a run that no experiment has made, and its report into `folder`. What the claims name is
/// recorded so that the claims hold, but for what others that share a measurement need, and for
/// some measurements that are left out: there are claims of most verdicts, times of three rounds,
/// full tables, a drawing and a photograph of each work.
void make_report_under_test(const std::filesystem::path& folder);

}  // namespace phytobench
