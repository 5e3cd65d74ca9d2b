// SPDX-License-Identifier: MIT
// A second judge, for clouds too large for the literal oracle: it is told what grows and what
// kills, iteration by iteration, and answers what [Brzoska2019] sec. 3.4.4 makes of it. It grows
// nothing itself and keeps only the present answer. Shares no code with core/.
#pragma once

#include <array>
#include <cstddef>
#include <vector>

#include "reference/oracles/brzoska2019_equations.hpp"

namespace phytobench::oracles::brzoska2019 {

/// Points that never move, sorted by the cells of a uniform grid over their bounding box.
class PointGrid {
 public:
  struct Entry {
    Point position;
    int point;  ///< index in the cloud
  };

  /// No cell is narrower than the distance, and there are no more cells than points (or one).
  PointGrid(const std::vector<Point>& points, double distance);

  /// Calls visit(entry) once for every point p with !(equation_24(p, centre) > d * d), and for
  /// others near by: the caller compares distances itself.
  template <class Visit>
  void visit_around(Point centre, double d, Visit visit) const {
    const Range x = cells_around(0, centre.x, centre, d);
    const Range y = cells_around(1, centre.y, centre, d);
    const Range z = cells_around(2, centre.z, centre, d);
    for (std::size_t i = x.first; i <= x.last; ++i)
      for (std::size_t j = y.first; j <= y.last; ++j) {
        // Cells that differ only in z follow each other.
        const std::size_t row = (i * axes_[1].cells + j) * axes_[2].cells;
        for (std::size_t e = begin_[row + z.first]; e < begin_[row + z.last + 1]; ++e)
          visit(entries_[e]);
      }
  }

  std::size_t cells() const { return begin_.size() - 1; }

 private:
  struct Axis {
    double low = 0;
    std::size_t cells = 1;
  };
  struct Range {
    std::size_t first, last;
  };

  void choose_cells(const std::vector<Point>& points, double distance);
  std::size_t cell_along(std::size_t axis, double coordinate) const;
  std::size_t cell_of(Point p) const;
  Range cells_around(std::size_t axis, double coordinate, Point centre, double d) const;

  std::array<Axis, 3> axes_;
  double edge_ = 1;
  std::vector<std::size_t> begin_;  // per cell its first entry, and the end
  std::vector<Entry> entries_;
};

class GridJudge {
 public:
  /// `theta_rad` is the full perception angle. A search that asks for the angle only afterwards
  /// (Departures::cone_after_search) is judged with a full angle of 2 pi.
  GridJudge(std::vector<Point> attraction_points, double d_i, double theta_rad);

  /// Adds nodes with their directions (unit vectors), then gives per point the nearest of all nodes
  /// so far that perceives it: the lowest index on ties, -1 if there is none or the point is
  /// removed. Valid until the next call of associate() or remove(). Throws std::invalid_argument
  /// where nodes and directions differ in number.
  const std::vector<int>& associate(const std::vector<Point>& new_nodes,
                                    const std::vector<Point>& directions);

  /// Removes the points within d_c (at most, in squares) of one of the killers; returns them
  /// ascending.
  std::vector<int> remove(const std::vector<Point>& killers, double d_c);

  /// What associate() must have given for one point: a plain loop over all nodes so far, no grid.
  int recompute(std::size_t point) const;

  const std::vector<Point>& attraction_points() const { return points_; }
  const std::vector<Point>& nodes() const { return nodes_; }
  const std::vector<Point>& directions() const { return directions_; }
  std::size_t live_points() const { return live_points_; }

 private:
  bool perceives(std::size_t v, Point p, double distance) const;
  void offer(std::size_t v, const PointGrid::Entry& entry);

  std::vector<Point> points_;
  double d_i_;
  double theta_rad_;
  double cos_half_theta_;
  PointGrid grid_;
  std::size_t live_points_;
  std::vector<Point> nodes_;
  std::vector<Point> directions_;
  std::vector<char> removed_;     // per point
  std::vector<int> nearest_;      // per point, the answer so far
  std::vector<double> shortest_;  // per point, the squared distance of that node
};

}  // namespace phytobench::oracles::brzoska2019
