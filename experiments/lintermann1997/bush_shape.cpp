// SPDX-License-Identifier: MIT
// Figure 1: what the bush looks like with the slashes of the book and with those of the article,
// and with the turtle of table 1.
#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "core/lsystem/drawing_measures.hpp"
#include "core/lsystem/drawing_plant.hpp"
#include "core/lsystem/drawing_svg.hpp"
#include "core/picture/camera.hpp"
#include "core/picture/render.hpp"
#include "experiments/experiment.hpp"
#include "experiments/lintermann1997/bush.hpp"
#include "reference/oracles/lintermann1997_placement.hpp"
#include "reference/oracles/turtle_3d.hpp"

namespace phytobench::experiments::lintermann1997 {

namespace {

constexpr int steps = 5;
constexpr double azimuth_deg = 20.0;  // nearly across the plane in which one of the two lies
constexpr double same_place = 1e-9;   // in steps of the turtle
constexpr const char* settings =
    "turtle: words  start: upwards  width: 0.2  width_factor: 0.7  colours: #6b4a2b #457d29";

/// Between the ends of lines here and of those that a literal turtle draws.
double largest_difference_from_literal_turtle(const Drawing& drawing, const BushPrint& print) {
  oracles::TurtleDefaults defaults;
  defaults.angle_deg = 22.5;
  const auto literal = oracles::turtle_3d(
      oracles::modules_of(derive_in_parallel(oracles::lintermann1997::bush(print), steps)),
      defaults, oracles::start_upwards);
  double largest = 0.0;
  for (std::size_t i = 0; i < drawing.segments.size(); ++i) {
    const oracles::SpacePoint to = literal.segments.at(i).to;
    largest = std::max(largest, norm(drawing.segments[i].to - Vector3{to.x, to.y, to.z}));
  }
  return largest;
}

/// Leaves differ in where they are only.
double largest_difference_of_leaf_areas(const Drawing& drawing) {
  const double area = oracles::lintermann1997::leaf_area(22.5);
  double largest = 0.0;
  for (const TurtlePolygon& leaf : drawing.polygons)
    largest = std::max(largest, std::abs(norm(vector_area(corners_of(drawing, leaf))) - area));
  return largest;
}

void draw_pictures(ExperimentContext& context, const LSystem& system, const Word& word,
                   const std::string& figure) {
  DrawingSvgOptions side;
  side.azimuth_deg = azimuth_deg;
  side.elevation_deg = 10.0;
  side.colours = system.turtle.colours;
  context.artifact(figure + ".svg", drawing_svg(draw(system, word), "Figure 1", side));
  if (context.tier() == Tier::smoke || !can_render()) return;
  constexpr int width = 360, height = 450;
  DrawingPlantOptions options;
  const std::vector<SceneObject> objects =
      scene_objects(make_drawing_plant(system, word, options), options);
  Camera camera;
  camera.azimuth_deg = azimuth_deg;
  camera = fitted(camera, box_of(objects), static_cast<double>(width) / height);
  RenderOptions picture;
  picture.width = width;
  picture.height = height;
  picture.samples = 2;
  picture.threads = context.untimed_threads();
  context.artifact(figure + ".jpg", to_jpeg(render(objects, camera, picture)));
}

void measure(ExperimentContext& context, const BushPrint& print, const std::string& name,
             const std::string& figure) {
  const LSystem system = bush_system(print, settings);
  const Word word = derived(system, steps);
  const Drawing drawing = draw(system, word);
  const TurtleTree tree = turtle_tree(system, word);
  const std::vector<Vector3> tips = tip_positions(tree.skeleton);
  context.record(name + "/segments", static_cast<std::int64_t>(drawing.segments.size()));
  context.record(name + "/leaves", static_cast<std::int64_t>(drawing.polygons.size()));
  context.record(name + "/distinct_segments",
                 static_cast<std::int64_t>(distinct_parts(drawing, same_place).segments));
  context.record(name + "/most_often_drawn",
                 static_cast<std::int64_t>(distinct_parts(drawing, same_place).most_often));
  context.record(name + "/tips", static_cast<std::int64_t>(tips.size()));
  context.record(name + "/distinct_tips",
                 static_cast<std::int64_t>(distinct_point_count(tips, same_place)));
  // x is across the first heading, y along it, z the third direction.
  context.record(name + "/segments/extent_across", segment_box(drawing).extent().x);
  context.record(name + "/segments/extent_third", segment_box(drawing).extent().z);
  context.record(name + "/leaves/extent_across", polygon_box(drawing).extent().x);
  context.record(name + "/largest_difference_from_literal_turtle",
                 largest_difference_from_literal_turtle(drawing, print));
  context.record(name + "/largest_difference_of_leaf_areas",
                 largest_difference_of_leaf_areas(drawing));
  draw_pictures(context, system, word, figure);
}

/// The leaf of p4 alone, in the plane.
void measure_leaf(ExperimentContext& context) {
  const LSystem system = parse_lsystem("axiom: {-f+f+f-|-f+f+f}\nangle: 22.5\n", "leaf");
  const Drawing drawing = draw(system, derived(system, 0));
  const std::span<const Vector3> corners = corners_of(drawing, drawing.polygons.at(0));
  context.record("leaf/moves", static_cast<std::int64_t>(corners.size()) - 1);
  context.record("leaf/corners", static_cast<std::int64_t>(distinct_point_count(
                                     {corners.data(), corners.size()}, same_place)));
  context.record("leaf/gap", norm(corners.back() - corners.front()));
  context.record("leaf/area", norm(vector_area(corners)));
  context.record("leaf/extent_along", polygon_box(drawing).extent().y);
  context.record("leaf/extent_across", polygon_box(drawing).extent().x);
  // A half turn about left instead of up: | read as turning over.
  const LSystem over = parse_lsystem("axiom: {-f+f+f-&(180)-f+f+f}\nangle: 22.5\n", "leaf");
  const Drawing turned_over = draw(over, derived(over, 0));
  context.record("leaf/area_if_turned_over",
                 norm(vector_area(corners_of(turned_over, turned_over.polygons.at(0)))));
  context.record("leaf/drawn_lines", static_cast<std::int64_t>(drawing.segments.size()));
}

/// The bush by the table and by the book's words: mirror images in the plane of heading and up.
void record_mirror_image(ExperimentContext& context) {
  const auto tips = [](const char* turtle) {
    const LSystem system = bush_system(bush_of_the_book(), turtle);
    return tip_positions(turtle_tree(system, derived(system, 5)).skeleton);
  };
  const std::vector<Vector3> table = tips("turtle: cpfg"), words = tips("turtle: words");
  double as_they_are = 0.0, mirrored = 0.0;
  for (std::size_t i = 0; i < table.size(); ++i) {
    const Vector3 image{-words[i].x, words[i].y, words[i].z};
    as_they_are = std::max(as_they_are, norm(table[i] - words[i]));
    mirrored = std::max(mirrored, norm(table[i] - image));
  }
  context.record("turtle_of_table_1/farthest_from_that_of_the_words", as_they_are);
  context.record("turtle_of_table_1/farthest_from_its_mirror_image", mirrored);
}

void run(ExperimentContext& context) {
  measure_leaf(context);
  measure(context, bush_of_the_book(), "slashes-5-7-5", "figure-1");
  measure(context, bush_as_printed(), "slashes-8-8-8", "figure-1-as-printed");
  record_mirror_image(context);
}

}  // namespace

extern const ExperimentDescriptor bush_shape;
constinit const ExperimentDescriptor bush_shape{
    .id = "lintermann1997/bush-shape",
    .question = "Is the bush a bush, or does it lie in a plane?",
    .source = "[Lintermann1997] sec. 2.1, fig. 1",
    .seconds = {0.1, 2, 2},
    .run = run,
};

}  // namespace phytobench::experiments::lintermann1997
