// SPDX-License-Identifier: MIT
#include "core/terrain/shadow/ray_groups.hpp"

namespace phytobench {

namespace {

/// Vertices that crossings lie between, along one axis and relative to their ray's vertex.
struct Span {
  int begin;
  int length;
};

/// `first` and `last` are how far away the first and the last crossing's vertices are at most; the
/// first one's other vertex may be one less.
Span span_of(int first, int last, bool goes_up) {
  const int nearest = std::max(first - 1, 0);
  return {goes_up ? nearest : -last, last - nearest + 1};
}

}  // namespace

RayGroups::RayGroups(const HeightPyramid& pyramid, const RayPattern& pattern, int tile)
    : highest_(pyramid.highest()) {
  const std::size_t crossings = pattern.crossings().size();
  for (std::size_t size = smallest; size == smallest || size < crossings; size *= 2) {
    std::vector<Group>& level = levels_.emplace_back();
    for (std::size_t first = 0; first < crossings; first += size)
      level.push_back(
          group_of(pattern, pyramid, first, std::min(first + size, crossings) - 1, tile));
  }
}

RayGroups::Group RayGroups::group_of(const RayPattern& pattern, const HeightPyramid& pyramid,
                                     std::size_t first, std::size_t last, int tile) {
  const RayCrossing& from = pattern.crossings()[first];
  const RayCrossing& to = pattern.crossings()[last];
  const Span columns = span_of(from.columns, to.columns, pattern.goes_east());
  const Span rows = span_of(from.rows, to.rows, pattern.goes_south());
  const HeightPyramid::Level& level =
      pyramid.level_for(columns.length + tile - 1, rows.length + tile - 1);
  return {from.rise, columns.begin, rows.begin, level.highest.data(), level.columns, level.shift};
}

}  // namespace phytobench
