// SPDX-License-Identifier: Apache-2.0
#include "bench_scenes.hpp"

#include <map>
#include <mutex>

#include "scene/load.hpp"
#include "scene/made_scenes.hpp"

namespace castray::bench {
namespace {

Scene make(const std::string& file) {
  if (file == "teapot100k") return made_teapot(40, file).scene;
  if (file == "teapot1m") return made_teapot(125, file).scene;
  if (file == "field") return made_field(8, 8, 10, file).scene;
  if (file == "spheres4k") return made_spheres(4096, 1).scene;
  return load_scene("scenes/" + file + ".json");
}

// One at a time is made, so that two runs do not make the same. All stay: some 600 MB.
template <class Value> class Kept {
 public:
  template <class Make> std::shared_ptr<const Value> get(const std::string& key, Make&& make) {
    const std::scoped_lock lock(mutex_);
    std::shared_ptr<const Value>& value = values_[key];
    if (!value) value = std::make_shared<const Value>(make());
    return value;
  }

 private:
  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<const Value>> values_;
};

}  // namespace

std::shared_ptr<const Scene> scene_of(const Frame& frame) {
  static Kept<Scene> scenes;
  return scenes.get(frame.file, [&] { return make(frame.file); });
}

std::shared_ptr<const SceneImage> image_of(const Frame& frame) {
  static Kept<SceneImage> images;
  return images.get(frame.file + " " + std::to_string(frame.width) + "x" + std::to_string(frame.height),
                    [&] { return compile(*scene_of(frame), frame.width, frame.height); });
}

}  // namespace castray::bench
