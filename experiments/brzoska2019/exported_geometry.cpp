// SPDX-License-Identifier: MIT
// Whether an OBJ file says what the meshes it was written from say, read back by a reader that had
// no part in writing it; and how many triangles show the cloud.
#include <algorithm>
#include <charconv>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "core/tree/obj_export.hpp"
#include "core/tree/point_cloud_mesh.hpp"
#include "experiments/brzoska2019/thesis_tree.hpp"
#include "experiments/experiment.hpp"

namespace phytobench::experiments::brzoska2019 {

namespace {

/// The words of a line.
std::vector<std::string_view> words_of(std::string_view line) {
  std::vector<std::string_view> words;
  for (std::size_t begin = 0; begin < line.size();) {
    const std::size_t end = std::min(line.find(' ', begin), line.size());
    if (end > begin) words.push_back(line.substr(begin, end - begin));
    begin = end + 1;
  }
  return words;
}

double number_in(std::string_view word) {
  double number = std::numeric_limits<double>::quiet_NaN();
  std::from_chars(word.data(), word.data() + word.size(), number);
  return number;
}

/// Numbers of vertex, texture point and normal of a corner, "7/7/7".
std::array<std::int64_t, 3> corner_in(std::string_view word) {
  std::array<std::int64_t, 3> numbers{};
  for (std::int64_t& number : numbers) {
    const std::size_t slash = std::min(word.find('/'), word.size());
    std::from_chars(word.data(), word.data() + slash, number);
    word.remove_prefix(std::min(slash + 1, word.size()));
  }
  return numbers;
}

/// What an OBJ file holds: rows of numbers by keyword, and corners of triangles.
struct ObjContent {
  std::map<std::string, std::vector<std::vector<double>>, std::less<>> rows;
  std::vector<std::array<std::int64_t, 3>> corners;
  std::set<std::string> material_files, materials;
};

ObjContent read_obj(std::string_view text) {
  ObjContent content;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    const std::vector<std::string_view> words = words_of(text.substr(begin, end - begin));
    begin = end + 1;
    if (words.empty()) continue;
    if (words[0] == "mtllib") content.material_files.emplace(words.at(1));
    if (words[0] == "usemtl") content.materials.emplace(words.at(1));
    if (words[0] == "f")
      for (std::size_t i = 1; i < words.size(); ++i) content.corners.push_back(corner_in(words[i]));
    if (words[0] == "v" || words[0] == "vt" || words[0] == "vn") {
      std::vector<double> row;
      for (std::size_t i = 1; i < words.size(); ++i) row.push_back(number_in(words[i]));
      content.rows[std::string(words[0])].push_back(std::move(row));
    }
  }
  return content;
}

/// Largest difference between the rows of the file and what was meshed.
double largest_error(const std::vector<std::vector<double>>& rows,
                     const std::vector<std::vector<double>>& expected) {
  if (rows.size() != expected.size()) return std::numeric_limits<double>::max();
  double error = 0.0;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    if (rows[i].size() != expected[i].size()) return std::numeric_limits<double>::max();
    for (std::size_t j = 0; j < rows[i].size(); ++j) {
      const double difference = std::abs(rows[i][j] - expected[i][j]);
      error =
          std::isnan(difference) ? std::numeric_limits<double>::max() : std::max(error, difference);
    }
  }
  return error;
}

/// The same rows as they should be, over all meshes.
ObjContent expected_content(const std::vector<SceneObject>& objects) {
  ObjContent content;
  std::int64_t first = 1;
  for (const auto& [name, material, mesh, png, transparent] : objects) {
    for (const Vector3& p : mesh.positions) content.rows["v"].push_back({p.x, p.y, p.z});
    for (const TexturePoint& t : mesh.texture_points) content.rows["vt"].push_back({t.u, t.v});
    for (const Vector3& n : mesh.normals) content.rows["vn"].push_back({n.x, n.y, n.z});
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t vertex : triangle) {
        const std::int64_t number = first + std::int64_t{vertex};
        content.corners.push_back({number, number, number});
      }
    first += whole(mesh.vertex_count());
  }
  return content;
}

/// Textures that the material file names and that are among the files as PNG.
std::int64_t textures_present(const std::vector<FileContent>& files) {
  std::set<std::string> named;
  for (const FileContent& file : files) {
    if (file.file.extension() != ".mtl") continue;
    std::size_t begin = 0;
    while ((begin = file.content.find("map_Kd ", begin)) != std::string::npos) {
      begin += 7;
      named.insert(file.content.substr(begin, file.content.find('\n', begin) - begin));
    }
  }
  return std::count_if(files.begin(), files.end(), [&](const FileContent& file) {
    return named.contains(file.file.filename().string()) &&
           file.content.starts_with("\x89PNG\r\n\x1a\n");
  });
}

void record_obj(ExperimentContext& context) {
  const TreeParameters parameters = thesis_tree("figure-40-right");
  const Plant plant = make_plant(grow_thesis_tree(parameters, context.threads()), parameters.plant);
  context.record("plant/vertices", whole(plant.vertex_count()));
  context.record("plant/triangles", whole(plant.triangle_count()));
  const std::vector<SceneObject> objects = scene_objects(plant, parameters.plant);
  const std::vector<FileContent> files = to_obj(objects, "plant.obj");
  const ObjContent read = read_obj(files.back().content);
  const ObjContent expected = expected_content(objects);
  context.record("obj/vertices", whole(read.rows.at("v").size()));
  context.record("obj/normals", whole(read.rows.at("vn").size()));
  context.record("obj/texture_points", whole(read.rows.at("vt").size()));
  context.record("obj/triangles", whole(read.corners.size() / 3));
  for (const auto& [keyword, name] : std::map<std::string, std::string>{
           {"v", "position"}, {"vn", "normal"}, {"vt", "texture_point"}})
    context.record("obj/max_" + name + "_error",
                   largest_error(read.rows.at(keyword), expected.rows.at(keyword)));
  context.record("obj/same_corners", std::int64_t{read.corners == expected.corners});
  context.record("obj/first_number", (*std::ranges::min_element(read.corners))[0]);
  context.record("obj/last_number", (*std::ranges::max_element(read.corners))[0]);
  context.record("obj/materials", whole(read.materials.size()));
  context.record("obj/textures", textures_present(files));
}

/// Sec. 5.4: what shows the attraction points of figure 51.
void record_cloud(ExperimentContext& context) {
  const std::vector<Vector3> points = make_seedling(thesis_tree("figure-51")).attraction_points;
  const TriangleMesh mesh = mesh_points(points, 0.05);
  double off_center = 0.0;
  for (std::size_t i = 0; i < mesh.triangle_count(); ++i) {
    Vector3 sum;
    for (const std::uint32_t corner : mesh.triangles[i]) sum = sum + mesh.positions[corner];
    off_center = std::max(off_center, norm(sum / 3.0 - points[i]));
  }
  context.record("cloud/points", whole(points.size()));
  context.record("cloud/vertices", whole(mesh.vertex_count()));
  context.record("cloud/triangles", whole(mesh.triangle_count()));
  context.record("cloud/max_off_center", off_center, "length");
}

void run(ExperimentContext& context) {
  record_obj(context);
  record_cloud(context);
}

}  // namespace

extern const ExperimentDescriptor exported_geometry;
constinit const ExperimentDescriptor exported_geometry{
    .id = "brzoska2019/exported-geometry",
    .question =
        "Does an OBJ file hold the plant it was written from, and how many triangles show "
        "the cloud?",
    .source = "[Brzoska2019] sec. 5.4, 5.5.4",
    .seconds = {1, 1, 1},
    .run = run,
};

}  // namespace phytobench::experiments::brzoska2019
