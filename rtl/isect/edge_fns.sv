// SPDX-License-Identifier: Apache-2.0
// The three edge functions of a sheared triangle, and on which side of each edge the ray lies:
//   U = Cx By - Cy Bx    V = Ax Cy - Ay Cx    W = Bx Ay - By Ax     units of four square steps
//   s1-s3  the six products   exact              12 DSPs
//   s4     U, V, W            exact; their signs
// The sign of a zero is decided by moving the ray by (e, e^2): that of U is then the sign of
// Cy - By, or, where that is zero too, of Bx - Cx: corners are ranked by y, then by descending x,
// and U's sign says whether C ranks above B. An edge so belongs to exactly one of its triangles.
// point_o: the three sheared corners coincide.
// One triangle a cycle, four cycles, never stalls; en_i[k]: stage k + 1 takes an item, fns_en_i:
// the last one takes a triangle.
// A sphere uses the same multipliers (sphere_i): its sheared centre X, Y is in A's place, and
// p0..p5, the products of s3, are X X, N R, X Sx, Y Sx, Y Y, X Sy: see sphere_disc.
// Model: cpp_model/isect/edge_fns.hpp, equal bit for bit.
module edge_fns
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,

  input  logic [2:0]         en_i,
  input  logic               fns_en_i,
  input  sheared_t           ax_i,
  input  sheared_t           ay_i,
  input  sheared_t           bx_i,
  input  sheared_t           by_i,
  input  sheared_t           cx_i,
  input  sheared_t           cy_i,
  input  logic               sphere_i,
  input  shear_t             sx_i,
  input  shear_t             sy_i,
  input  delta_t             reach_i,
  input  delta_t             radius_i,

  output mul54_t p0_o,
  output mul54_t p1_o,
  output mul54_t p2_o,
  output mul54_t p3_o,
  output mul54_t p4_o,
  output mul54_t p5_o,

  output edge_fn_t           u_o,
  output edge_fn_t           v_o,
  output edge_fn_t           w_o,
  output logic               u_neg_o,
  output logic               v_neg_o,
  output logic               w_neg_o,
  output logic               point_o
);
  mul27 u_p0 (.clk_i, .en_i, .a_i(sphere_i ? mul27_t'(ax_i) : mul27_t'(cx_i)), .b_i(sphere_i ? mul27_t'(ax_i) : mul27_t'(by_i)), .p_o(p0_o));
  mul27 u_p1 (.clk_i, .en_i, .a_i(sphere_i ? mul27_t'(reach_i) : mul27_t'(cy_i)), .b_i(sphere_i ? mul27_t'(radius_i) : mul27_t'(bx_i)), .p_o(p1_o));
  mul27 u_p2 (.clk_i, .en_i, .a_i(mul27_t'(ax_i)), .b_i(sphere_i ? mul27_t'(sx_i) : mul27_t'(cy_i)), .p_o(p2_o));
  mul27 u_p3 (.clk_i, .en_i, .a_i(mul27_t'(ay_i)), .b_i(sphere_i ? mul27_t'(sx_i) : mul27_t'(cx_i)), .p_o(p3_o));
  mul27 u_p4 (.clk_i, .en_i, .a_i(mul27_t'(ay_i)), .b_i(sphere_i ? mul27_t'(ay_i) : mul27_t'(bx_i)), .p_o(p4_o));
  mul27 u_p5 (.clk_i, .en_i, .a_i(mul27_t'(ax_i)), .b_i(sphere_i ? mul27_t'(sy_i) : mul27_t'(by_i)), .p_o(p5_o));

  // A product of two sheared coordinates; a sphere's others are up to 54 bits.
  typedef logic signed [2*CoordW+1:0] product_t;

  // Does the first corner rank above the second?
  function automatic logic above(sheared_t x0, sheared_t y0, sheared_t x1, sheared_t y1);
    return {~y0[$bits(sheared_t)-1], y0[$bits(sheared_t)-2:0], x0[$bits(sheared_t)-1], ~x0[$bits(sheared_t)-2:0]}
         > {~y1[$bits(sheared_t)-1], y1[$bits(sheared_t)-2:0], x1[$bits(sheared_t)-1], ~x1[$bits(sheared_t)-2:0]};
  endfunction

  // Is p - q negative, a zero taken as the sign says? The sign of p - q, or of p - q - 1.
  function automatic logic negative(product_t p, product_t q, logic up);
    logic [2*CoordW+3:0] sum;
    sum = {p[2*CoordW+1], p, 1'b1} + {~q[2*CoordW+1], ~q, up};
    return sum[2*CoordW+3];
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
    if (fns_en_i) begin
      u_o     <= edge_fn_t'(p0_o) - edge_fn_t'(p1_o);
      v_o     <= edge_fn_t'(p2_o) - edge_fn_t'(p3_o);
      w_o     <= edge_fn_t'(p4_o) - edge_fn_t'(p5_o);
      u_neg_o <= negative(product_t'(p0_o), product_t'(p1_o), u_up3_q);
      v_neg_o <= negative(product_t'(p2_o), product_t'(p3_o), v_up3_q);
      w_neg_o <= negative(product_t'(p4_o), product_t'(p5_o), w_up3_q);
      point_o <= !(u_up3_q || v_up3_q || w_up3_q);
    end
  end
endmodule
