// SPDX-License-Identifier: Apache-2.0
// Where rays come from: a frame's pixels, whose directions become requests from the eye, without
// bounds, or a list of rays. is_list_i stands still. Combinational.
// Model: camera_request() in cpp_model/camera/ray_setup.hpp, equal bit for bit.
module ray_choice
  import castray_pkg::*;
(
  input  logic       is_list_i,
  input  point_t     eye_i,

  input  logic       pixel_valid_i,
  output logic       pixel_ready_o,
  input  pixel_dir_t pixel_i,

  input  logic       list_valid_i,
  output logic       list_ready_o,
  input  ray_req_t   list_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output ray_req_t   out_o
);
  ray_req_t pixel_req;
  assign pixel_req = '{
    tag: pixel_i.tag, org: eye_i, dir: pixel_i.dir, tmin: '0, tmax: TMax,
    cull: 1'b0, any_hit: 1'b0, ok: 1'b1, ignore: NoPrim
  };
  assign out_valid_o   = is_list_i ? list_valid_i : pixel_valid_i;
  assign out_o         = is_list_i ? list_i : pixel_req;
  assign pixel_ready_o = !is_list_i && out_ready_i;
  assign list_ready_o  = is_list_i && out_ready_i;
endmodule
