// SPDX-License-Identifier: MIT
// The thesis' requirements FAO01 to FAO15 and FAF1 to FAF6, as far as a program can check them:
// what a user turns must change the plant as it says, and nothing else.
#include <algorithm>
#include <cmath>
#include <numbers>
#include <sstream>

#include <fmt/format.h>

#include "core/geometry/bounding_box.hpp"
#include "core/tree/branches.hpp"
#include "core/tree/habit.hpp"
#include "core/tree/obj_export.hpp"
#include "core/tree/scene_object.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

double height_per_width(const BoundingBox& box) {
  const Vector3 extent = box.extent();
  return extent.y / std::max(extent.x, extent.z);
}

/// FAO02, FAO03: crowns wide, tall and with a trunk.
void record_habit(ExperimentContext& context) {
  for (const char* row : {"figure-40-left", "figure-41-left", "figure-42-left"}) {
    const TreeParameters parameters = thesis_tree(row);
    const Seedling seedling = make_seedling(parameters);
    const Skeleton tree = grow_thesis_tree(parameters, context.threads());
    BoundingBox crown, cloud;
    for (std::size_t i = static_cast<std::size_t>(seedling.crown_root); i < tree.node_count(); ++i)
      crown.extend(tree.positions()[i]);
    for (const Vector3& point : seedling.attraction_points) cloud.extend(point);
    const double middle = 0.5 * (crown.low().y + crown.high().y);
    const std::vector<double> radii =
        branch_radii(tree, parameters.plant.tip_radius, parameters.plant.radius_exponent);
    const std::string name = std::string("habit/") + row;
    context.record(name + "/trunk_share", trunk_share(tree, radii, middle));
    context.record(name + "/crown_height_per_width", height_per_width(crown));
    context.record(name + "/cloud_height_per_width", height_per_width(cloud));
  }
}

/// Mean of what can be seen of a picture.
Colour mean_colour(const Image& image) {
  double sum[3] = {}, weight = 0.0;
  for (const Pixel& pixel : image.pixels()) {
    const double opacity = pixel[3];
    for (std::size_t i = 0; i < 3; ++i) sum[i] += opacity * pixel[i] / 255.0;
    weight += opacity;
  }
  return {sum[0] / weight, sum[1] / weight, sum[2] / weight};
}

double distance(const Colour& a, const Colour& b) {
  return norm(Vector3{a.red - b.red, a.green - b.green, a.blue - b.blue});
}

/// FAO05, FAO06: of several colours, an exported texture must be nearest to the one asked for.
void record_colours(ExperimentContext& context) {
  const std::vector<Colour> colours = {parse_colour("#6b4a2b"), parse_colour("#d8d2c4"),
                                       parse_colour("#3a4a2a"), parse_colour("#b03020")};
  const TreeParameters parameters = thesis_tree("figure-44-right");
  const Plant plant = make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
  std::int64_t right[2] = {0, 0};
  for (const Colour& asked : colours) {
    PlantParameters look = parameters.plant;
    look.bark_colour = look.leaf_colour = asked;
    const std::vector<SceneObject> objects = scene_objects(plant, look);
    for (std::size_t i = 0; i < objects.size(); ++i) {
      const Colour seen = mean_colour(parse_png(objects[i].texture_png, objects[i].name));
      right[i] +=
          *std::min_element(colours.begin(), colours.end(), [&](const Colour& a, const Colour& b) {
            return distance(a, seen) < distance(b, seen);
          }) == asked;
    }
  }
  context.record("colours/tried", whole(colours.size()));
  context.record("colours/bark_as_asked", right[0]);
  context.record("colours/leaves_as_asked", right[1]);
}

/// FAO06: figure 44's bush with more and more leaves.
void record_leaf_numbers(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-44-right");
  const Skeleton tree = grow_thesis_tree(parameters, context.threads());
  for (const int percent : {0, 30, 60, 100, 150, 200}) {
    PlantParameters look = parameters.plant;
    look.leaves.per_node = percent / 100.0;
    const Plant plant = make_plant(tree, look);
    context.record({.experiment = {},
                    .measurement = fmt::format("leaves/{:03}-percent", percent),
                    .value = whole(plant.leaves.size()),
                    .seed = look.leaves.seed});
  }
}

/// FAO07: the same tree, older and older.
void record_age(ExperimentContext& context) {
  TreeParameters parameters = thesis_tree("figure-40-left");
  for (const int iterations : {5, 10, 15, 20, 25, 30}) {
    parameters.iterations = iterations;
    context.record(fmt::format("age/{:02}-iterations", iterations),
                   whole(grow_thesis_tree(parameters, context.threads()).edge_count()));
  }
}

/// FAO08: what a user sees who sets nothing.
void record_start(ExperimentContext& context) {
  const TreeParameters parameters;
  const Plant plant = make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
  context.record("start/edges", whole(plant.skeleton.edge_count()));
  context.record("start/leaves", whole(plant.leaves.size()));
}

/// FAO09: other seeds, then the first again, which must find everything else as it was.
void record_seeds(ExperimentContext& context) {
  TreeParameters parameters = thesis_tree("figure-46-left");
  const std::uint64_t first = parameters.seed;
  for (const auto& [name, seed] : {std::pair{"first", first}, std::pair{"second", first + 1},
                                   std::pair{"third", first + 2}, std::pair{"again", first}}) {
    parameters.seed = seed;
    context.record({.experiment = {},
                    .measurement = std::string("seeds/") + name,
                    .value = tree_hash(grow_thesis_tree(parameters, context.threads())),
                    .seed = seed});
  }
}

/// FAO11: what an export holds, read back word by word.
struct ObjCounts {
  std::int64_t vertices = 0, normals = 0, texture_points = 0, faces = 0, bad_corners = 0;
  double largest_error = 0.0;  ///< of a coordinate, over the size of the plant
};

ObjCounts read_obj(const std::string& text, const std::vector<Vector3>& expected, double size) {
  ObjCounts counts;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    std::istringstream words(line);
    std::string kind;
    words >> kind;
    if (kind == "v") {
      Vector3 p;
      words >> p.x >> p.y >> p.z;
      if (const auto i = static_cast<std::size_t>(counts.vertices++); i < expected.size())
        counts.largest_error = std::max(counts.largest_error, norm(p - expected[i]) / size);
    }
    counts.normals += kind == "vn";
    counts.texture_points += kind == "vt";
    if (kind != "f") continue;
    ++counts.faces;
    for (std::string corner; words >> corner;) {
      const std::int64_t vertex = std::stoll(corner);
      counts.bad_corners += vertex < 1 || vertex > counts.vertices;
    }
  }
  return counts;
}

void record_export(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-44-right");
  Plant plant = make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
  std::vector<Vector3> positions(plant.branches.mesh.positions.begin(),
                                 plant.branches.mesh.positions.end());
  positions.insert(positions.end(), plant.leaf_mesh.positions.begin(),
                   plant.leaf_mesh.positions.end());
  context.record("export/plant_vertices", whole(plant.vertex_count()));
  context.record("export/plant_triangles", whole(plant.triangle_count()));
  const std::vector<SceneObject> objects = scene_objects(std::move(plant), parameters.plant);
  const double size = norm(box_of(objects).extent());
  const std::vector<FileContent> files = to_obj(objects, "bush.obj");
  const auto model = std::find_if(files.begin(), files.end(), [](const FileContent& file) {
    return file.file.extension() == ".obj";
  });
  const ObjCounts counts = read_obj(model->content, positions, size);
  context.record("export/vertices", counts.vertices);
  context.record("export/normals", counts.normals);
  context.record("export/texture_points", counts.texture_points);
  context.record("export/triangles", counts.faces);
  context.record("export/corners_without_vertex", counts.bad_corners);
  context.record("export/largest_error", counts.largest_error);
  std::int64_t textures = 0, named = 0;
  for (const FileContent& file : files) {
    if (file.file.extension() != ".png") continue;
    textures += parse_png(file.content, file.file.string()).width() > 0;
    for (const FileContent& other : files)
      named += other.file.extension() == ".mtl" &&
               other.content.find("map_Kd " + file.file.filename().string()) != std::string::npos;
  }
  context.record("export/textures", textures);
  context.record("export/textures_named", named);
}

/// FAO13: stems below the crowns.
void record_stems(ExperimentContext& context) {
  for (const char* row : {"figure-40-left", "figure-44-left"}) {
    const Seedling seedling = make_seedling(thesis_tree(row));
    context.record(std::string("stem/") + row + "/length",
                   seedling.skeleton.position(seedling.crown_root).y, "length");
    context.record(std::string("stem/") + row + "/edges",
                   static_cast<std::int64_t>(seedling.crown_root));
  }
}

/// FAO15: figure 40's tree with rings of three and of six corners.
void record_resolution(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-40-left");
  const Skeleton tree = grow_thesis_tree(parameters, context.threads());
  for (const int corners : {3, 6}) {
    PlantParameters look = parameters.plant;
    look.branches.circle_resolution = corners;
    const Plant plant = make_plant(tree, look);
    const std::string name = fmt::format("resolution/{}-corners", corners);
    context.record(name + "/vertices", whole(plant.branches.mesh.vertex_count()));
    context.record(name + "/triangles", whole(plant.branches.mesh.triangle_count()));
  }
}

double mean_turn_deg(const Skeleton& tree) {
  double sum = 0.0;
  std::size_t turns = 0;
  for (std::size_t node = 1; node < tree.node_count(); ++node) {
    const std::int32_t parent = tree.parents()[node];
    if (parent == 0) continue;
    const Vector3 below =
        tree.position(parent) - tree.position(tree.parents()[static_cast<std::size_t>(parent)]);
    const Vector3 edge = tree.positions()[node] - tree.position(parent);
    sum += std::atan2(norm(cross(below, edge)), dot(below, edge));
    ++turns;
  }
  return turns > 0 ? sum / static_cast<double>(turns) * 180.0 / std::numbers::pi : 0.0;
}

/// FAF2: figure 47's trees, straight and gnarled, with ten seeds each.
void record_curvature(ExperimentContext& context) {
  for (std::uint64_t seed = 0; seed < 10; ++seed) {
    for (const char* row : {"figure-47-left", "figure-47-right"}) {
      TreeParameters parameters = thesis_tree(row);
      parameters.seed = seed;
      context.record({.experiment = {},
                      .measurement = fmt::format("curvature/{}/{}/mean_turn", row, seed),
                      .value = mean_turn_deg(grow_thesis_tree(parameters, context.threads())),
                      .unit = "degrees",
                      .seed = seed});
    }
  }
}

void run(ExperimentContext& context) {
  record_habit(context);
  record_colours(context);
  record_leaf_numbers(context);
  record_age(context);
  record_start(context);
  record_seeds(context);
  record_export(context);
  record_stems(context);
  record_resolution(context);
  record_curvature(context);
}

}  // namespace

extern const ExperimentDescriptor requirements;
constinit const ExperimentDescriptor requirements{
    .id = "brzoska2019/requirements",
    .question = "Does what a user can set change the plant as the thesis' requirements ask?",
    .source = "[Brzoska2019] sec. 3.3, 6.1",
    .seconds = {2, 2, 2},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
