// SPDX-License-Identifier: Apache-2.0
// The scenes of the bench and their images, each made once and shared by the runs that want it at a time.
#pragma once
#include <memory>

#include "bench_runs.hpp"
#include "scene/compile.hpp"

namespace castray::bench {

// Those that no file holds: teapot100k, teapot1m (the base view), field (8 x 8 teapots on a ground), spheres4k.
std::shared_ptr<const Scene> scene_of(const Frame& frame);
std::shared_ptr<const SceneImage> image_of(const Frame& frame);

}  // namespace castray::bench
