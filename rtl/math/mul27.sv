// SPDX-License-Identifier: Apache-2.0
// p = a * b, signed 27 x 27 bits, exact, two DSPs.
//   s1, s2  the parts                            mul27_parts
//   s3      p = low + 2^17 high                  the DSPs' P register
// One product a cycle, three cycles, never stalls. en_i[k] says that stage k + 1 takes an item in
// this cycle: the parent, which has a valid bit for each stage, serves any number of multipliers.
// Model: int64 multiplication.
module mul27
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic       clk_i,

  input  logic [2:0] en_i,
  input  mul27_t     a_i,
  input  mul27_t     b_i,
  output mul54_t     p_o
);
  mul_part_t low, high;

  mul27_parts u_parts (.clk_i, .en_i(en_i[1:0]), .a_i, .b_i, .low_o(low), .high_o(high));

  always_ff @(posedge clk_i) begin
    if (en_i[2]) p_o <= mul54_t'(low + (high <<< (DspBW - 1)));
  end
endmodule
