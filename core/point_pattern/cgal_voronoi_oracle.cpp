// SPDX-License-Identifier: MIT
// CGAL's triangulations are GPL: so is a test program that contains this file.
#include "core/point_pattern/cgal_voronoi_oracle.hpp"

#include <CGAL/Delaunay_triangulation_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_data_structure_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

namespace phytobench::cgal_oracle {

namespace {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using Vertex = CGAL::Triangulation_vertex_base_with_info_2<std::size_t, Kernel>;
using Delaunay =
    CGAL::Delaunay_triangulation_2<Kernel, CGAL::Triangulation_data_structure_2<Vertex>>;

}  // namespace

std::vector<std::vector<Point2>> voronoi_cells(std::span<const Point2> points, std::size_t count) {
  std::vector<std::pair<Kernel::Point_2, std::size_t>> numbered;
  for (std::size_t i = 0; i < points.size(); ++i)
    numbered.emplace_back(Kernel::Point_2(points[i].x, points[i].y), i);
  const Delaunay triangulation(numbered.begin(), numbered.end());
  std::vector<std::vector<Point2>> cells(count);
  for (auto v = triangulation.finite_vertices_begin(); v != triangulation.finite_vertices_end();
       ++v) {
    if (v->info() >= count) continue;
    auto face = triangulation.incident_faces(v);
    const auto first = face;
    do {
      const Kernel::Point_2 corner = triangulation.dual(face);
      cells[v->info()].push_back({corner.x(), corner.y()});
    } while (++face != first);
  }
  return cells;
}

}  // namespace phytobench::cgal_oracle
