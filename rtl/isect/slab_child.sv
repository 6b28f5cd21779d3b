// SPDX-License-Identifier: Apache-2.0
// One child's box on all three axes: where is the ray inside it?
//   s1      the planes on permuted axes
//   s2-s5   between those across the two other axes                  (slab_planes)
//   s6      low = the last of the three entries, high = the first of the exits
// none_o, or low_o > high_o: nowhere.
// One child a cycle, never stalls; en_i[k]: stage k + 1 takes an item. Of each axis, x first: mant_i and
// more_i belong to s3, minus_i, low_i and high_i to s4, left_i to s5.
// Model: cpp_model/isect/slab_child.hpp, equal bit for bit.
module slab_child
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
(
  input  logic              clk_i,

  input  logic [5:0]        en_i,
  input  child_box_t        box_i,
  input  axis_t             axis_i,
  input  logic [1:0] [9:0]  mant_i,
  input  logic [1:0] [10:0] more_i,   // mant + 1
  input  logic [1:0]        minus_i,
  input  slab_t [1:0]       low_i,
  input  slab_t [1:0]       high_i,
  input  logic [1:0] [3:0]  left_i,

  output logic              none_o,
  output tick_t             low_o,
  output tick_t             high_o
);
  typedef struct packed {
    plane_t x, y, z;
  } planes_t;
  typedef struct packed {
    plane_t low, high;
  } pair_t;

  // As corner_delta permutes positions.
  function automatic planes_t planes_of(plane_t x, plane_t y, plane_t z, axis_t axis);
    return (axis == 2'd0) ? '{x: y, y: z, z: x} : (axis == 2'd1) ? '{x: z, y: x, z: y} : '{x: x, y: y, z: z};
  endfunction

  function automatic tick_t later(tick_t a, tick_t b);
    return (a > b) ? a : b;
  endfunction
  function automatic tick_t sooner(tick_t a, tick_t b);
    return (a < b) ? a : b;
  endfunction

  planes_t     low1_q, high1_q;
  pair_t [3:0] z_q;   // of s2 to s5
  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      low1_q  <= planes_of(box_i.x0, box_i.y0, box_i.z0, axis_i);
      high1_q <= planes_of(box_i.x1, box_i.y1, box_i.z1, axis_i);
    end
    if (en_i[1]) z_q[0] <= '{low: low1_q.z, high: high1_q.z};
    for (int unsigned i = 1; i < 4; i++) if (en_i[i+1]) z_q[i] <= z_q[i-1];
  end

  logic  x_none, y_none;
  tick_t x_low, x_high, y_low, y_high;
  slab_planes u_x (
    .clk_i, .en_i(en_i[4:1]), .q0_i(low1_q.x), .q1_i(high1_q.x),
    .mant_i(mant_i[0]), .more_i(more_i[0]), .minus_i(minus_i[0]), .low_i(low_i[0]), .high_i(high_i[0]), .left_i(left_i[0]),
    .none_o(x_none), .low_o(x_low), .high_o(x_high)
  );
  slab_planes u_y (
    .clk_i, .en_i(en_i[4:1]), .q0_i(low1_q.y), .q1_i(high1_q.y),
    .mant_i(mant_i[1]), .more_i(more_i[1]), .minus_i(minus_i[1]), .low_i(low_i[1]), .high_i(high_i[1]), .left_i(left_i[1]),
    .none_o(y_none), .low_o(y_low), .high_o(y_high)
  );

  always_ff @(posedge clk_i) begin
    if (en_i[5]) begin
      none_o <= x_none || y_none;
      low_o  <= later(later(x_low, y_low), tick_t'({z_q[3].low, {SubPlane{1'b0}}}));
      high_o <= sooner(sooner(x_high, y_high), tick_t'({z_q[3].high, {SubPlane{1'b0}}}));
    end
  end
endmodule
