// SPDX-License-Identifier: MIT
#include "core/tree/obj_export.hpp"

#include <charconv>
#include <set>

#include <fmt/format.h>

namespace phytobench {

namespace {

/// Text that numbers are appended to, fast: an OBJ file is nothing but numbers.
class NumberText {
 public:
  void line(std::string_view text) {
    text_ += text;
    text_ += '\n';
  }
  void numbers(std::string_view keyword, std::initializer_list<double> values) {
    text_ += keyword;
    for (const double value : values) {
      text_ += ' ';
      put(static_cast<float>(value));
    }
    text_ += '\n';
  }
  /// A corner's vertex, texture point and normal have one number.
  void face(const Triangle& triangle, std::uint64_t first) {
    text_ += 'f';
    for (const std::uint32_t vertex : triangle) {
      char digits[24];
      const auto end = std::to_chars(digits, digits + sizeof digits, first + vertex).ptr;
      const std::string_view number(digits, static_cast<std::size_t>(end - digits));
      text_ += ' ';
      text_ += number;
      text_ += '/';
      text_ += number;
      text_ += '/';
      text_ += number;
    }
    text_ += '\n';
  }
  std::string take() { return std::move(text_); }

 private:
  void put(float value) {
    char digits[32];
    // 0 instead of -0: the sign means nothing here.
    const auto end =
        std::to_chars(digits, digits + sizeof digits, value == 0.0f ? 0.0f : value).ptr;
    text_.append(digits, end);
  }

  std::string text_;
};

void put_object(const SceneObject& object, std::uint64_t first, NumberText& text) {
  const TriangleMesh& mesh = object.mesh;
  text.line("o " + object.name);
  text.line("usemtl " + object.material);
  for (const Vector3& p : mesh.positions) text.numbers("v", {p.x, p.y, p.z});
  for (const TexturePoint& t : mesh.texture_points) text.numbers("vt", {t.u, t.v});
  for (const Vector3& n : mesh.normals) text.numbers("vn", {n.x, n.y, n.z});
  for (const Triangle& triangle : mesh.triangles) text.face(triangle, first);
}

std::filesystem::path beside(const std::filesystem::path& file, const std::string& name) {
  return file.parent_path() / name;
}

}  // namespace

std::vector<FileContent> to_obj(const std::vector<SceneObject>& objects,
                                const std::filesystem::path& file) {
  const std::string stem = file.stem().string();
  std::vector<FileContent> files;
  std::string materials = "# phytobench\n";
  std::set<std::string> seen;
  for (const SceneObject& object : objects) {
    if (!seen.insert(object.material).second) continue;
    const std::string texture = fmt::format("{}-{}.png", stem, object.material);
    materials += fmt::format("newmtl {}\nKa 1 1 1\nKd 1 1 1\nKs 0 0 0\nillum 1\nmap_Kd {}\n",
                             object.material, texture);
    if (object.has_transparency) materials += fmt::format("map_d {}\n", texture);
    files.push_back({beside(file, texture), object.texture_png});
  }
  files.push_back({beside(file, stem + ".mtl"), materials});

  NumberText text;
  text.line("# phytobench");
  text.line("mtllib " + stem + ".mtl");
  std::uint64_t first = 1;
  for (const SceneObject& object : objects) {
    put_object(object, first, text);
    first += object.mesh.vertex_count();
  }
  files.push_back({file, text.take()});
  return files;
}

}  // namespace phytobench
