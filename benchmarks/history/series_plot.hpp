// SPDX-License-Identifier: MIT
// A series of values, one for each run, as a picture: on a terminal and as an SVG.
#pragma once

#include <string>
#include <vector>

#include "benchmarks/history/history_file.hpp"

namespace phytobench {

/// Values that may be compared: of one machine class and build, where these matter.
struct HistoryLine {
  std::string name;  ///< what they share; empty if nothing
  std::vector<HistoryPoint> points;
};

/// Points of a series in lines: counters make a single one, since no machine changes them;
/// instructions one for each machine class, compiler and set of flags; ratios the same. In the
/// order of their first points.
std::vector<HistoryLine> comparable_lines(const std::vector<HistoryPoint>& series);

/// Eleven lines of text and an axis, `width` columns at most; later runs to the right. Of more
/// points than columns each column shows the last of its share.
std::string series_text(const HistoryLine& line, std::size_t width = 72);

/// All lines against the runs' numbers, from the smallest value to the largest, in the page's text
/// colour. The same series gives the same bytes.
std::string series_svg(const std::vector<HistoryLine>& lines, const std::string& title);

/// A sentence where the last values stand on another level than those before: the median of the
/// last three is off the earlier median by more than five robust standard deviations of these
/// (1.4826 times the median absolute deviation) and by more than 0.2 %. Empty otherwise, and with
/// fewer than six earlier values.
std::string step_note(const std::vector<HistoryPoint>& points);

}  // namespace phytobench
