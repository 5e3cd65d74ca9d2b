// SPDX-License-Identifier: MIT
// Exported files, read back by a library that had no part in writing them.
#include <cmath>
#include <fstream>

#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <gtest/gtest.h>
#include <assimp/Importer.hpp>

#include "core/contract/errors.hpp"
#include "core/geometry/bounding_box.hpp"
#include "core/tree/gltf_export.hpp"
#include "core/tree/obj_export.hpp"

namespace phytobench {
namespace {

namespace fs = std::filesystem;

Skeleton fork() {
  Skeleton tree({0, 0, 0});
  tree.append(0, {0.1, 1, 0});
  tree.append(1, {0.8, 1.7, 0.3});
  tree.append(1, {-0.7, 1.6, -0.2});
  tree.append(3, {-1.1, 1.1, -0.2});
  return tree;
}

class Export : public testing::Test {
 protected:
  void SetUp() override {
    folder_ = fs::temp_directory_path() / ("phytobench-export-" + std::to_string(::getpid()));
    fs::create_directories(folder_);
    PlantParameters parameters;
    parameters.branches.circle_resolution = 5;
    parameters.leaves.per_node = 2.0;
    objects_ = scene_objects(make_plant(fork(), parameters), parameters);
  }
  void TearDown() override { fs::remove_all(folder_); }

  /// Assimp merges nothing and changes no order with these flags.
  const aiScene* read(const fs::path& file) {
    const aiScene* scene = importer_.ReadFile(file.string(), aiProcess_ValidateDataStructure);
    EXPECT_NE(scene, nullptr) << importer_.GetErrorString();
    return scene;
  }

  static const aiMesh* mesh_named(const aiScene* scene, const std::string& name) {
    for (unsigned i = 0; i < scene->mNumMeshes; ++i)
      if (name == scene->mMeshes[i]->mName.C_Str()) return scene->mMeshes[i];
    return nullptr;
  }

  fs::path folder_;
  std::vector<SceneObject> objects_;
  Assimp::Importer importer_;
};

BoundingBox box_of(const TriangleMesh& mesh) {
  BoundingBox box;
  for (const Vector3& p : mesh.positions) box.extend(p);
  return box;
}

Vector3 vector_of(const aiVector3D& v) {
  return {v.x, v.y, v.z};
}

/// Compares corner by corner: a reader may number vertices as it likes.
void expect_same(const aiMesh* read, const TriangleMesh& written) {
  ASSERT_NE(read, nullptr);
  ASSERT_EQ(read->mNumFaces, written.triangle_count());
  ASSERT_TRUE(read->HasNormals());
  ASSERT_TRUE(read->HasTextureCoords(0));
  BoundingBox box;
  for (unsigned f = 0; f < read->mNumFaces; ++f) {
    ASSERT_EQ(read->mFaces[f].mNumIndices, 3u);
    for (unsigned corner = 0; corner < 3; ++corner) {
      const unsigned i = read->mFaces[f].mIndices[corner];
      const std::uint32_t j = written.triangles[f][corner];
      EXPECT_LE(norm(vector_of(read->mVertices[i]) - written.positions[j]), 1e-6);
      EXPECT_LE(norm(vector_of(read->mNormals[i]) - written.normals[j]), 1e-6);
      EXPECT_NEAR(read->mTextureCoords[0][i].x, written.texture_points[j].u, 1e-6);
      EXPECT_NEAR(read->mTextureCoords[0][i].y, written.texture_points[j].v, 1e-6);
      box.extend(vector_of(read->mVertices[i]));
    }
  }
  EXPECT_LE(norm(box.low() - box_of(written).low()), 1e-6);
  EXPECT_LE(norm(box.high() - box_of(written).high()), 1e-6);
}

TEST_F(Export, ObjIsReadBackWithMaterialsAndTextures) {
  const auto files = to_obj(objects_, folder_ / "plant.obj");
  ASSERT_EQ(files.size(), 4u);  // two textures, materials, the model
  write_files_atomically(files);
  const aiScene* scene = read(folder_ / "plant.obj");
  ASSERT_NE(scene, nullptr);
  ASSERT_EQ(scene->mNumMeshes, 2u);
  for (const SceneObject& object : objects_) {
    const aiMesh* mesh = mesh_named(scene, object.name);
    expect_same(mesh, object.mesh);
    aiString texture;
    const aiMaterial* material = scene->mMaterials[mesh->mMaterialIndex];
    ASSERT_EQ(material->GetTexture(aiTextureType_DIFFUSE, 0, &texture), aiReturn_SUCCESS);
    EXPECT_TRUE(fs::exists(folder_ / texture.C_Str())) << texture.C_Str();
  }
}

TEST_F(Export, BinaryGltfIsReadBackWithTexturesInside) {
  write_file_atomically(folder_ / "plant.glb", to_glb(objects_));
  const aiScene* scene = read(folder_ / "plant.glb");
  ASSERT_NE(scene, nullptr);
  ASSERT_EQ(scene->mNumMeshes, 2u);
  ASSERT_EQ(scene->mNumTextures, 2u);
  for (std::size_t i = 0; i < objects_.size(); ++i) {
    const aiMesh* mesh = mesh_named(scene, objects_[i].name);
    expect_same(mesh, objects_[i].mesh);
    EXPECT_EQ(mesh->mNumVertices, objects_[i].mesh.vertex_count());
    const aiTexture* texture = scene->mTextures[i];
    const std::string png(reinterpret_cast<const char*>(texture->pcData), texture->mWidth);
    EXPECT_EQ(png, objects_[i].texture_png);
  }
}

TEST_F(Export, PartsShareTheirMaterial) {
  std::vector<SceneObject> parts = split_objects(objects_, 12);
  EXPECT_GT(parts.size(), 4u);
  write_files_atomically(to_obj(parts, folder_ / "parts.obj"));
  write_file_atomically(folder_ / "parts.glb", to_glb(parts));
  for (const char* name : {"parts.obj", "parts.glb"}) {
    const aiScene* scene = read(folder_ / name);
    ASSERT_NE(scene, nullptr);
    ASSERT_EQ(scene->mNumMeshes, parts.size()) << name;
    for (const SceneObject& part : parts) expect_same(mesh_named(scene, part.name), part.mesh);
  }
}

TEST_F(Export, TheSamePlantGivesTheSameBytes) {
  EXPECT_EQ(to_glb(objects_), to_glb(objects_));
  EXPECT_EQ(to_obj(objects_, "a.obj").back().content, to_obj(objects_, "a.obj").back().content);
}

TEST_F(Export, AForeignTextureGoesInAsItIs) {
  const std::string png = to_png(Image(3, 2, {1, 2, 3, 255}));
  write_file_atomically(folder_ / "mine.png", png);
  PlantParameters parameters;
  parameters.bark_texture = (folder_ / "mine.png").string();
  EXPECT_EQ(scene_objects(make_plant(fork(), parameters), parameters)[0].texture_png, png);
  parameters.bark_texture = (folder_ / "none.png").string();
  EXPECT_THROW(scene_objects(make_plant(fork(), parameters), parameters), InputError);
}

TEST_F(Export, APlantWithoutLeavesHasOneObject) {
  PlantParameters parameters;
  parameters.leaves.per_node = 0.0;
  EXPECT_EQ(scene_objects(make_plant(fork(), parameters), parameters).size(), 1u);
}

}  // namespace
}  // namespace phytobench
