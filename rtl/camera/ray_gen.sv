// SPDX-License-Identifier: Apache-2.0
// The direction through a pixel's centre, the camera-to-world matrix applied in frame_setup:
//   s0     a = 2x + 1 - width    b = height - 2y - 1
//   s1-s3  dir = ahead + a right + b up      exact in Q3.42 (what exceeds it wraps)
// Four stages, one pixel a cycle, in order. 12 multipliers of 27x18.
// Model: cpp_model/camera/ray_gen.hpp, equal bit for bit.
module ray_gen
  import castray_pkg::*;
(
  input  logic       clk_i,
  input  logic       rst_ni,

  input  camera_t    camera_i,   // held while pixels are under way

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  pixel_tag_t in_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output pixel_dir_t out_o
);
  logic [3:0] load;
  pipe_chain #(.Stages(4)) u_chain (
    .clk_i, .rst_ni,
    .valid_i(in_valid_i), .ready_o(in_ready_o),
    .valid_o(out_valid_o), .ready_i(out_ready_i),
    .load_o(load)
  );

  // 2 i + 1 - n, odd for an even n; its magnitude is below MaxFrameSize.
  function automatic offset_t offset(pixel_t i, extent_t n);
    return offset_t'({1'b0, i, 1'b1} - {1'b0, n});
  endfunction

  offset_t    a_q, b_q;
  pixel_tag_t tag_q [4];
  dir_comp_t  x, y, z;

  always_ff @(posedge clk_i) begin
    if (load[0]) begin
      a_q <= offset(in_i.x, camera_i.width);
      b_q <= -offset(in_i.y, camera_i.height);
      tag_q[0] <= in_i;
    end
    for (int unsigned i = 1; i < 4; i++) if (load[i]) tag_q[i] <= tag_q[i-1];
  end

  ray_component u_x (
    .clk_i, .load_i(load[3:1]), .a_i(a_q), .b_i(b_q),
    .ahead_i(camera_i.ahead.x), .right_i(camera_i.right.x), .up_i(camera_i.up.x), .dir_o(x)
  );
  ray_component u_y (
    .clk_i, .load_i(load[3:1]), .a_i(a_q), .b_i(b_q),
    .ahead_i(camera_i.ahead.y), .right_i(camera_i.right.y), .up_i(camera_i.up.y), .dir_o(y)
  );
  ray_component u_z (
    .clk_i, .load_i(load[3:1]), .a_i(a_q), .b_i(b_q),
    .ahead_i(camera_i.ahead.z), .right_i(camera_i.right.z), .up_i(camera_i.up.z), .dir_o(z)
  );
  assign out_o = '{tag: tag_q[3], dir: '{x: x, y: y, z: z}};

  logic unused_eye;  // the origin is ray_setup's
  assign unused_eye = ^camera_i.eye;
endmodule
