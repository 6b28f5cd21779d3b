// SPDX-License-Identifier: Apache-2.0
// A corner moved along the ray onto the plane z = 0, in units of two steps:
//   x' = (x - sx z) / 2,  y' = (y - sy z) / 2      to the nearest integer, halves upwards
//   s1-s3  sx z, sy z        exact                 4 DSPs
//   s4     x', y'            27 bits: |x - sx z| < 2^27 steps
// One corner a cycle, four cycles, never stalls; en_i[k]: stage k + 1 takes an item.
// px_o is the product of s3, for who uses this multiplier otherwise.
// Model: cpp_model/isect/shear.hpp, equal bit for bit.
module shear
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic               clk_i,

  input  logic [3:0]         en_i,
  input  delta_t             x_i,
  input  delta_t             y_i,
  input  delta_t             z_i,
  input  shear_t             sx_i,
  input  shear_t             sy_i,
  output sheared_t           x_o,
  output sheared_t           y_o,
  output logic signed [53:0] px_o
);
  if (CoordW != 26 || ShearFrac != 26) begin : g_check
    $error("shear: the multipliers are made for 26-bit coordinates and shears");
  end

  delta_t             x1_q, x2_q, x3_q, y1_q, y2_q, y3_q;
  logic signed [53:0] py;

  mul27 u_x (.clk_i, .en_i(en_i[2:0]), .a_i(z_i), .b_i(sx_i), .p_o(px_o));
  mul27 u_y (.clk_i, .en_i(en_i[2:0]), .a_i(z_i), .b_i(sy_i), .p_o(py));

  // The only place where precision is lost: half a unit of two steps.
  function automatic sheared_t round_half(delta_t x, logic signed [53:0] product);
    return sheared_t'(((54'(x) <<< ShearFrac) - product + (54'sd1 <<< ShearFrac)) >>> (ShearFrac + 1));
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      x1_q <= x_i;
      y1_q <= y_i;
    end
    if (en_i[1]) begin
      x2_q <= x1_q;
      y2_q <= y1_q;
    end
    if (en_i[2]) begin
      x3_q <= x2_q;
      y3_q <= y2_q;
    end
    if (en_i[3]) begin
      x_o <= round_half(x3_q, px_o);
      y_o <= round_half(y3_q, py);
    end
  end
endmodule
