// SPDX-License-Identifier: Apache-2.0
// docs/scene-file.md says what the parser takes: every key, every limit, every default, every word.
#include <cmath>
#include <set>

#include "../scene/scene_test.hpp"
#include "doc_tables.hpp"
#include "scene/limits.hpp"
#include "scene/scene_names.hpp"
#include "scene/text.hpp"

namespace castray::tb {

const std::string kMesh = R"("meshes": [{"file": "m.geo"}])";

class SceneFilePage : public SceneTest {
 protected:
  void SetUp() override {
    SceneTest::SetUp();
    put("m.geo", kTriangleGeo);
    for (const auto& row : table_rows(page_, "Keys")) {
      const std::string key = row.at(0).substr(1, row.at(0).size() - 2);
      EXPECT_TRUE(rows_.emplace(key, row).second) << key << " stands twice";
    }
  }
  const std::string& meaning(const std::string& key) { return rows_.at(key).at(1); }
  const std::string& by_default(const std::string& key) { return rows_.at(key).at(2); }
  // A scene of one mesh and whatever else `json` says.
  Scene parse(const std::string& json) { return load_scene(put("s.json", "{" + kMesh + ", " + json + "}")); }
  // "LEAST to MOST" in the meaning of a key is what the parser takes, and no more. text(x): the key as JSON.
  template <class Text> void expect_limits(const std::string& key, double step, Text&& text) {
    SCOPED_TRACE(key);
    std::smatch found;
    ASSERT_TRUE(std::regex_search(meaning(key), found, std::regex("([0-9.]+) to ([0-9.]+)"))) << meaning(key);
    const double least = std::stod(found[1]), most = std::stod(found[2]);
    for (const double x : {least, most}) EXPECT_NO_THROW(parse(text(x))) << x;
    for (const double x : {least - step, most + step}) EXPECT_THROW(parse(text(x)), SceneError) << x;
  }

  const std::string page_ = file_text("docs/scene-file.md");
  std::map<std::string, std::vector<std::string>> rows_;
};

template <std::size_t N> void add_keys(std::set<std::string>& keys, const std::string& prefix, const char* const (&names)[N]) {
  keys.erase(prefix.substr(0, prefix.find_first_of(".[")));
  for (const char* name : names) EXPECT_TRUE(keys.insert(prefix + name).second) << name;
}

TEST_F(SceneFilePage, ListsEveryKey) {
  std::set<std::string> keys, listed;
  add_keys(keys, "", kSceneKeys);
  add_keys(keys, "camera.", kCameraKeys);
  add_keys(keys, "checker.", kCheckerKeys);
  add_keys(keys, "meshes[].", kMeshKeys);
  add_keys(keys, "spheres[].", kSphereKeys);
  for (const auto& [key, row] : rows_) listed.insert(key);
  EXPECT_EQ(listed, keys);
}

TEST_F(SceneFilePage, GivesTheLimits) {
  const auto number = [](double x) { return text_of(x); };
  expect_limits("size", 1, [&](double x) { return R"("size": [320, )" + number(x) + "]"; });
  expect_limits("camera.field_of_view", 1e-6, [&](double x) { return R"("camera": {"field_of_view": )" + number(x) + "}"; });
  expect_limits("checker.scale", 1.0 / 256, [&](double x) { return R"("checker": {"scale": )" + number(x) + "}"; });
  EXPECT_NE(meaning("checker.scale").find("steps of 1/256"), std::string::npos);
  EXPECT_EQ(parse(R"("checker": {"scale": 3.0019})").paint.checker_scale, 3);
  EXPECT_EQ(parse(R"("checker": {"scale": 3.0021})").paint.checker_scale, 3 + 1 / 256.0);
  EXPECT_NE(page_.find("within " + std::string(kOutside).substr(std::string(kOutside).find("+-"))), std::string::npos) << kOutside;
  EXPECT_EQ(kLargestCoordinate, 0x1p60);
  EXPECT_NE(page_.find("texture coordinates within +-" + std::to_string(kTextureEnd)), std::string::npos);
}

TEST_F(SceneFilePage, GivesTheDefaults) {
  const Scene scene = parse(R"("spheres": [{"centre": [0, 0, 0], "radius": 1}])");
  EXPECT_EQ(by_default("size"), std::to_string(scene.width) + " x " + std::to_string(scene.height));
  EXPECT_EQ(by_default("camera.field_of_view"), text_of(scene.camera.field_of_view) + " degrees");
  EXPECT_EQ(by_default("background"), "`" + hex(scene.paint.background) + "`");
  EXPECT_EQ(by_default("checker.colours"), "`" + hex(scene.paint.colour_a) + "`, `" + hex(scene.paint.colour_b) + "`");
  EXPECT_EQ(by_default("checker.scale"), text_of(scene.paint.checker_scale));
  EXPECT_EQ(by_default("pixel_format"), "`" + std::string(kPixelFormats[static_cast<int>(scene.pixel_format)]) + "`");
  EXPECT_EQ(by_default("meshes[].material"), "`" + std::string(kMaterials[static_cast<int>(scene.meshes.at(0).material)]) + "`");
  EXPECT_EQ(by_default("spheres[].material"), by_default("meshes[].material"));
  EXPECT_EQ(scene.spheres.at(0).material, scene.meshes.at(0).material);
}

TEST_F(SceneFilePage, SaysWhatMustBeThere) {
  for (const auto& [key, json] : {std::pair{"meshes[].file", R"("meshes": [{}])"}, {"spheres[].centre", R"("spheres": [{"radius": 1}])"},
                                  {"spheres[].radius", R"("spheres": [{"centre": [0, 0, 0]}])"}}) {
    EXPECT_EQ(by_default(key), "must be there");
    const std::string name = std::string(key).substr(std::string(key).find('.') + 1);
    EXPECT_NE(load_error("s.json", "{" + std::string(json) + "}").find("\"" + name + "\" is missing"), std::string::npos) << key;
  }
}

TEST_F(SceneFilePage, NamesEveryWord) {
  for (const char* word : kMaterials) EXPECT_NE(meaning("meshes[].material").find("`" + std::string(word) + "`"), std::string::npos) << word;
  for (const char* word : kPixelFormats) EXPECT_NE(meaning("pixel_format").find("`" + std::string(word) + "`"), std::string::npos) << word;
  const std::string matrices = page_.substr(page_.find("\n## Matrices\n"));
  for (const char* word : kStepKeys) EXPECT_NE(matrices.find("\"" + std::string(word) + "\": "), std::string::npos) << word;
}

TEST_F(SceneFilePage, ShowsASceneThatParses) {
  const std::size_t from = page_.find("```json\n") + 8;
  put("cube.geo", file_text("scenes/cube.geo"));
  const Scene scene = load_scene(put("s.json", page_.substr(from, page_.find("```", from) - from)));
  EXPECT_TRUE(scene.warnings.empty());
  EXPECT_TRUE(scene.defaults.empty()) << scene.defaults.at(0);
  EXPECT_EQ(scene.meshes.size(), 1u);
  EXPECT_EQ(scene.spheres.size(), 1u);
}

}  // namespace castray::tb
