// SPDX-License-Identifier: Apache-2.0
// Writes the Utah teapot as .geo: make_teapot --n 10 -o scenes/teapot.geo
#include <CLI/CLI.hpp>
#include <iostream>

#include "scene/files.hpp"
#include "scene/geo.hpp"
#include "scene/teapot.hpp"

int main(int argc, char** argv) {
  CLI::App app("Writes the Utah teapot's 32 Bezier patches as a .geo mesh");
  int n = 10;
  std::string out = "scenes/teapot.geo";
  app.add_option("--n", n, "cells of each patch along each side")->check(CLI::Range(1, 250))->capture_default_str();
  app.add_option("-o,--output", out, "file to write")->capture_default_str();
  CLI11_PARSE(app, argc, argv);
  try {
    const castray::Mesh mesh = castray::teapot_mesh(n);
    castray::write_file(out, castray::geo_text(mesh));
    std::size_t triangles = 0;
    for (const auto size : mesh.face_sizes) triangles += size - 2;
    std::cout << out << ": " << mesh.points.size() << " points, " << triangles << " triangles\n";
  } catch (const castray::SceneError& error) {
    std::cerr << error.what() << '\n';
    return 1;
  }
}
