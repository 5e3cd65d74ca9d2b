// SPDX-License-Identifier: MIT
#include "core/tree/skeleton_svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>
#include <vector>

#include <fmt/format.h>

#include "core/geometry/bounding_box.hpp"
#include "core/tree/branches.hpp"

namespace phytobench {

namespace {

constexpr double height_units =
    1000.0;  // the drawing's grid is one of whole numbers, to keep it small
constexpr double pipe_exponent = 1.9;
constexpr double tip_width = 1.0;
constexpr double widest = 14.0;

std::string escaped(const std::string& text) {
  std::string result;
  for (const char c : text) result += c == '&' ? "&amp;" : c == '<' ? "&lt;" : std::string(1, c);
  return result;
}

/// Line width class: all edges of one class share a path element.
int width_class(int tips) {
  const double width = tip_width * std::pow(tips, 1.0 / pipe_exponent);
  return static_cast<int>(std::lround(2.0 * std::min(width, widest)));
}

/// Where nodes lie in the drawing.
struct Grid {
  BoundingBox box;
  double scale;

  long column(const Vector3& p) const { return std::lround((p.x - box.low().x) * scale); }
  long row(const Vector3& p) const { return std::lround((box.high().y - p.y) * scale); }
};

/// "l" and a relative step; after the first, only the numbers.
std::string step(const Grid& grid, const Vector3& from, const Vector3& to, bool is_first) {
  const long right = grid.column(to) - grid.column(from), down = grid.row(to) - grid.row(from);
  return fmt::format("{}{}{}{}", is_first ? "l" : (right < 0 ? "" : " "), right,
                     down < 0 ? "" : " ", down);
}

/// A path per line width. Branches are drawn in one go as far as they keep their width, which takes
/// two thirds of the bytes of single edges.
std::map<int, std::string, std::greater<>> paths_of(const Skeleton& skeleton, const Grid& grid) {
  const std::vector<std::int32_t> tips = tips_above(skeleton);
  const ChildLists children(skeleton);
  const auto width_of = [&](std::size_t node) { return width_class(tips[node]); };
  std::map<int, std::string, std::greater<>> paths;
  std::vector<bool> is_drawn(skeleton.node_count(), false);
  for (std::size_t start = 1; start < skeleton.node_count(); ++start) {
    if (is_drawn[start]) continue;
    std::string& path = paths[width_of(start)];
    Vector3 from = skeleton.position(skeleton.parents()[start]);
    path += fmt::format("M{} {}", grid.column(from), grid.row(from));
    for (std::optional<std::size_t> node = start, next; node; node = next) {
      const Vector3& to = skeleton.positions()[*node];
      path += step(grid, from, to, *node == start);
      is_drawn[*node] = true;
      from = to;
      next.reset();
      for (const std::int32_t child : children.of(static_cast<std::int32_t>(*node)))
        if (const auto i = static_cast<std::size_t>(child); !next && width_of(i) == width_of(start))
          next = i;
    }
  }
  return paths;
}

}  // namespace

std::string skeleton_svg(const Skeleton& skeleton, const std::string& title) {
  BoundingBox box;
  for (const Vector3& p : skeleton.positions()) box.extend(p);
  const double scale = height_units / std::max({box.extent().x, box.extent().y, 1e-9});
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 {} {}\" role=\"img\" "
      "fill=\"none\" "
      "stroke=\"currentColor\" stroke-linecap=\"round\" "
      "stroke-linejoin=\"round\"><title>{}</title>\n",
      std::lround(box.extent().x * scale) + 20, std::lround(box.extent().y * scale) + 20,
      escaped(title));
  for (const auto& [width, path] : paths_of(skeleton, {box, scale}))
    svg += fmt::format("<path stroke-width=\"{}\" d=\"{}\"/>\n", width / 2.0, path);
  return svg + "</svg>\n";
}

}  // namespace phytobench
