// SPDX-License-Identifier: MIT
// Each cell is cut from the window by the bisectors with points around, nearest first, until twice
// its farthest corner holds no more points. All coordinates are taken from the cell's own point.
#include "core/point_pattern/voronoi.hpp"

#include <algorithm>
#include <cmath>

#include "core/contract/check.hpp"
#include "core/geometry/point_tree.hpp"
#include "core/parallel/for_blocks.hpp"

namespace phytobench {

namespace {

using Corners = std::vector<Point2>;

/// Keeps what lies on the side of the line where dot(x, normal) <= offset, of any polygon.
/// `scratch` keeps its memory.
void cut_any(Corners& corners, const Point2& normal, double offset, Corners& scratch) {
  scratch.clear();
  const std::size_t n = corners.size();
  for (std::size_t k = 0, last = n - 1; k < n; last = k++) {
    const double side = dot(corners[k], normal) - offset;
    const double side_before = dot(corners[last], normal) - offset;
    if ((side <= 0.0) != (side_before <= 0.0)) {
      const double share = side_before / (side_before - side);
      scratch.push_back(corners[last] + share * (corners[k] - corners[last]));
    }
    if (side <= 0.0) scratch.push_back(corners[k]);
  }
  corners.swap(scratch);
}

/// A convex polygon around the origin, with the squared distance of each corner: what most of the
/// time is spent on.
class ConvexCell {
 public:
  void begin(const Point2& low, const Point2& high) {
    grow(4);
    size_ = 4;
    corner_[0] = low;
    corner_[1] = {high.x, low.y};
    corner_[2] = high;
    corner_[3] = {low.x, high.y};
    for (std::size_t k = 0; k < size_; ++k) squared_[k] = squared_norm(corner_[k]);
  }

  double largest_squared_norm() const {
    double largest = 0.0;
    for (std::size_t k = 0; k < size_; ++k) largest = std::max(largest, squared_[k]);
    return largest;
  }

  /// As cut_any(), for offset > 0. Whether anything was cut off.
  bool cut(const Point2& normal, double offset) {
    std::size_t first = size_;  // outside, with the corner before it inside
    for (std::size_t k = 0, last = size_ - 1; k < size_; last = k++) {
      side_[k] = dot(corner_[k], normal) - offset;
      if (side_[k] > 0.0 && first == size_ && (k == 0 || side_[last] <= 0.0)) first = k;
    }
    if (first == size_) return false;
    if (first == 0) first = chain_begin();
    replace(first);
    return true;
  }

  std::size_t size() const { return size_; }
  const Point2& corner(std::size_t k) const { return corner_[k]; }

 private:
  std::size_t next(std::size_t k) const { return k + 1 < size_ ? k + 1 : 0; }
  std::size_t before(std::size_t k) const { return k > 0 ? k - 1 : size_ - 1; }

  /// Corner 0 is outside: where its chain begins. The origin is inside, so some corner is.
  std::size_t chain_begin() const {
    std::size_t k = 0;
    while (side_[before(k)] > 0.0 && before(k) != 0) k = before(k);
    return k;
  }

  Point2 crossing(std::size_t a, std::size_t b) const {
    const double share = side_[a] / (side_[a] - side_[b]);
    return corner_[a] + share * (corner_[b] - corner_[a]);
  }

  /// The chain of corners outside that begins at `first` by two on the line.
  void replace(std::size_t first) {
    std::size_t behind = first;
    while (side_[behind] > 0.0 && next(behind) != first) behind = next(behind);
    const Point2 enter = crossing(before(first), first);
    const Point2 exit = crossing(before(behind), behind);
    grow(size_ + 2);
    std::size_t n = 0;
    for (std::size_t k = behind; k != first; k = next(k), ++n) {
      new_corner_[n] = corner_[k];
      new_squared_[n] = squared_[k];
    }
    for (const Point2& p : {enter, exit}) {
      new_corner_[n] = p;
      new_squared_[n++] = squared_norm(p);
    }
    corner_.swap(new_corner_);
    squared_.swap(new_squared_);
    size_ = n;
  }

  void grow(std::size_t size) {
    if (size <= side_.size()) return;
    for (auto* points : {&corner_, &new_corner_}) points->resize(2 * size);
    for (auto* values : {&squared_, &new_squared_, &side_}) values->resize(2 * size);
  }

  std::size_t size_ = 0;
  std::vector<Point2> corner_, new_corner_;
  std::vector<double> squared_, new_squared_, side_;
};

/// Integral of the distance from the origin over the triangle of the origin, a and b, divided by
/// its area: by polar coordinates around the foot of the side's line.
double mean_distance(const Point2& a, const Point2& b, double twice_area) {
  const Point2 side = b - a;
  const double length = norm(side), r_a = norm(a), r_b = norm(b), least = std::min(r_a, r_b);
  // Of a side that little more than rounding has made, the foot would be anywhere.
  constexpr double too_short = 1e-5;
  if (length < too_short * least) return (r_a + r_b) / 3.0;
  const double h = std::min(std::abs(twice_area) / length, least);
  const double u_a = dot(a, side) / length, u_b = dot(b, side) / length;
  // asinh(u_b / h) - asinh(u_a / h), without subtracting what is alike.
  double stretch = 0.0;
  if (u_a >= 0.0)
    stretch = std::log((u_b + r_b) / (u_a + r_a));
  else if (u_b <= 0.0)
    stretch = std::log((r_a - u_a) / (r_b - u_b));
  else if (h > 0.0)
    stretch = std::log((u_b + r_b) / h * ((r_a - u_a) / h));
  return (u_b * r_b - u_a * r_a + h * h * stretch) / (3.0 * length);
}

/// Adds the triangle of the origin and a side, negative if it turns clockwise.
void add_triangle(const Point2& a, const Point2& b, CellIntegrals& sum) {
  const double twice_area = cross(a, b);
  if (twice_area == 0.0) return;
  sum.area += 0.5 * twice_area;
  sum.distance += 0.5 * twice_area * mean_distance(a, b, twice_area);
  sum.squared_distance += twice_area / 12.0 * (squared_norm(a) + dot(a, b) + squared_norm(b));
  sum.moment = sum.moment + (twice_area / 6.0) * (a + b);
}

CellIntegrals integrals_of(const Corners& corners) {
  CellIntegrals sum;
  for (std::size_t k = 0, last = corners.size() - 1; k < corners.size(); last = k++)
    add_triangle(corners[last], corners[k], sum);
  return sum;
}

/// Cuts cells one after the other, keeping its memory.
class CellCutter {
 public:
  CellCutter(const PointTree& tree, const Window& window) : tree_(tree), window_(window) {
    if (window.kind() != WindowKind::torus) return;
    const double w = window.bounding_box().width(), h = window.bounding_box().height();
    for (int ky = -1; ky <= 1; ++ky)
      for (int kx = -1; kx <= 1; ++kx)
        if (kx != 0 || ky != 0) images_.push_back({kx * w, ky * h});
  }

  /// Corners seen from the point; none if an earlier one is at the same place.
  const Corners& cell(std::size_t leaf, std::size_t place) {
    const Point2 site = tree_.point(place);
    begin_with_window(site);
    reach_ = 4.0 * cell_.largest_squared_norm();
    is_later_ = false;
    cutters_.clear();
    // In widening circles: as long as nothing lies on one side of the point, its cell has no end
    // there, and all points on the other side would be within reach.
    for (double limit = first_limit(leaf);; limit *= 4.0) {
      meet_within(limit, leaf, place, site);
      if (reach_ <= limit) break;
    }
    corners_.clear();
    if (is_later_) return corners_;
    for (std::size_t k = 0; k < cell_.size(); ++k) corners_.push_back(cell_.corner(k));
    if (window_.kind() == WindowKind::polygon) cut_polygon(site);
    return corners_;
  }

 private:
  void meet_within(double limit, std::size_t leaf, std::size_t place, const Point2& site) {
    const auto reach = [this, limit] { return std::min(reach_, limit); };
    tree_.visit_from(leaf, site, reach,
                     [&](std::size_t other) { meet(place, other, tree_.point(other) - site); });
    if (images_.empty() || is_far_from_border(site, std::sqrt(reach()))) return;
    for (const Point2& image : images_)
      tree_.visit_all(site - image, reach, [&](std::size_t other) {
        meet(place, other, tree_.point(other) - site + image);
      });
  }

  bool is_far_from_border(const Point2& site, double reach) const {
    const Rectangle& box = window_.bounding_box();
    return box.contains({site.x - reach, site.y - reach}) &&
           box.contains({site.x + reach, site.y + reach});
  }

  /// Square of about what a cell reaches among points as dense as in this leaf.
  double first_limit(std::size_t leaf) const {
    constexpr double spacings = 3.0;
    const Rectangle box = tree_.leaf_box(leaf);
    const auto count = static_cast<double>(tree_.leaf_end(leaf) - tree_.leaf_begin(leaf));
    const double spacing = std::max(std::sqrt(box.width() / count) * std::sqrt(box.height()),
                                    std::max(box.width(), box.height()) / count);
    constexpr double least =
        1e-6;  // of what the window allows: not even that if all are at one place
    return std::max(spacings * spacings * spacing * spacing, least * least * reach_);
  }

  void begin_with_window(const Point2& site) {
    const Rectangle& box = window_.bounding_box();
    Point2 low = box.low - site, high = box.high - site;
    if (window_.kind() == WindowKind::torus) {  // halfway to its own images
      high = {0.5 * box.width(), 0.5 * box.height()};
      low = -1.0 * high;
    }
    cell_.begin(low, high);
  }

  void meet(std::size_t place, std::size_t other, const Point2& offset) {
    if (other == place) return;
    if (offset == Point2{}) {
      is_later_ |= tree_.index(other) < tree_.index(place);
      return;
    }
    bisect(offset);
  }

  void bisect(const Point2& offset) {
    const double squared = squared_norm(offset);
    if (squared >= reach_) return;
    if (!cell_.cut(offset, 0.5 * squared)) return;
    reach_ = 4.0 * cell_.largest_squared_norm();
    if (window_.kind() == WindowKind::polygon) cutters_.push_back(offset);
  }

  /// The cell's part of a polygon: where a side of that runs through the cell, the polygon cut by
  /// all that has cut the cell. Not by the cell's sides: rounding makes some of no certain
  /// direction.
  void cut_polygon(const Point2& site) {
    Rectangle box{corners_[0], corners_[0]};
    for (const Point2& c : corners_) {
      box.low = {std::min(box.low.x, c.x), std::min(box.low.y, c.y)};
      box.high = {std::max(box.high.x, c.x), std::max(box.high.y, c.y)};
    }
    const Corners& polygon = window_.corners();
    bool is_inside = true;
    for (std::size_t k = 0, last = polygon.size() - 1; k < polygon.size() && is_inside;
         last = k++) {
      const Point2 a = polygon[last] - site, b = polygon[k] - site;
      is_inside = std::max(a.x, b.x) < box.low.x || std::min(a.x, b.x) > box.high.x ||
                  std::max(a.y, b.y) < box.low.y || std::min(a.y, b.y) > box.high.y;
    }
    if (is_inside) return;
    corners_.clear();
    for (const Point2& corner : polygon) corners_.push_back(corner - site);
    for (const Point2& offset : cutters_)
      if (!corners_.empty()) cut_any(corners_, offset, 0.5 * squared_norm(offset), scratch_);
  }

  const PointTree& tree_;
  const Window& window_;
  std::vector<Point2> images_;  ///< where the torus repeats itself
  ConvexCell cell_;
  Corners corners_, scratch_;
  std::vector<Point2> cutters_;  ///< points whose bisector has cut; of polygons only
  double reach_ = 0.0;           ///< squared; what is farther away cuts nothing
  bool is_later_ = false;
};

/// Calls use(index of point, corners seen from it) for every point.
template <class Use>
void for_cells(std::span<const Point2> points, const Window& window, int threads, const Use& use) {
  for (const Point2& p : points) PHYTOBENCH_EXPECT(window.bounding_box().contains(p));
  const PointTree tree(points);
  for_blocks(tree.leaves(), threads, [&](std::size_t begin, std::size_t end) {
    CellCutter cutter(tree, window);
    for (std::size_t leaf = begin; leaf < end; ++leaf)
      for (std::size_t place = tree.leaf_begin(leaf); place < tree.leaf_end(leaf); ++place)
        use(tree.index(place), cutter.cell(leaf, place));
  });
}

}  // namespace

std::vector<CellIntegrals> voronoi_integrals(std::span<const Point2> points, const Window& window,
                                             int threads) {
  std::vector<CellIntegrals> integrals(points.size());
  for_cells(points, window, threads, [&](std::size_t i, const Corners& corners) {
    if (!corners.empty()) integrals[i] = integrals_of(corners);
  });
  return integrals;
}

std::vector<std::vector<Point2>> voronoi_cells(std::span<const Point2> points,
                                               const Window& window) {
  std::vector<std::vector<Point2>> cells(points.size());
  for_cells(points, window, 1, [&](std::size_t i, const Corners& corners) {
    for (const Point2& corner : corners) cells[i].push_back(points[i] + corner);
  });
  return cells;
}

EmptySpaceMoments empty_space_moments(std::span<const Point2> points, const Window& window,
                                      int threads) {
  PHYTOBENCH_EXPECT(!points.empty());
  EmptySpaceMoments sum;
  for (const CellIntegrals& cell : voronoi_integrals(points, window, threads)) {
    sum.mean_distance += cell.distance;
    sum.mean_squared_distance += cell.squared_distance;
  }
  return {sum.mean_distance / window.area(), sum.mean_squared_distance / window.area()};
}

}  // namespace phytobench
