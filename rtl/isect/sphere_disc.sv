// SPDX-License-Identifier: Apache-2.0
// Does the ray's line meet the sphere? X, Y: the sheared centre; R: the radius; N: |S|^2 R, of
// which R is in steps, N in units of two. Sums of products of X, Y, Sx, Sy are edge_fns'.
//   s1-s3  N R                           exact, 2 DSPs
//   s4     Z = X Sy - Y Sx               nearest, units of two steps; below 2^CoordW, because the
//                                        sheared z cancels: it is (x Sy - y Sx) / 2
//   s5     towards = X Sx + Y Sy         nearest, quarter steps
//          rest = N R - 2 (X^2 + Y^2)    exact, units of two square steps
//   s4-s6  Z^2                           exact, 2 DSPs
//   s7     disc = rest - 2 Z^2           met if not negative
// One sphere a cycle, seven cycles, never stalls. en_i[k]: stage k + 1 takes a sphere. cross_i is of s4,
// along_i and square_i are of s5.
// Model: cpp_model/isect/sphere_disc.hpp, equal bit for bit.
module sphere_disc
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,
  input  logic               rst_ni,

  input  logic [3:0]         en_i,
  input  sheared_t           reach_i,    // N
  input  delta_t             radius_i,
  input  mul_sum_t             cross_i,    // X Sy - Y Sx
  input  mul_sum_t             along_i,    // X Sx + Y Sy
  input  mul_sum_t             square_i,   // X^2 + Y^2

  output logic               valid_o,
  output det_t               disc_o,
  output towards_t           towards_o
);
  mul54_t p_nr, p_zz;

  mul27 u_nr (.clk_i, .en_i(en_i[2:0]), .a_i(mul27_t'(reach_i)), .b_i(mul27_t'(radius_i)), .p_o(p_nr));

  // To the nearest, halves upwards: the bit behind the last one that stays is added.
  function automatic sheared_t round_z(mul_sum_t sum);
    return sheared_t'(sum >>> ShearFrac) + sheared_t'({1'b0, sum[ShearFrac-1]});
  endfunction
  function automatic towards_t round_towards(mul_sum_t sum);
    return towards_t'(sum >>> (ShearFrac - 3)) + towards_t'({1'b0, sum[ShearFrac-4]});
  endfunction

  typedef logic signed [$bits(det_t)-1:0] disc_t;

  logic               valid4_q, valid5_q, valid6_q, valid7_q;
  mul54_t             nr4_q;
  disc_t              rest5_q, rest6_q, disc7_q;
  towards_t           towards5_q, towards6_q;

  sheared_t z;
  assign z = round_z(cross_i);

  mul27 u_zz (.clk_i, .en_i({valid5_q, valid4_q, en_i[3]}), .a_i(mul27_t'(z)), .b_i(mul27_t'(z)), .p_o(p_zz));

  assign valid_o = valid7_q && !disc7_q[$bits(det_t)-1];
  assign disc_o  = disc7_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      valid4_q <= 1'b0;
      valid5_q <= 1'b0;
      valid6_q <= 1'b0;
      valid7_q <= 1'b0;
    end else begin
      valid4_q <= en_i[3];
      valid5_q <= valid4_q;
      valid6_q <= valid5_q;
      valid7_q <= valid6_q;
    end
  end

  always_ff @(posedge clk_i) begin
    if (en_i[3]) nr4_q <= p_nr;
    if (valid4_q) begin
      rest5_q    <= disc_t'(nr4_q) - (disc_t'(square_i) <<< 1);
      towards5_q <= round_towards(along_i);
    end
    if (valid5_q) begin
      rest6_q    <= rest5_q;
      towards6_q <= towards5_q;
    end
    if (valid6_q) begin
      disc7_q   <= rest6_q - (disc_t'(p_zz) <<< 1);
      towards_o <= towards6_q;
    end
  end
endmodule
