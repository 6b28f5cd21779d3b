// SPDX-License-Identifier: Apache-2.0
#include "scene/import.hpp"

#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include <assimp/Importer.hpp>

#include "scene/files.hpp"
#include "scene/text.hpp"

namespace castray {
namespace {

Vec3 vec(const aiVector3D& v) { return {v.x, v.y, v.z}; }

class Gather {
 public:
  Gather(const aiScene& scene, const std::string& file, Mesh& mesh) : scene_(scene), file_(file), mesh_(mesh) {
    for (unsigned i = 0; i < scene.mNumMeshes; ++i) {
      has_normals_ |= scene.mMeshes[i]->HasNormals();
      has_tex_ |= scene.mMeshes[i]->HasTextureCoords(0);
    }
  }

  void node(const aiNode& node, const aiMatrix4x4& parent) {
    const aiMatrix4x4 matrix = parent * node.mTransformation;
    for (unsigned i = 0; i < node.mNumMeshes; ++i) part(*scene_.mMeshes[node.mMeshes[i]], matrix);
    for (unsigned i = 0; i < node.mNumChildren; ++i) this->node(*node.mChildren[i], matrix);
  }

  std::size_t ignored() const { return ignored_; }

 private:
  void part(const aiMesh& part, const aiMatrix4x4& matrix) {
    const std::size_t base = mesh_.points.size();
    aiMatrix3x3 turn(matrix);
    const bool mirrors = turn.Determinant() < 0;
    turn.Inverse().Transpose();
    for (unsigned i = 0; i < part.mNumVertices; ++i) {
      for (int axis = 0; axis < 3; ++axis)
        check_coordinate(part.mVertices[i][axis], file_, "point " + std::to_string(base + i));
      mesh_.points.push_back(vec(matrix * part.mVertices[i]));
    }
    for (unsigned f = 0; f < part.mNumFaces; ++f) {
      const aiFace& face = part.mFaces[f];
      const std::size_t number = mesh_.face_sizes.size();
      if (face.mNumIndices < 3) {
        ++ignored_;
        continue;
      }
      mesh_.face_sizes.push_back(face.mNumIndices);
      for (unsigned k = 0; k < face.mNumIndices; ++k) {
        const unsigned at = face.mIndices[mirrors ? face.mNumIndices - 1 - k : k];
        if (at >= part.mNumVertices)
          throw SceneError(file_, "face " + std::to_string(number),
                           "index " + std::to_string(at) + " is out of range, there are " + counted(part.mNumVertices, "point"));
        mesh_.corners.push_back(static_cast<std::uint32_t>(base + at));
        if (has_normals_) mesh_.normals.push_back(part.HasNormals() ? normal(turn * part.mNormals[at], number) : Vec3(0));
        if (has_tex_) mesh_.tex.push_back(part.HasTextureCoords(0) ? tex(part.mTextureCoords[0][at], number) : Vec2(0));
      }
    }
  }

  Vec3 normal(const aiVector3D& n, std::size_t face) const {
    for (int axis = 0; axis < 3; ++axis) check_coordinate(n[axis], file_, "normal of face " + std::to_string(face));
    return vec(n);
  }
  Vec2 tex(const aiVector3D& t, std::size_t face) const {
    for (int axis = 0; axis < 2; ++axis) check_coordinate(t[axis], file_, "texture coordinate of face " + std::to_string(face));
    return {t.x, t.y};
  }

  const aiScene& scene_;
  const std::string& file_;
  Mesh& mesh_;
  bool has_normals_ = false, has_tex_ = false;
  std::size_t ignored_ = 0;
};

// assimp ends the program when it is to triangulate a face without corners.
void check_corners(const aiScene& scene, const std::string& file) {
  for (unsigned m = 0; m < scene.mNumMeshes; ++m)
    for (unsigned f = 0; f < scene.mMeshes[m]->mNumFaces; ++f)
      if (scene.mMeshes[m]->mFaces[f].mNumIndices == 0) throw SceneError(file, "face " + std::to_string(f), "has no corners");
}

}  // namespace

Mesh import_mesh(const std::filesystem::path& path) {
  const std::string file = path.string();
  check_readable(path);
  Assimp::Importer importer;
  const auto read = [&](const aiScene* scene) -> const aiScene& {
    if (scene == nullptr || scene->mRootNode == nullptr) throw SceneError(file, "import", one_line(importer.GetErrorString()));
    return *scene;
  };
  check_corners(read(importer.ReadFile(file, aiProcess_ValidateDataStructure)), file);
  const aiScene& scene = read(importer.ApplyPostProcessing(aiProcess_Triangulate));
  Mesh mesh;
  Gather gather(scene, file, mesh);
  gather.node(*scene.mRootNode, aiMatrix4x4());
  if (gather.ignored() != 0) mesh.warnings.push_back(file + ": " + counted(gather.ignored(), "point or line") + " ignored");
  if (mesh.face_sizes.empty()) throw SceneError(file, "mesh", "no faces");
  return mesh;
}

}  // namespace castray
