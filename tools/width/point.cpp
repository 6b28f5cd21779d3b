// SPDX-License-Identifier: Apache-2.0
// One point of the width study, tools/width/study.py: the errors of the model of the widths that this is compiled for, as a line
// of JSON. Linked to the library, of which what depends on widths is compiled with it, here.
//   point FOLDER OF_THE_REFERENCES [all]      all: every ray against every primitive, not those of its tile's list
#include "scene/compile.cpp"
#include "scene/frame.cpp"
#include "scene/grid.cpp"
#include "textbook.hpp"

namespace castray::width {
namespace {

constexpr long kRays = 10000;   // a mesh
constexpr int kFrac = CoordW - 4;   // a teapot's grid has a step of 2^-kFrac

void print(const std::filesystem::path& folder, bool all) {
  std::printf("{\"views\": {");
  View base;
  for (const char* name : {"teapot", "teapot_tight", "teapot_interior", "spheres"}) {
    View view = load_view(name, folder);
    const Errors found = model_errors(view, all);
    std::printf("%s\"%s\": {\"wrong\": %d, \"psnr\": %.2f}", base.reference.empty() ? "" : ", ", name, found.wrong, found.psnr);
    if (base.reference.empty()) base = std::move(view);
  }
  const tb::Mesh meshes[] = {tb::bumpy_sphere(), tb::lattice_cube()};
  const Cracks ours = model_cracks(meshes[0], kRays) + model_cracks(meshes[1], kRays);
  const Cracks theirs = Textbook<kFrac>::mesh_cracks(meshes[0], kRays) + Textbook<kFrac>::mesh_cracks(meshes[1], kRays);
  std::printf("}, \"rays\": %ld, \"none\": %ld, \"several\": %ld, ", 2 * kRays, ours.none, ours.several);
  std::printf("\"textbook\": {\"wrong\": %d, \"none\": %ld, \"several\": %ld}}\n", Textbook<kFrac>::wrong(base), theirs.none, theirs.several);
}

}  // namespace
}  // namespace castray::width

int main(int argc, char** argv) {
  if (argc < 2) return 2;
  castray::width::print(argv[1], argc > 2);
}
