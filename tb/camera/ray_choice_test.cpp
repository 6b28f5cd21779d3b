// SPDX-License-Identifier: Apache-2.0
// Pixels become the model's requests, a list's pass as they are, and only one of the two is asked.
#include "Vray_choice.h"
#include "camera/ray_setup.hpp"
#include "dut.hpp"

namespace castray::tb {
namespace {

template <class Record> Record random_record(std::mt19937_64& rng) {
  packed_t<Record> words;
  for (auto& word : words) word = static_cast<std::uint32_t>(rng());
  return unpack<Record>(words.data());
}

TEST(RayChoice, GivesTheRequestsOfItsSource) {
  VerilatedContext context;
  Vray_choice top(&context);
  std::mt19937_64 rng(4);
  for (int i = 0; i < 4096; ++i) {
    const auto pixel = random_record<pixel_dir_t>(rng);
    const auto ray = random_record<ray_req_t>(rng);
    camera_t camera;
    camera.eye = random_record<point_t>(rng);
    const bool list = i & 1, pixel_valid = i & 2, list_valid = i & 4, ready = i & 8;
    top.is_list_i = list;
    set_port(top.eye_i, camera.eye);
    set_port(top.pixel_i, pixel);
    set_port(top.list_i, ray);
    top.pixel_valid_i = pixel_valid, top.list_valid_i = list_valid, top.out_ready_i = ready;
    top.eval();
    EXPECT_EQ(top.out_valid_o, list ? list_valid : pixel_valid);
    EXPECT_EQ(top.pixel_ready_o, !list && ready);
    EXPECT_EQ(top.list_ready_o, list && ready);
    EXPECT_TRUE(get_port<ray_req_t>(top.out_o) == (list ? ray : camera_request(pixel.dir, camera, pixel.tag)));
  }
}

}  // namespace
}  // namespace castray::tb
