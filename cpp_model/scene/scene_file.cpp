// SPDX-License-Identifier: Apache-2.0
#include "scene/scene_file.hpp"

#include <algorithm>
#include <cmath>

#include "scene/camera.hpp"
#include "scene/files.hpp"
#include "scene/json.hpp"
#include "scene/mesh.hpp"
#include "scene/mesh_file.hpp"
#include "scene/scene_names.hpp"
#include "scene/text.hpp"

namespace castray {
namespace {

template <class Enum, std::size_t N> Enum choice(const JsonValue& value, const char* const (&names)[N]) {
  const std::string text = value.text();
  const auto* found = std::find(std::begin(names), std::end(names), text);
  if (found != std::end(names)) return static_cast<Enum>(found - std::begin(names));
  std::string known;
  for (const char* name : names) known += (known.empty() ? "" : ", ") + std::string(name);
  value.fail("\"" + one_line(text) + "\" is not one of " + known);
}

// "#rrggbb" or three whole numbers from 0 to 255.
Rgb colour(const JsonValue& value) {
  Rgb rgb;
  if (value.is_array()) {
    const auto list = value.elements();
    if (list.size() != 3) value.fail("must be three numbers or \"#rrggbb\"");
    for (int i = 0; i < 3; ++i) rgb[i] = static_cast<std::uint8_t>(list[i].whole({0, 255}));
    return rgb;
  }
  const std::string text = value.text();
  if (text.size() != 7 || text[0] != '#' || text.find_first_not_of("0123456789abcdefABCDEF", 1) != std::string::npos)
    value.fail("must be three numbers or \"#rrggbb\"");
  for (int i = 0; i < 3; ++i) rgb[i] = static_cast<std::uint8_t>(std::stoi(text.substr(1 + 2 * i, 2), nullptr, 16));
  return rgb;
}

void note_default(Scene& scene, const std::string& what, const std::string& value) { scene.defaults.push_back(what + ": " + value); }

// One step of a list of transformations.
Matrix step(const JsonValue& value) {
  value.allow(kStepKeys);
  const int kinds = value.has("translate") + value.has("rotate") + value.has("scale") + value.has("flip");
  if (kinds != 1) value.fail("must be one of translate, rotate, scale and flip");
  if (value.has("degrees") && !value.has("rotate")) value.fail("unknown key \"degrees\"");
  Matrix matrix;
  if (value.has("translate")) {
    matrix.setTranslation(value["translate"].vec3());
  } else if (value.has("rotate")) {
    const Vec3 axis = value["rotate"].vec3();
    if (axis == Vec3(0)) value["rotate"].fail("the axis is zero");
    matrix = rotation(axis, value["degrees"].number());
  } else if (value.has("scale")) {
    const JsonValue scale = value["scale"];
    matrix.setScale(scale.is_array() ? scale.vec3() : Vec3(scale.number()));
  } else {
    const std::string axes = value["flip"].text();
    if (axes.empty() || axes.find_first_not_of("xyz") != std::string::npos) value["flip"].fail("must name axes, as in \"x\"");
    Vec3 signs(1);
    for (const char axis : axes) signs[axis - 'x'] *= -1;
    matrix.setScale(signs);
  }
  return matrix;
}

// Sixteen numbers row by row, or a list of steps, the first one applied first.
Matrix matrix(const JsonValue& value) {
  const auto list = value.elements();
  Matrix matrix;
  if (!list.empty() && list[0].is_number()) {
    const auto rows = value.numbers<16>();
    if (rows[12] != 0 || rows[13] != 0 || rows[14] != 0 || rows[15] != 1) value.fail("the last row must be 0 0 0 1: the translation is the last column");
    matrix = from_rows(rows);
  } else {
    for (const JsonValue& one : list) matrix = matrix * step(one);
  }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j)
      if (!std::isfinite(matrix[i][j])) value.fail("an element is not finite");
  Matrix turn = matrix;
  turn[3][0] = turn[3][1] = turn[3][2] = 0;
  if (const double d = turn.determinant(); !(std::abs(d) > 0) || !std::isfinite(d)) value.fail("the matrix is singular");
  return matrix;
}

void read_camera(const JsonValue& value, Scene& scene, const std::string& file) {
  value.allow(kCameraKeys);
  if (value.has("field_of_view")) scene.camera.field_of_view = value["field_of_view"].number(kFieldOfView);
  else note_default(scene, "field of view", text_of(scene.camera.field_of_view) + " degrees");
  if (value.has("camera_to_world")) {
    for (const char* key : {"eye", "look_at", "up"})
      if (value.has(key)) value.fail(std::string("\"") + key + "\" beside \"camera_to_world\"");
    scene.camera.to_world = matrix(value["camera_to_world"]);
  } else if (value.has("eye") || value.has("look_at") || value.has("up")) {
    const Vec3 eye = value["eye"].vec3(), target = value["look_at"].vec3();
    Vec3 up(0, 1, 0);
    if (value.has("up")) up = value["up"].vec3();
    else note_default(scene, "camera up", "0, 1, 0");
    if (!look_at(eye, target, up, scene.camera.to_world)) value.fail("eye, look_at and up define no direction");
  } else {
    if (!frame_scene(scene)) throw SceneError(file, "camera", "the scene is too small for where it lies: no camera can frame it");
    const Vec3 at = scene.camera.eye();
    note_default(scene, "camera eye", text_of(at.x) + ", " + text_of(at.y) + ", " + text_of(at.z) + ", framing the scene");
  }
  for (int i = 0; i < 3; ++i) check_coordinate(scene.camera.eye()[i], file, "camera");
}

void read_checker(const JsonValue& value, Scene& scene) {
  value.allow(kCheckerKeys);
  if (value.has("colours")) {
    const auto colours = value["colours"].elements();
    if (colours.size() != 2) value["colours"].fail("must be two colours");
    scene.paint.colour_a = colour(colours[0]);
    scene.paint.colour_b = colour(colours[1]);
  } else {
    note_default(scene, "checker colours", hex(scene.paint.colour_a) + " and " + hex(scene.paint.colour_b));
  }
  if (value.has("scale")) {
    const double scale = value["scale"].number(kCheckerScale);
    scene.paint.checker_scale = std::round(scale * (1 << CheckerFrac)) / (1 << CheckerFrac);
    if (scene.paint.checker_scale != scale)
      scene.warnings.push_back(scene.file + ": checker.scale: " + text_of(scale) + " rounded to " + text_of(scene.paint.checker_scale));
  } else {
    note_default(scene, "checker scale", text_of(scene.paint.checker_scale));
  }
}

void read_meshes(const JsonValue& value, Scene& scene, const std::filesystem::path& folder) {
  for (const JsonValue& one : value.elements()) {
    one.allow(kMeshKeys);
    MeshSource source;
    const std::string name = one["file"].text();
    if (name.empty()) one["file"].fail("is empty: the name of a mesh is needed");
    if (name.find('\0') != std::string::npos) one["file"].fail("a file's name cannot hold a zero byte");
    source.file = (folder / name).lexically_normal().string();
    if (one.has("object_to_world")) source.object_to_world = matrix(one["object_to_world"]);
    if (one.has("material")) source.material = choice<Material>(one["material"], kMaterials);
    add_mesh(scene, read_mesh(source.file), source.object_to_world, source.material, source.file);
    scene.meshes.push_back(source);
  }
}

void read_spheres(const JsonValue& value, Scene& scene) {
  for (const JsonValue& one : value.elements()) {
    one.allow(kSphereKeys);
    Sphere sphere;
    sphere.centre = one["centre"].vec3();
    sphere.radius = one["radius"].number();
    if (!(sphere.radius > 0)) one["radius"].fail(text_of(sphere.radius) + " is not above zero");
    if (one.has("material")) sphere.material = choice<Material>(one["material"], kMaterials);
    try {
      for (int i = 0; i < 3; ++i) check_coordinate(std::abs(sphere.centre[i]) + sphere.radius, "", "");
    } catch (const SceneError&) {
      one.fail(kOutside);
    }
    scene.spheres.push_back(sphere);
  }
}

Scene read_scene(const nlohmann::json& json, const std::string& file, const std::filesystem::path& folder, std::optional<FrameSize> frame) {
  static const nlohmann::json nothing = nlohmann::json::object();
  Scene scene;
  scene.file = file;
  const JsonValue root(json, file, "");
  root.allow(kSceneKeys);

  if (root.has("description")) scene.description = root["description"].text();
  if (root.has("size")) {
    const auto size = root["size"].elements();
    if (size.size() != 2) root["size"].fail("must be width and height");
    scene.width = size[0].whole(kFrameSize);
    scene.height = size[1].whole(kFrameSize);
  } else if (!frame) {
    note_default(scene, "size", std::to_string(scene.width) + " x " + std::to_string(scene.height));
  }
  if (frame) scene.width = frame->width, scene.height = frame->height;
  if (root.has("background")) scene.paint.background = colour(root["background"]);
  else note_default(scene, "background", hex(scene.paint.background));
  read_checker(root.has("checker") ? root["checker"] : JsonValue(nothing, file, "checker"), scene);
  if (root.has("pixel_format")) scene.pixel_format = choice<PixelFormat>(root["pixel_format"], kPixelFormats);
  if (root.has("meshes")) read_meshes(root["meshes"], scene, folder);
  if (root.has("spheres")) read_spheres(root["spheres"], scene);
  if (scene.primitives() == 0)
    throw SceneError(scene.file, "scene", scene.dropped_triangles == 0 ? "it holds no triangle and no sphere" : "all its triangles are degenerate");
  read_camera(root.has("camera") ? root["camera"] : JsonValue(nothing, file, "camera"), scene, file);
  return scene;
}

}  // namespace

Scene read_scene_file(const std::filesystem::path& path, std::optional<FrameSize> size) {
  return read_scene(parse_json(read_file(path), path.string()), path.string(), path.parent_path(), size);
}

Scene mesh_scene(const std::filesystem::path& path, std::optional<FrameSize> size) {
  const nlohmann::json json = {{"meshes", {{{"file", path.filename().string()}}}}};
  return read_scene(json, path.string(), path.parent_path(), size);
}

}  // namespace castray
