// SPDX-License-Identifier: MIT
#include "core/tree/skeleton_svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>

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

}  // namespace

std::string skeleton_svg(const Skeleton& skeleton, const std::string& title) {
  BoundingBox box;
  for (const Vector3& p : skeleton.positions()) box.extend(p);
  const double extent = std::max({box.extent().x, box.extent().y, 1e-9});
  const double scale = height_units / extent;
  const auto column = [&](const Vector3& p) { return std::lround((p.x - box.low().x) * scale); };
  const auto row = [&](const Vector3& p) { return std::lround((box.high().y - p.y) * scale); };

  const std::vector<std::int32_t> tips = tips_above(skeleton);
  std::map<int, std::string, std::greater<>> paths;
  for (std::size_t i = 1; i < skeleton.node_count(); ++i) {
    const Vector3& from = skeleton.position(skeleton.parents()[i]);
    const Vector3& to = skeleton.positions()[i];
    paths[width_class(tips[i])] += fmt::format("M{} {}l{} {}", column(from), row(from),
                                               column(to) - column(from), row(to) - row(from));
  }
  std::string svg = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-10 -10 {} {}\" role=\"img\" "
      "fill=\"none\" "
      "stroke=\"currentColor\" stroke-linecap=\"round\"><title>{}</title>\n",
      std::lround(box.extent().x * scale) + 20, std::lround(box.extent().y * scale) + 20,
      escaped(title));
  for (const auto& [width, path] : paths)
    svg += fmt::format("<path stroke-width=\"{}\" d=\"{}\"/>\n", width / 2.0, path);
  return svg + "</svg>\n";
}

}  // namespace phytobench
