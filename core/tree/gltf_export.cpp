// SPDX-License-Identifier: MIT
// Written by hand rather than with a library: the container is two headers and a table of byte
// ranges, and textures go in as the PNG they are.
#include "core/tree/gltf_export.hpp"

#include <algorithm>
#include <array>
#include <bit>
#include <limits>
#include <map>

#include <nlohmann/json.hpp>

#include "core/contract/errors.hpp"
#include "core/geometry/bounding_box.hpp"

namespace phytobench {

namespace {

using nlohmann::ordered_json;

// Names of the format's specification, section 5.
constexpr int float_component = 5126, short_index = 5123, int_index = 5125;
constexpr int vertex_buffer = 34962, index_buffer = 34963;
constexpr int linear_filter = 9729, linear_mipmap_filter = 9987, repeat_wrap = 10497;

template <class Number>
void append_number(std::string& bytes, Number number) {
  const auto raw = std::bit_cast<std::array<char, sizeof(Number)>>(number);  // x86 is little-endian
  bytes.append(raw.data(), raw.size());
}

class GlbBuilder {
 public:
  void add(const SceneObject& object) {
    const TriangleMesh& mesh = object.mesh;
    ordered_json primitive;
    primitive["attributes"] = {{"POSITION", add_positions(mesh)},
                               {"NORMAL", add_normals(mesh)},
                               {"TEXCOORD_0", add_texture_points(mesh)}};
    primitive["indices"] = add_indices(mesh);
    primitive["material"] = material_of(object);
    const auto number = static_cast<int>(json_["meshes"].size());
    json_["meshes"].push_back(
        {{"name", object.name}, {"primitives", ordered_json::array({primitive})}});
    json_["nodes"].push_back({{"name", object.name}, {"mesh", number}});
    json_["scenes"][0]["nodes"].push_back(number);
  }

  std::string take() {
    json_["buffers"].push_back({{"byteLength", binary_.size()}});
    std::string text = json_.dump();
    text.resize((text.size() + 3) / 4 * 4, ' ');
    const std::size_t whole = 12 + 8 + text.size() + 8 + binary_.size();
    if (whole > std::numeric_limits<std::uint32_t>::max())
      throw InputError(
          "the plant is too large for one binary glTF file (4 GiB); lower "
          "leaves.per_node or mesh.circle_resolution, or export as OBJ");
    std::string bytes = "glTF";
    append_number<std::uint32_t>(bytes, 2);
    append_number<std::uint32_t>(bytes, static_cast<std::uint32_t>(whole));
    append_chunk(bytes, "JSON", text);
    append_chunk(bytes, std::string_view("BIN\0", 4), binary_);
    return bytes;
  }

 private:
  static void append_chunk(std::string& bytes, std::string_view kind, const std::string& content) {
    append_number<std::uint32_t>(bytes, static_cast<std::uint32_t>(content.size()));
    bytes += kind;
    bytes += content;
  }

  /// Notes what has been appended since `begin` as a byte range, padded to four bytes.
  int view_since(std::size_t begin, int target) {
    ordered_json view = {
        {"buffer", 0}, {"byteOffset", begin}, {"byteLength", binary_.size() - begin}};
    if (target != 0) view["target"] = target;
    binary_.resize((binary_.size() + 3) / 4 * 4, '\0');
    json_["bufferViews"].push_back(view);
    return static_cast<int>(json_["bufferViews"].size()) - 1;
  }

  int accessor(int view, int component, std::size_t count, const char* kind) {
    json_["accessors"].push_back(
        {{"bufferView", view}, {"componentType", component}, {"count", count}, {"type", kind}});
    return static_cast<int>(json_["accessors"].size()) - 1;
  }

  int add_vectors(const LargeVector<Vector3>& vectors) {
    const std::size_t begin = binary_.size();
    binary_.reserve(begin + 12 * vectors.size());
    for (const Vector3& v : vectors)
      for (const double coordinate : {v.x, v.y, v.z})
        append_number(binary_, static_cast<float>(coordinate));
    return accessor(view_since(begin, vertex_buffer), float_component, vectors.size(), "VEC3");
  }

  int add_positions(const TriangleMesh& mesh) {
    BoundingBox box;  // of the rounded coordinates, which is what a reader compares
    for (const Vector3& p : mesh.positions)
      box.extend({static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)});
    const int number = add_vectors(mesh.positions);
    ordered_json& entry = json_["accessors"].back();
    entry["min"] = {box.low().x, box.low().y, box.low().z};
    entry["max"] = {box.high().x, box.high().y, box.high().z};
    return number;
  }

  int add_normals(const TriangleMesh& mesh) { return add_vectors(mesh.normals); }

  /// The format counts texture rows from the top.
  int add_texture_points(const TriangleMesh& mesh) {
    const std::size_t begin = binary_.size();
    for (const TexturePoint& t : mesh.texture_points) {
      append_number(binary_, static_cast<float>(t.u));
      append_number(binary_, static_cast<float>(1.0 - t.v));
    }
    return accessor(view_since(begin, vertex_buffer), float_component, mesh.texture_points.size(),
                    "VEC2");
  }

  int add_indices(const TriangleMesh& mesh) {
    const std::size_t begin = binary_.size();
    const bool is_short = mesh.vertex_count() <= 65535;  // 65,535 itself means "restart"
    for (const Triangle& triangle : mesh.triangles)
      for (const std::uint32_t vertex : triangle) {
        if (is_short)
          append_number(binary_, static_cast<std::uint16_t>(vertex));
        else
          append_number(binary_, vertex);
      }
    return accessor(view_since(begin, index_buffer), is_short ? short_index : int_index,
                    3 * mesh.triangle_count(), "SCALAR");
  }

  int material_of(const SceneObject& object) {
    const auto known = materials_.find(object.material);
    if (known != materials_.end()) return known->second;
    const auto number = static_cast<int>(materials_.size());
    const std::size_t begin = binary_.size();
    binary_ += object.texture_png;
    json_["images"].push_back({{"bufferView", view_since(begin, 0)}, {"mimeType", "image/png"}});
    if (number == 0)
      json_["samplers"].push_back({{"magFilter", linear_filter},
                                   {"minFilter", linear_mipmap_filter},
                                   {"wrapS", repeat_wrap},
                                   {"wrapT", repeat_wrap}});
    json_["textures"].push_back({{"sampler", 0}, {"source", number}});
    ordered_json material = {{"name", object.material},
                             {"pbrMetallicRoughness",
                              {{"baseColorTexture", {{"index", number}}},
                               {"metallicFactor", 0.0},
                               {"roughnessFactor", 1.0}}}};
    if (object.has_transparency) {
      material["alphaMode"] = "MASK";
      material["alphaCutoff"] = 0.5;
    }
    json_["materials"].push_back(material);
    materials_[object.material] = number;
    return number;
  }

  static ordered_json start() {
    ordered_json json;
    json["asset"] = {{"version", "2.0"}, {"generator", "phytobench"}};
    json["scene"] = 0;
    json["scenes"].push_back({{"nodes", ordered_json::array()}});
    return json;
  }

  ordered_json json_ = start();
  std::string binary_;
  std::map<std::string, int> materials_;
};

}  // namespace

std::string to_glb(const std::vector<SceneObject>& objects) {
  GlbBuilder builder;
  for (const SceneObject& object : objects) builder.add(object);
  return builder.take();
}

}  // namespace phytobench
