// SPDX-License-Identifier: MIT
#include "core/lsystem/drawing_svg.hpp"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>

#include <fmt/format.h>

#include "core/contract/check.hpp"
#include "core/contract/errors.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/lsystem/drawing_lines.hpp"
#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/svg_path_text.hpp"
#include "core/picture/camera.hpp"
#include "core/picture/image.hpp"
#include "core/picture/svg_text.hpp"

namespace phytobench {

namespace {

constexpr double grid_of_pixel = 100.0;  // whole numbers in a pixel
constexpr double margin = 10.0;          // pixels
constexpr int depth_layers = 5;
constexpr double palest = 0.45;  // opacity of the farthest layer
constexpr std::size_t most_parts = 2'000'000;

/// Puts points on the picture: right, up, and towards the eye.
class Projection {
 public:
  Projection(const Drawing& drawing, const DrawingSvgOptions& options) {
    Camera camera;
    camera.azimuth_deg = options.azimuth_deg;
    camera.elevation_deg = options.elevation_deg;
    if (!drawing.planar) {
      const ViewFrame frame = view_frame(camera);
      right_ = frame.right;
      up_ = frame.up;
      nearer_ = -1.0 * frame.forward;
    }
    for (const TurtleSegment& segment : drawing.segments) {
      box_.extend(turned(segment.from));
      box_.extend(turned(segment.to));
    }
    for (const Vector3& corner : drawing.corners) box_.extend(turned(corner));
    if (box_.empty()) box_.extend({});
    const double longest = std::max(box_.extent().x, box_.extent().y);
    constexpr double smallest = 1e-200;  // what is smaller is a point
    scale_ = longest > smallest ? options.longer_side / longest : 1.0;
    layers_ = drawing.planar || !(box_.extent().z > 0.0) ? 1 : depth_layers;
  }

  double scale() const { return scale_; }  ///< pixels of a length unit
  double width() const { return box_.extent().x * scale_; }
  double height() const { return box_.extent().y * scale_; }
  int layers() const { return layers_; }

  GridPoint on_grid(const Vector3& point) const {
    const Vector3 p = turned(point);
    return {std::lround((p.x - box_.low().x) * scale_ * grid_of_pixel),
            std::lround((box_.high().y - p.y) * scale_ * grid_of_pixel)};
  }
  /// 0 is the farthest.
  int layer_of(const Vector3& point) const {
    if (layers_ == 1) return 0;
    const double share = (turned(point).z - box_.low().z) / box_.extent().z;
    return std::clamp(static_cast<int>(share * layers_), 0, layers_ - 1);
  }

 private:
  Vector3 turned(const Vector3& p) const { return {dot(p, right_), dot(p, up_), dot(p, nearer_)}; }

  Vector3 right_{1, 0, 0}, up_{0, 1, 0}, nearer_{0, 0, 1};
  BoundingBox box_;
  double scale_ = 1.0;
  int layers_ = 1;
};

/// Widths of lines in quarters of a pixel.
class LineWidths {
 public:
  LineWidths(const Drawing& drawing, const Projection& projection,
             const DrawingSvgOptions& options) {
    if (drawing.segments.empty()) return;
    const auto [thinnest, widest] = std::minmax_element(
        drawing.segments.begin(), drawing.segments.end(),
        [](const TurtleSegment& a, const TurtleSegment& b) { return a.width < b.width; });
    const double largest = static_cast<double>(widest->width);
    const double mean_length =
        total_length(drawing) / static_cast<double>(drawing.segments.size()) * projection.scale();
    is_uniform_ = thinnest->width == widest->width;
    constexpr double share_of_length = 0.3;
    double pixels = is_uniform_ ? std::clamp(share_of_length * mean_length, 0.5, 2.5)
                                : width_of_different(largest * projection.scale(), options);
    if (options.widest_line > 0.0) pixels = options.widest_line;
    scale_ = largest > 0.0 ? pixels / largest : 0.0;
  }

  bool are_uniform() const { return is_uniform_; }
  int quarters(const TurtleSegment& segment) const {
    constexpr double thinnest_line = 0.5;  // pixels
    const double pixels = std::max(static_cast<double>(segment.width) * scale_, thinnest_line);
    return static_cast<int>(std::lround(4.0 * std::min(pixels, 1e6)));
  }

 private:
  /// True to scale, if that looks like a plant; many systems have widths in units of their own.
  static double width_of_different(double true_pixels, const DrawingSvgOptions& options) {
    const double least = 0.003 * options.longer_side, most = 0.03 * options.longer_side;
    return true_pixels >= least && true_pixels <= most ? true_pixels : 0.012 * options.longer_side;
  }

  double scale_ = 1.0;  // pixels of a unit of the turtle's width
  bool is_uniform_ = true;
};

/// Which path a part belongs to, in the order of painting: from far to near, lines before polygons,
/// wide before narrow.
using PathKey = std::tuple<int, bool, int, int>;  // layer, is polygon, minus quarters, colour

class DrawingPicture {
 public:
  DrawingPicture(const Drawing& drawing, const DrawingSvgOptions& options)
      : drawing_(drawing), projection_(drawing, options), widths_(drawing, projection_, options) {
    for (const std::string& colour : options.colours)
      colours_.push_back(to_text(parse_colour(colour)));
    put_lines();
    put_polygons();
  }

  std::string svg(const std::string& title) const {
    std::string text = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"-{0:.0f} -{0:.0f} {1:.0f} {2:.0f}\" "
        "role=\"img\" fill=\"none\" stroke=\"currentColor\" stroke-linecap=\"round\" "
        "stroke-linejoin=\"round\"><title>{3}</title>\n<g transform=\"scale({4})\">\n",
        margin, std::round(projection_.width()) + 2.0 * margin,
        std::round(projection_.height()) + 2.0 * margin, escaped_for_svg(title),
        1.0 / grid_of_pixel);
    for (const auto& [key, path] : paths_)
      text += fmt::format("<path{} d=\"{}\"/>\n", attributes_of(key), path.text());
    return text + "</g>\n</svg>\n";
  }

 private:
  int colour_class(std::uint16_t colour) const {
    return colours_.empty() ? 0 : static_cast<int>(colour % colours_.size());
  }

  void put_lines() {
    const auto style_of = [this](const TurtleSegment& segment) {
      const Vector3 middle = 0.5 * (segment.from + segment.to);
      const auto layer = static_cast<std::uint64_t>(projection_.layer_of(middle));
      const auto quarters = static_cast<std::uint64_t>(widths_.quarters(segment));
      return layer << 48 | quarters << 16 |
             static_cast<std::uint64_t>(colour_class(segment.colour));
    };
    for (const DrawnLine& line : drawn_lines(drawing_, style_of)) {
      const PathKey key{static_cast<int>(line.style >> 48), false,
                        -static_cast<int>(line.style >> 16 & 0xffffffff),
                        static_cast<int>(line.style & 0xffff)};
      std::vector<GridPoint> points;
      for (const Vector3& point : line.points) points.push_back(projection_.on_grid(point));
      paths_[key].add_line(grid_line(points));
    }
  }

  /// All the same way round: those that overlap in one path would cut holes otherwise.
  void put_polygons() {
    for (const TurtlePolygon& polygon : drawing_.polygons) {
      std::vector<GridPoint> outline;
      for (const Vector3& corner : corners_of(drawing_, polygon))
        outline.push_back(projection_.on_grid(corner));
      outline = grid_line(outline);
      if (outline.size() < 3) continue;
      double twice_area = 0.0;
      for (std::size_t i = 0; i < outline.size(); ++i) {
        const GridPoint& a = outline[i];
        const GridPoint& b = outline[(i + 1) % outline.size()];
        twice_area += static_cast<double>(a.x) * static_cast<double>(b.y) -
                      static_cast<double>(a.y) * static_cast<double>(b.x);
      }
      if (twice_area < 0.0) std::reverse(outline.begin(), outline.end());
      const int layer = projection_.layer_of(drawing_.corners[polygon.first]);
      paths_[{layer, true, 0, colour_class(polygon.colour)}].add_outline(outline);
    }
  }

  std::string attributes_of(const PathKey& key) const {
    const auto& [layer, is_polygon, minus_quarters, colour] = key;
    const std::string paint =
        colours_.empty() ? "currentColor" : colours_[static_cast<std::size_t>(colour)];
    std::string text;
    if (is_polygon)
      text += fmt::format(" fill=\"{}\" stroke=\"none\"", paint);
    else if (!colours_.empty())
      text += fmt::format(" stroke=\"{}\"", paint);
    if (!is_polygon)
      text += fmt::format(" stroke-width=\"{}\"", -minus_quarters * (grid_of_pixel / 4.0));
    double opacity = is_polygon && colours_.empty() ? 0.6 : 1.0;
    // Wide branches would show what is behind them.
    if (projection_.layers() > 1 && widths_.are_uniform())
      opacity *= palest + (1.0 - palest) * layer / (projection_.layers() - 1);
    if (opacity < 1.0) text += fmt::format(" opacity=\"{:.2g}\"", opacity);
    return text;
  }

  const Drawing& drawing_;
  Projection projection_;
  LineWidths widths_;
  std::vector<std::string> colours_;
  std::map<PathKey, SvgPathText> paths_;
};

}  // namespace

std::string drawing_svg(const Drawing& drawing, const std::string& title,
                        const DrawingSvgOptions& options) {
  PHYTOBENCH_EXPECT(options.longer_side > 0.0 && options.longer_side <= 1e6);
  const std::size_t parts = drawing.segments.size() + drawing.polygons.size();
  if (parts > most_parts)
    throw InputError(fmt::format(
        "a drawing of {} segments and polygons is too large for an SVG picture (at most {}); "
        "derive fewer steps, or write a .png",
        parts, most_parts));
  return DrawingPicture(drawing, options).svg(title);
}

}  // namespace phytobench
