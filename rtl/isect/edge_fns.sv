// SPDX-License-Identifier: Apache-2.0
// The three edge functions of a sheared triangle, and on which side of each edge the ray lies:
//   U = Cx By - Cy Bx    V = Ax Cy - Ay Cx    W = Bx Ay - By Ax     units of four square steps
//   s1-s3  the six products                      exact     12 DSPs
//   s4     U, V, W, each less one unless its up
// The sign of a zero is decided by moving the ray by (e, e^2): that of U is then the sign of
// Cy - By, or, where that is zero too, of Bx - Cx: corners are ranked by y, then by descending x,
// and U's sign says whether C ranks above B, u_up_o. An edge so belongs to exactly one of its
// triangles. What comes out, U less one unless u_up_o, is negative exactly if U's sign is.
// point_o: the three sheared corners coincide.
// One triangle a cycle, four cycles, never stalls; en_i[k]: stage k + 1 takes an item.
// A sphere uses the same multipliers and adders. Its sheared centre X, Y is in A's place and, for sphere_i
// (it belongs to s1), in B's as (Y, X); the shear Sx, Sy is in C's. sums_i belongs to s4: with
// it U and W are sums, X Sx + Y Sy and X^2 + Y^2, and V is X Sy - Y Sx. v_d_o is v_o a cycle earlier.
// Model: cpp_model/isect/edge_fns.hpp, equal bit for bit.
module edge_fns
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,

  input  logic [3:0]         en_i,
  input  sheared_t           ax_i,
  input  sheared_t           ay_i,
  input  sheared_t           bx_i,
  input  sheared_t           by_i,
  input  sheared_t           cx_i,
  input  sheared_t           cy_i,
  input  logic               sphere_i,
  input  shear_t             sx_i,
  input  shear_t             sy_i,
  input  logic               sums_i,

  output mul_sum_t             v_d_o,
  output mul_sum_t             u_o,
  output mul_sum_t             v_o,
  output mul_sum_t             w_o,
  output logic               u_up_o,
  output logic               v_up_o,
  output logic               w_up_o,
  output logic               point_o
);
  mul27_t ax, ay, bx, by, cx, cy;
  mul54_t p0, p1, p2, p3, p4, p5;
  assign ax = mul27_t'(ax_i);
  assign ay = mul27_t'(ay_i);
  assign bx = sphere_i ? ay : mul27_t'(bx_i);
  assign by = sphere_i ? ax : mul27_t'(by_i);
  assign cx = sphere_i ? mul27_t'(sx_i) : mul27_t'(cx_i);
  assign cy = sphere_i ? mul27_t'(sy_i) : mul27_t'(cy_i);
  mul27 u_p0 (.clk_i, .en_i(en_i[2:0]), .a_i(cx), .b_i(by), .p_o(p0));
  mul27 u_p1 (.clk_i, .en_i(en_i[2:0]), .a_i(cy), .b_i(bx), .p_o(p1));
  mul27 u_p2 (.clk_i, .en_i(en_i[2:0]), .a_i(ax), .b_i(cy), .p_o(p2));
  mul27 u_p3 (.clk_i, .en_i(en_i[2:0]), .a_i(ay), .b_i(cx), .p_o(p3));
  mul27 u_p4 (.clk_i, .en_i(en_i[2:0]), .a_i(ay), .b_i(bx), .p_o(p4));
  mul27 u_p5 (.clk_i, .en_i(en_i[2:0]), .a_i(ax), .b_i(by), .p_o(p5));

  // Does the first corner rank above the second?
  function automatic logic above(sheared_t x0, sheared_t y0, sheared_t x1, sheared_t y1);
    return {~y0[$bits(sheared_t)-1], y0[$bits(sheared_t)-2:0], x0[$bits(sheared_t)-1], ~x0[$bits(sheared_t)-2:0]}
         > {~y1[$bits(sheared_t)-1], y1[$bits(sheared_t)-2:0], x1[$bits(sheared_t)-1], ~x1[$bits(sheared_t)-2:0]};
  endfunction

  // p - q - !up, or p + q: one addition, with a carry into it.
  function automatic mul_sum_t fn(mul54_t p, mul54_t q, logic minus, logic up);
    logic [$bits(mul_sum_t):0] sum;
    sum = {mul_sum_t'(p), up} + {mul_sum_t'(q) ^ {$bits(mul_sum_t){minus}}, up};
    return sum[$bits(mul_sum_t):1];
  endfunction

  logic u_up1_q, v_up1_q, w_up1_q, u_up2_q, v_up2_q, w_up2_q, u_up3_q, v_up3_q, w_up3_q;

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      u_up1_q <= above(cx_i, cy_i, bx_i, by_i);
      v_up1_q <= above(ax_i, ay_i, cx_i, cy_i);
      w_up1_q <= above(bx_i, by_i, ax_i, ay_i);
    end
    if (en_i[1]) begin
      u_up2_q <= u_up1_q;
      v_up2_q <= v_up1_q;
      w_up2_q <= w_up1_q;
    end
    if (en_i[2]) begin
      u_up3_q <= u_up2_q;
      v_up3_q <= v_up2_q;
      w_up3_q <= w_up2_q;
    end
    if (en_i[3]) begin
      u_o     <= fn(p0, p1, !sums_i, !sums_i && u_up3_q);
      v_o     <= v_d_o;
      w_o     <= fn(p4, p5, !sums_i, !sums_i && w_up3_q);
      u_up_o  <= u_up3_q;
      v_up_o  <= v_up3_q;
      w_up_o  <= w_up3_q;
      point_o <= !(u_up3_q || v_up3_q || w_up3_q);
    end
  end
  assign v_d_o = fn(p2, p3, 1'b1, sums_i || v_up3_q);
endmodule
