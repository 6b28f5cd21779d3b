// SPDX-License-Identifier: Apache-2.0
// Scene files: what they say, defaults, matrices, saving, and each complaint by name.
#include "scene/scene_file.hpp"

#include "scene/camera.hpp"
#include "scene_test.hpp"

namespace castray {
namespace {

struct SceneFile : tb::SceneTest {
  void SetUp() override {
    SceneTest::SetUp();
    put("m.geo", tb::kTriangleGeo);
  }
  Scene load(const std::string& text) const { return load_scene(put("s.json", text)); }
  std::string error(const std::string& text) const { return load_error("s.json", text); }
  // A scene of the mesh under a matrix, or with a camera.
  Scene under(const std::string& matrix) const { return load(R"({"meshes": [{"file": "m.geo", "object_to_world": )" + matrix + "}]}"); }
  Scene seen(const std::string& camera) const { return load(R"({"meshes": [{"file": "m.geo"}], "camera": )" + camera + "}"); }
  std::string camera_error(const std::string& camera) const {
    return error(R"({"meshes": [{"file": "m.geo"}], "camera": )" + camera + "}");
  }
};

void expect_near(const Vec3& a, const Vec3& b) {
  EXPECT_NEAR((a - b).length(), 0, 1e-12) << a << " is not " << b;
}

TEST_F(SceneFile, SaysEverything) {
  const Scene scene = load(R"({
    "description": "d", "size": [64, 48], "pixel_format": "bgra8", "background": "#0102fF",
    "camera": {"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1, 0], "field_of_view": 30},
    "checker": {"colours": [[1, 2, 3], "#040506"], "scale": 2.5},
    "meshes": [{"file": "m.geo", "material": "b"}],
    "spheres": [{"centre": [1, 2, 3], "radius": 0.5, "material": "a"}]})");
  EXPECT_EQ(scene.width, 64);
  EXPECT_EQ(scene.height, 48);
  EXPECT_EQ(scene.pixel_format, PixelFormat::Bgra8);
  EXPECT_EQ(scene.paint.background, (Rgb{1, 2, 255}));
  EXPECT_EQ(scene.paint.colour_a, (Rgb{1, 2, 3}));
  EXPECT_EQ(scene.paint.colour_b, (Rgb{4, 5, 6}));
  EXPECT_EQ(scene.paint.checker_scale, 2.5);
  EXPECT_EQ(scene.triangles.at(0).material, Material::ColourB);
  EXPECT_EQ(scene.spheres.at(0).material, Material::ColourA);
  EXPECT_EQ(scene.spheres[0].centre, Vec3(1, 2, 3));
  EXPECT_EQ(scene.camera.field_of_view, 30);
  EXPECT_EQ(scene.camera.eye(), Vec3(0, 0, 5));
  EXPECT_EQ(scene.camera.right(), Vec3(1, 0, 0));
  EXPECT_EQ(scene.camera.back(), Vec3(0, 0, 1));
  EXPECT_TRUE(scene.defaults.empty());
}

TEST_F(SceneFile, DefaultsAreListed) {
  const Scene scene = load(R"({"meshes": [{"file": "m.geo"}]})");
  const std::vector<std::string> expected = {"size: 320 x 240", "background: #181c26", "checker colours: #ece4d0 and #b23c2a", "checker scale: 4",
                                             "field of view: 40 degrees"};
  ASSERT_EQ(scene.defaults.size(), 6u);
  for (std::size_t i = 0; i < expected.size(); ++i) EXPECT_EQ(scene.defaults[i], expected[i]);
  EXPECT_EQ(scene.defaults[5].substr(0, 12), "camera eye: ");
}

// Every corner lies inside the picture, whatever its shape.
TEST_F(SceneFile, DefaultCameraFramesTheScene) {
  for (const auto& [width, height] : {std::pair(320, 240), std::pair(40, 400), std::pair(400, 40)}) {
    const Scene scene = load(R"({"size": [)" + std::to_string(width) + ", " + std::to_string(height) +
                             R"(], "meshes": [{"file": "m.geo", "object_to_world": [{"scale": [300, 7, 1]}]}]})");
    const double tangent = std::tan(scene.camera.field_of_view * M_PI / 360);
    for (const Vec3& corner : scene.triangles.at(0).corner) {
      const Vec3 p = corner - scene.camera.eye();
      const double depth = -p.dot(scene.camera.back());
      EXPECT_GT(depth, 0);
      EXPECT_LE(std::abs(p.dot(scene.camera.up())), depth * tangent);
      EXPECT_LE(std::abs(p.dot(scene.camera.right())), depth * tangent * width / height);
    }
  }
}

TEST_F(SceneFile, DefaultCameraHeedsAnotherSize) {
  const Scene narrow = load_scene(folder_ / "m.geo", FrameSize{40, 400});
  EXPECT_EQ(narrow.width, 40);
  EXPECT_EQ(narrow.height, 400);
  EXPECT_EQ(narrow.camera.to_world, load(R"({"size": [40, 400], "meshes": [{"file": "m.geo"}]})").camera.to_world);
  EXPECT_EQ(load_scene(put("t.json", R"({"size": [7, 9], "meshes": [{"file": "m.geo"}]})"), FrameSize{40, 400}).camera.to_world, narrow.camera.to_world);
}

TEST_F(SceneFile, TheSmallestScenesAreFramed) {
  const Scene scene = under(R"([{"scale": 1e-25}])");
  EXPECT_NEAR(scene.camera.eye().length() / 1e-25, 3, 2);
}

TEST_F(SceneFile, MeshAloneHasTheSameDefaults) {
  const Scene alone = load_scene(folder_ / "m.geo");
  const Scene named = load(R"({"meshes": [{"file": "m.geo"}]})");
  EXPECT_EQ(alone.defaults, named.defaults);
  EXPECT_EQ(alone.camera.to_world, named.camera.to_world);
}

TEST_F(SceneFile, MatrixByRowsHasItsTranslationInTheLastColumn) {
  const Scene scene = under("[0, -2, 0, 10,  2, 0, 0, 20,  0, 0, 2, 30,  0, 0, 0, 1]");
  const Triangle& triangle = scene.triangles.at(0);  // (0,0,0), (1,0,0), (0,1,0)
  EXPECT_EQ(triangle.corner[0], Vec3(10, 20, 30));
  EXPECT_EQ(triangle.corner[1], Vec3(10, 22, 30));
  EXPECT_EQ(triangle.corner[2], Vec3(8, 20, 30));
}

TEST_F(SceneFile, StepsAreAppliedInTurn) {
  const Triangle triangle = under(R"([{"translate": [1, 0, 0]}, {"rotate": [0, 0, 1], "degrees": 90}, {"scale": 3}])").triangles.at(0);
  EXPECT_EQ(triangle.corner[0], Vec3(0, 3, 0));
  EXPECT_EQ(triangle.corner[1], Vec3(0, 6, 0));
  EXPECT_EQ(triangle.corner[2], Vec3(-3, 3, 0));
}

TEST_F(SceneFile, RotationTurnsRightHanded) {
  const Triangle triangle = under(R"([{"rotate": [0, 2, 0], "degrees": 30}])").triangles.at(0);
  expect_near(triangle.corner[1], {std::sqrt(0.75), 0, -0.5});
  expect_near(triangle.normal[0], {0.5, 0, std::sqrt(0.75)});
}

TEST_F(SceneFile, QuarterTurnsAreExact) {
  EXPECT_EQ(under(R"([{"rotate": [0, 0, 1], "degrees": -270}])").triangles.at(0).corner[1], Vec3(0, 1, 0));
  EXPECT_EQ(under(R"([{"rotate": [0, 0, 1], "degrees": 540}])").triangles.at(0).corner[1], Vec3(-1, 0, 0));
}

TEST_F(SceneFile, NormalsGoByTheInverseTranspose) {
  put("n.geo", "1 3 0 1 2  0 0 0 1 0 0 0 1 0  1 1 0 0 0 0 0 0 5  0 0 1 0 0 1\n");
  const Triangle triangle = load(R"({"meshes": [{"file": "n.geo", "object_to_world": [{"scale": [2, 1, 1]}]}]})").triangles.at(0);
  expect_near(triangle.normal[0], Vec3(0.5, 1, 0).normalized());
  EXPECT_EQ(triangle.normal[1], Vec3(0, 0, 0));  // zero stays zero
  EXPECT_EQ(triangle.normal[2], Vec3(0, 0, 1));
}

TEST_F(SceneFile, MirroringKeepsTheOutsideOutside) {
  const Triangle triangle = under(R"([{"flip": "x"}])").triangles.at(0);
  EXPECT_EQ(triangle.corner[1], Vec3(0, 1, 0));  // corners 1 and 2 have changed places
  EXPECT_EQ(triangle.corner[2], Vec3(-1, 0, 0));
  EXPECT_EQ(triangle.tex[1], Vec2(0, 1));
  EXPECT_EQ(triangle.face, Vec3(0, 0, 1));
  EXPECT_EQ(triangle.normal[0], Vec3(0, 0, 1));
  EXPECT_EQ(under(R"([{"flip": "xy"}])").triangles.at(0).corner[1], Vec3(-1, 0, 0));
}

TEST_F(SceneFile, CameraMatrixIsKeptWithItsScale) {
  const Scene scene = seen(R"({"camera_to_world": [{"scale": [0.5, -1, 2]}, {"translate": [1, 2, 3]}]})");
  EXPECT_EQ(scene.camera.right(), Vec3(0.5, 0, 0));
  EXPECT_EQ(scene.camera.up(), Vec3(0, -1, 0));
  EXPECT_EQ(scene.camera.back(), Vec3(0, 0, 2));
  EXPECT_EQ(scene.camera.eye(), Vec3(1, 2, 3));
}

TEST_F(SceneFile, CheckerScaleIsRoundedAloud) {
  const Scene scene = load(R"({"meshes": [{"file": "m.geo"}], "checker": {"scale": 3.3}})");
  EXPECT_EQ(scene.paint.checker_scale, 3.30078125);
  ASSERT_EQ(scene.warnings.size(), 1u);
  EXPECT_EQ(scene.warnings[0], (folder_ / "s.json").string() + ": checker.scale: 3.3 rounded to 3.30078125");
}

TEST_F(SceneFile, SavedReadsBackTheSame) {
  const Scene scene = load(R"({
    "size": [64, 48], "camera": {"eye": [0.1, 0.2, 5], "look_at": [0, 0, 0], "up": [0, 1, 0.3], "field_of_view": 33.3},
    "meshes": [{"file": "m.geo", "material": "b", "object_to_world": [{"rotate": [1, 2, 3], "degrees": 77}, {"translate": [1, 2, 3]}]}],
    "spheres": [{"centre": [1, 2, 0.1], "radius": 0.3}]})");
  std::filesystem::create_directory(folder_ / "sub");
  save_scene(scene, folder_ / "sub" / "saved.json");
  const Scene saved = load_scene(folder_ / "sub" / "saved.json");
  EXPECT_TRUE(saved.defaults.empty());
  EXPECT_EQ(saved.camera.to_world, scene.camera.to_world);
  EXPECT_EQ(saved.camera.field_of_view, scene.camera.field_of_view);
  EXPECT_EQ(saved.paint.colour_b, scene.paint.colour_b);
  EXPECT_EQ(saved.width, 64);
  ASSERT_EQ(saved.triangles.size(), 1u);
  for (int i = 0; i < 3; ++i) EXPECT_EQ(saved.triangles[0].corner[i], scene.triangles[0].corner[i]);
  EXPECT_EQ(saved.triangles[0].material, Material::ColourB);
  EXPECT_EQ(saved.spheres.at(0).centre, scene.spheres[0].centre);
  EXPECT_EQ(scene_text(saved, folder_ / "sub"), scene_text(scene, folder_ / "sub"));
}

TEST_F(SceneFile, IsSavedIntoTheCurrentFolder) {
  const Scene scene = load_scene(folder_ / "m.geo");
  const auto before = std::filesystem::current_path();
  std::filesystem::current_path(folder_);
  save_scene(scene, "saved.json");
  std::filesystem::current_path(before);
  EXPECT_EQ(load_scene(folder_ / "saved.json").triangles.size(), 1u);
}

TEST_F(SceneFile, LengthsOfCameraVectorsDoNotMatter) {
  const Scene plain = seen(R"({"eye": [0, 0, 5], "look_at": [0, 0, 0]})");
  for (const char* far : {R"({"eye": [0, 0, 5], "look_at": [0, 0, -1e300]})", R"({"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1e300, 0]})",
                          R"({"eye": [0, 0, 5], "look_at": [0, 0, 0], "up": [0, 1e-300, 0]})"})
    EXPECT_EQ(seen(far).camera.to_world, plain.camera.to_world) << far;
  EXPECT_EQ(under(R"([{"rotate": [0, 0, 1e200], "degrees": 30}])").triangles[0].corner[1], under(R"([{"rotate": [0, 0, 1], "degrees": 30}])").triangles[0].corner[1]);
}

// ---- Bad input ----

TEST_F(SceneFile, Missing) { EXPECT_EQ(error_of([&] { load_scene(folder_ / "none.json"); }), "none.json: open: no such file"); }
TEST_F(SceneFile, NotJson) {
  EXPECT_EQ(error("{\n  \"size\": [1, 2,]\n}").substr(0, 40), "s.json: line 2, column 17: syntax error ");
  EXPECT_EQ(error("").substr(0, 39), "s.json: line 1, column 1: syntax error ");
}
TEST_F(SceneFile, UnknownKey) {
  EXPECT_EQ(error(R"({"mesh": []})"), "s.json: scene: unknown key \"mesh\"");
  EXPECT_EQ(error(R"({"meshes": [{"file": "m.geo", "colour": 1}]})"), "s.json: meshes[0]: unknown key \"colour\"");
  EXPECT_EQ(camera_error(R"({"fov": 20})"), "s.json: camera: unknown key \"fov\"");
}
TEST_F(SceneFile, MissingMesh) { EXPECT_EQ(error(R"({"meshes": [{"file": "none.geo"}]})"), "none.geo: open: no such file"); }
TEST_F(SceneFile, MissingKey) {
  EXPECT_EQ(error(R"({"meshes": [{}]})"), "s.json: meshes[0]: \"file\" is missing");
  EXPECT_EQ(camera_error(R"({"eye": [1, 2, 3]})"), "s.json: camera: \"look_at\" is missing");
}
TEST_F(SceneFile, WrongType) {
  EXPECT_EQ(error(R"([])"), "s.json: scene: must be an object");
  EXPECT_EQ(error(R"({"meshes": 1})"), "s.json: meshes: must be a list");
  EXPECT_EQ(error(R"({"spheres": [{"centre": [1, 2], "radius": 1}]})"), "s.json: spheres[0].centre: must be a list of 3 numbers");
  EXPECT_EQ(error(R"({"spheres": [{"centre": [1, 2, "x"], "radius": 1}]})"), "s.json: spheres[0].centre[2]: must be a number");
  EXPECT_EQ(error(R"({"meshes": [{"file": 7}]})"), "s.json: meshes[0].file: must be a string");
}
TEST_F(SceneFile, EmptyScene) {
  EXPECT_EQ(error("{}"), "s.json: scene: it holds no triangle and no sphere");
  EXPECT_EQ(error(R"({"meshes": [], "spheres": []})"), "s.json: scene: it holds no triangle and no sphere");
}
TEST_F(SceneFile, FrameOfZeroOrAbsurdSize) {
  EXPECT_EQ(error(R"({"size": [0, 240]})"), "s.json: size[0]: 0 is not between 1 and 4096");
  EXPECT_EQ(error(R"({"size": [320, 4097]})"), "s.json: size[1]: 4097 is not between 1 and 4096");
  EXPECT_EQ(error(R"({"size": [320, -1]})"), "s.json: size[1]: -1 is not between 1 and 4096");
  EXPECT_EQ(error(R"({"size": [320, 1e99]})"), "s.json: size[1]: 1e+99 is not between 1 and 4096");
  EXPECT_EQ(error(R"({"size": [320.5, 1]})"), "s.json: size[0]: 320.5 is not a whole number");
  EXPECT_EQ(error(R"({"size": [320]})"), "s.json: size: must be width and height");
}
TEST_F(SceneFile, InfiniteNumber) { EXPECT_EQ(error(R"({"spheres": [{"centre": [1e999, 0, 0], "radius": 1}]})").substr(0, 14), "s.json: line 1"); }
TEST_F(SceneFile, FieldOfView) {
  EXPECT_EQ(camera_error(R"({"field_of_view": 180})"), "s.json: camera.field_of_view: 180 is not between 0.01 and 179");
  EXPECT_EQ(camera_error(R"({"field_of_view": 0})"), "s.json: camera.field_of_view: 0 is not between 0.01 and 179");
}
TEST_F(SceneFile, CameraWithoutDirection) {
  EXPECT_EQ(camera_error(R"({"eye": [1, 2, 3], "look_at": [1, 2, 3]})"), "s.json: camera: eye, look_at and up define no direction");
  EXPECT_EQ(camera_error(R"({"eye": [0, 2, 0], "look_at": [0, 0, 0]})"), "s.json: camera: eye, look_at and up define no direction");
  // Parallel but for the last bits: else rounding would decide where right points.
  EXPECT_EQ(camera_error(R"({"eye": [1.1, 2.2, 3.3], "look_at": [0.4, 0.8, 1.2], "up": [0.7, 1.4, 2.1]})"),
            "s.json: camera: eye, look_at and up define no direction");
}
TEST_F(SceneFile, KeysGivenTwice) {
  EXPECT_EQ(error(R"({"size": [1, 1], "size": [2, 2]})"), "s.json: key \"size\": stands twice in one object");
  EXPECT_EQ(error(R"({"spheres": [{"centre": [0, 0, 0], "radius": 1, "radius": 2}]})"), "s.json: key \"radius\": stands twice in one object");
}
TEST_F(SceneFile, CameraTwice) {
  EXPECT_EQ(camera_error(R"({"eye": [0, 2, 0], "camera_to_world": []})"), "s.json: camera: \"eye\" beside \"camera_to_world\"");
}
TEST_F(SceneFile, CameraOutsideTheNumberRange) {
  EXPECT_EQ(camera_error(R"({"eye": [1e30, 0, 0], "look_at": [0, 0, 0]})"), "s.json: camera: 1e+30 is outside the number range, +-2^60");
}
TEST_F(SceneFile, SingularMatrix) {
  EXPECT_EQ(error(R"({"meshes": [{"file": "m.geo", "object_to_world": [{"scale": [1, 0, 1]}]}]})"),
            "s.json: meshes[0].object_to_world: the matrix is singular");
  EXPECT_EQ(camera_error(R"({"camera_to_world": [{"scale": 0}]})"), "s.json: camera.camera_to_world: the matrix is singular");
}
TEST_F(SceneFile, TransposedMatrix) {
  EXPECT_EQ(camera_error(R"({"camera_to_world": [1,0,0,0, 0,1,0,0, 0,0,1,0, 1,2,3,1]})"),
            "s.json: camera.camera_to_world: the last row must be 0 0 0 1: the translation is the last column");
  EXPECT_EQ(camera_error(R"({"camera_to_world": [1,0,0]})"), "s.json: camera.camera_to_world: must be a list of 16 numbers");
}
TEST_F(SceneFile, BadStep) {
  const auto step_error = [&](const std::string& step) { return camera_error(R"({"camera_to_world": [)" + step + "]}"); };
  EXPECT_EQ(step_error(R"({"turn": 1})"), "s.json: camera.camera_to_world[0]: unknown key \"turn\"");
  EXPECT_EQ(step_error(R"({})"), "s.json: camera.camera_to_world[0]: must be one of translate, rotate, scale and flip");
  EXPECT_EQ(step_error(R"({"scale": 1, "flip": "x"})"), "s.json: camera.camera_to_world[0]: must be one of translate, rotate, scale and flip");
  EXPECT_EQ(step_error(R"({"rotate": [0, 0, 0], "degrees": 1})"), "s.json: camera.camera_to_world[0].rotate: the axis is zero");
  EXPECT_EQ(step_error(R"({"rotate": [0, 0, 1]})"), "s.json: camera.camera_to_world[0]: \"degrees\" is missing");
  EXPECT_EQ(step_error(R"({"scale": 1, "degrees": 3})"), "s.json: camera.camera_to_world[0]: unknown key \"degrees\"");
  EXPECT_EQ(step_error(R"({"flip": "w"})"), "s.json: camera.camera_to_world[0].flip: must name axes, as in \"x\"");
}
TEST_F(SceneFile, BadColourMaterialAndFormat) {
  EXPECT_EQ(error(R"({"background": "red"})"), "s.json: background: must be three numbers or \"#rrggbb\"");
  EXPECT_EQ(error(R"({"background": [1, 2, 256]})"), "s.json: background[2]: 256 is not between 0 and 255");
  EXPECT_EQ(error(R"({"checker": {"colours": ["#000000"]}})"), "s.json: checker.colours: must be two colours");
  EXPECT_EQ(error(R"({"checker": {"scale": 1024}})"), "s.json: checker.scale: 1024 is not between 0 and 1023");
  EXPECT_EQ(error(R"({"meshes": [{"file": "m.geo", "material": "gold"}]})"), "s.json: meshes[0].material: \"gold\" is not one of checker, a, b");
  EXPECT_EQ(error(R"({"pixel_format": "rgb"})"), "s.json: pixel_format: \"rgb\" is not one of rgba8, bgra8");
}
TEST_F(SceneFile, BadSphere) {
  EXPECT_EQ(error(R"({"spheres": [{"centre": [0, 0, 0], "radius": 0}]})"), "s.json: spheres[0].radius: 0 is not above zero");
  EXPECT_EQ(error(R"({"spheres": [{"centre": [0, 0, 0], "radius": 1}, {"centre": [0, 1e19, 0], "radius": 1}]})"),
            "s.json: spheres[1]: outside the number range, +-2^60");
}
TEST_F(SceneFile, TooSmallToBeFramedWhereItLies) {
  const std::string sphere = R"({"spheres": [{"centre": [1e15, 1e15, 1e15], "radius": 0.001}])";
  EXPECT_EQ(error(sphere + "}"), "s.json: camera: the scene is too small for where it lies: no camera can frame it");
  EXPECT_EQ(error(sphere + R"(, "camera": {"eye": [1e15, 1e15, 2e15], "look_at": [1e15, 1e15, 1e15]}})"), "no error");
}
TEST_F(SceneFile, TransformedOutsideTheNumberRange) {
  EXPECT_EQ(error(R"({"meshes": [{"file": "m.geo", "object_to_world": [{"scale": 1e30}]}]})"),
            "m.geo: point 1, transformed: 1e+30 is outside the number range, +-2^60");
}
TEST_F(SceneFile, UnwritableOutput) {
  const Scene scene = load(R"({"meshes": [{"file": "m.geo"}]})");
  EXPECT_EQ(error_of([&] { save_scene(scene, folder_ / "no" / "s.json"); }), "no/s.json: write: No such file or directory");
  std::filesystem::create_directories(folder_ / "full" / "s.json" / "x");  // a folder in the file's place
  EXPECT_EQ(error_of([&] { save_scene(scene, folder_ / "full" / "s.json"); }), "full/s.json: write: Is a directory");
  EXPECT_EQ(std::distance(std::filesystem::directory_iterator(folder_ / "full"), {}), 1) << "a partial file was left";
}
TEST_F(SceneFile, NamesThatAreNotUtf8) {
  Scene scene = load(R"({"meshes": [{"file": "m.geo"}]})");
  scene.meshes[0].file = "\xff.geo";
  EXPECT_EQ(error_of([&] { save_scene(scene, folder_ / "saved.json"); }), "s.json: meshes: a file name that is not UTF-8 cannot stand in a scene file");
}

}  // namespace
}  // namespace castray
