// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/ray_pattern.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/contract/check.hpp"

namespace phytobench {

namespace {

/// A crossing and where it lies, before all are put in order.
struct Met {
  double distance;  ///< horizontal, m
  int line;         ///< how many lines of its kind have been met, this one included
  double across;    ///< how far along the line, in cells
  bool is_row;
};

/// The lines of one kind as a ray meets them.
struct Lines {
  double per_metre;         ///< how many of them
  double across_per_metre;  ///< and of the other kind
  int count;
  int across_count;

  /// Where the ray meets a line, in cells along it. A whole number where only rounding would put a
  /// vertex beside the ray: the ray would then see the height of neither line there, if a vertex
  /// next to it has no data.
  double across(int line) const {
    constexpr double rounding = 8.0 * std::numeric_limits<double>::epsilon();
    const double at = line * (across_per_metre / per_metre), whole = std::nearbyint(at);
    return std::abs(at - whole) <= rounding * whole ? whole : at;
  }
  /// Whether the ray meets a vertex there, which lies on a line of the other kind, too.
  bool meets_vertex(int line) const {
    const double at = across(line);
    return at > 0.0 && at == std::floor(at) &&
           others().across(static_cast<int>(at)) == static_cast<double>(line);
  }
  double distance(int line) const {
    const double own = line / per_metre;
    // Seen along rows or along columns, it is as far.
    return meets_vertex(line) ? std::min(own, across(line) / across_per_metre) : own;
  }

 private:
  Lines others() const { return {across_per_metre, per_metre, across_count, count}; }
};

/// The crossings with lines of that kind on the map.
void meet(const Lines& lines, bool is_row, std::vector<Met>& met) {
  if (lines.per_metre == 0.0) return;
  for (int line = 1; line < lines.count && lines.across(line) <= lines.across_count - 1; ++line)
    // A vertex lies on a line of either kind; that of its row is enough.
    if (is_row || !lines.meets_vertex(line))
      met.push_back({lines.distance(line), line, lines.across(line), is_row});
}

}  // namespace

RayPattern::RayPattern(const HeightField& field, const SunDirection& sun)
    : columns_(field.columns()),
      rows_(field.rows()),
      goes_east_(sun.east >= 0.0),
      goes_south_(sun.south >= 0.0) {
  PHYTOBENCH_EXPECT(sun.up >= 0.0 && (sun.east != 0.0 || sun.south != 0.0));
  const double horizontal = std::hypot(sun.east, sun.south);
  add_crossings(std::abs(sun.east) / horizontal / field.cell_width(),
                std::abs(sun.south) / horizontal / field.cell_depth(), sun.up / horizontal);
  count_within();
}

void RayPattern::add_crossings(double columns_per_metre, double rows_per_metre,
                               double rise_per_metre) {
  std::vector<Met> met;
  meet({rows_per_metre, columns_per_metre, rows_, columns_}, true, met);
  meet({columns_per_metre, rows_per_metre, columns_, rows_}, false, met);
  std::stable_sort(met.begin(), met.end(),
                   [](const Met& a, const Met& b) { return a.distance < b.distance; });
  const std::ptrdiff_t east = goes_east_ ? 1 : -1;
  const std::ptrdiff_t south = goes_south_ ? columns_ : -columns_;
  int farthest_column = 0, farthest_row = 0;
  for (const Met& one : met) {
    const int before = static_cast<int>(std::floor(one.across));
    const double fraction = one.across - before;
    const int beyond = fraction > 0.0 ? before + 1 : before;
    const auto at = [&](int across) {
      return one.is_row ? across * east + one.line * south : one.line * east + across * south;
    };
    farthest_column = std::max(farthest_column, one.is_row ? beyond : one.line);
    farthest_row = std::max(farthest_row, one.is_row ? one.line : beyond);
    if (farthest_column >= columns_ || farthest_row >= rows_) break;
    crossings_.push_back({at(before), at(beyond), fraction, one.distance * rise_per_metre,
                          farthest_column, farthest_row});
  }
}

void RayPattern::count_within() {
  within_columns_.assign(static_cast<std::size_t>(columns_), crossings_.size());
  within_rows_.assign(static_cast<std::size_t>(rows_), crossings_.size());
  for (std::size_t c = crossings_.size(); c-- > 0;) {
    // The first crossing that is farther than k stands in entry k.
    if (crossings_[c].columns > 0)
      within_columns_[static_cast<std::size_t>(crossings_[c].columns) - 1] = c;
    if (crossings_[c].rows > 0) within_rows_[static_cast<std::size_t>(crossings_[c].rows) - 1] = c;
  }
  for (std::size_t k = within_columns_.size() - 1; k-- > 0;)
    within_columns_[k] = std::min(within_columns_[k], within_columns_[k + 1]);
  for (std::size_t k = within_rows_.size() - 1; k-- > 0;)
    within_rows_[k] = std::min(within_rows_[k], within_rows_[k + 1]);
}

}  // namespace phytobench
