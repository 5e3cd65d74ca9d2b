// SPDX-License-Identifier: MIT
// From what a turtle drew to the meshes, exports and pictures of `grow`.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/lsystem/drawing.hpp"
#include "core/picture/image.hpp"
#include "core/tree/scene_object.hpp"
#include "core/tree/triangle_mesh.hpp"

namespace phytobench {

/// Where the radii of branches come from.
enum class BranchRadii {
  automatic,   ///< widths if one was said or they differ anywhere, else the pipe model
  widths,      ///< half the turtle's widths
  pipe_model,  ///< by the number of tips above ([Liebemann2017] eq. 3.4)
};

struct DrawingPlantOptions {
  BranchRadii radii = BranchRadii::automatic;
  double radius_exponent = 2.0;  ///< of the pipe model, > 0
  double tip_radius = 0.0;       ///< of the pipe model, length units; 0: suits the drawing
  /// Length units of a unit of width; 0: 1, or less if branches were thick then and no number gives
  /// a width (WidthSource::given).
  double length_of_width = 0.0;
  int circle_resolution = 6;         ///< corners of a branch's ring, >= 3
  std::vector<std::string> colours;  ///< "#rrggbb" of colour 0, 1, ..., again from the first after
                                     ///< the last; empty: the two below
  Colour bark_colour = parse_colour("#6b4a2b");
  Colour leaf_colour = parse_colour("#457d29");
};

/// Tubes for the segments and leaves for the polygons, with the colour of each triangle.
struct DrawingPlant {
  TriangleMesh branches;
  std::vector<std::uint16_t> branch_colours;
  TriangleMesh leaves;  ///< both sides of each polygon, in the order of the polygons
  std::vector<std::uint16_t> leaf_colours;
  double root_radius = 0.0;
};

/// Radius of every node of a tree.
std::vector<double> drawing_radii(const TurtleTree& tree, const DrawingPlantOptions& options);

/// Of a tree, with the polygons of `drawing`, which is of the same word. Throws InputError if a
/// mesh would be too large (4 million segments, a polygon of more than most_outline_corners).
DrawingPlant make_drawing_plant(const TurtleTree& tree, const Drawing& drawing,
                                const DrawingPlantOptions& options);

/// Of a drawing that is no tree: each of its lines is a tube.
DrawingPlant make_drawing_plant(const Drawing& drawing, const DrawingPlantOptions& options);

/// The first if the word draws a tree, else the second.
DrawingPlant make_drawing_plant(const LSystem& system, const Word& word,
                                const DrawingPlantOptions& options);

/// "bark" and "leaves"; if colours are given, "bark-c0", "leaves-c1", ... for each colour that
/// occurs. What is not there is no object. Throws InputError for a colour that is none.
std::vector<SceneObject> scene_objects(DrawingPlant plant, const DrawingPlantOptions& options);

}  // namespace phytobench
