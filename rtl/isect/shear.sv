// SPDX-License-Identifier: Apache-2.0
// A corner moved along the ray onto the plane z = 0, in units of two steps:
//   x' = (x - sx z) / 2,  y' = (y - sy z) / 2      to the nearest integer, halves upwards
// from z turned back, -z: so nothing but floors follow the products. x and y come complemented, as
// corner_delta has them at least cost.
//   s1, s2  the parts of sx -z, sy -z  exact        4 DSPs
//   s3      x', y'                     CoordW + 1 bits: |x - sx z| < 2^(CoordW+1) steps
// One corner a cycle, three cycles, never stalls; en_i[k]: stage k + 1 takes an item.
// Model: cpp_model/isect/shear.hpp, equal bit for bit.
module shear
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic       clk_i,

  input  logic [2:0] en_i,
  input  delta_t     not_x_i,    // ~x
  input  delta_t     not_y_i,
  input  delta_t     back_z_i,   // -z
  input  shear_t     sx_i,
  input  shear_t     sy_i,
  output sheared_t   x_o,
  output sheared_t   y_o
);
  if (CoordW >= DspAW || ShearFrac >= DspAW) begin : g_check
    $error("shear: CoordW and ShearFrac must be below %0d, the multipliers' operands", DspAW);
  end

  delta_t             not_x1_q, not_x2_q, not_y1_q, not_y2_q;
  mul_part_t          low_x, high_x, low_y, high_y;

  mul27_parts u_x (.clk_i, .en_i(en_i[1:0]), .a_i(mul27_t'(back_z_i)), .b_i(mul27_t'(sx_i)), .low_o(low_x), .high_o(high_x));
  mul27_parts u_y (.clk_i, .en_i(en_i[1:0]), .a_i(mul27_t'(back_z_i)), .b_i(mul27_t'(sy_i)), .low_o(low_y), .high_o(high_y));

  // The only place where precision is lost: half a unit of two steps. What of a product is below a step, and
  // what of its lower part is below the upper one's last bit, falls away at once.
  localparam int unsigned HighBit = DspBW - 1;
  localparam int unsigned Cut     = (ShearFrac < HighBit) ? ShearFrac : HighBit;
  function automatic sheared_t round_half(delta_t not_x, mul_part_t low, mul_part_t high);
    logic signed [2*DspAW-1-Cut:0] product;
    logic signed [CoordW+1:0]      steps, twice;
    product = (2 * DspAW - Cut)'(low >>> Cut) + (2 * DspAW - Cut)'(high <<< (HighBit - Cut));
    steps   = (CoordW + 2)'(product >>> (ShearFrac - Cut));
    twice   = steps - (CoordW + 2)'(not_x);   // x + steps + 1
    return sheared_t'(twice >>> 1);
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      not_x1_q <= not_x_i;
      not_y1_q <= not_y_i;
    end
    if (en_i[1]) begin
      not_x2_q <= not_x1_q;
      not_y2_q <= not_y1_q;
    end
    if (en_i[2]) begin
      x_o <= round_half(not_x2_q, low_x, high_x);
      y_o <= round_half(not_y2_q, low_y, high_y);
    end
  end
endmodule
