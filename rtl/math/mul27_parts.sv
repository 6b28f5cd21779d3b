// SPDX-License-Identifier: Apache-2.0
// a * b = low + 2^17 high, signed 27 x 27 bits, exact: two DSPs, 27 x 18 and 27 x 10, split by
// hand so that no tool takes more. What adds the parts belongs to the third stage, the DSPs' P.
//   s1  a, b                                     the DSPs' A and B registers
//   s2  low = a b[16:0], high = a b[26:17]       M
// One product a cycle, never stalls; en_i[k]: stage k + 1 takes an item.
// The parts need 45 and 37 bits; the rest are copies of the sign, which synthesis merges and which
// save a simulator from cutting and extending them.
// Model: int64 multiplication.
module mul27_parts
  import castray_cfg_pkg::*, castray_pkg::*;
(
  input  logic       clk_i,

  input  logic [1:0] en_i,
  input  mul27_t     a_i,
  input  mul27_t     b_i,
  output mul_part_t  low_o,
  output mul_part_t  high_o
);
  localparam int unsigned LowW = DspBW - 1;
  mul27_t a_q, b_q;

  // The lower half of b is unsigned: its sign bit is zero.
  function automatic mul_part_t mul_low(mul27_t a, logic [LowW-1:0] b);
    logic signed [LowW:0] b_low;
    b_low = {1'b0, b};
    return a * b_low;
  endfunction
  function automatic mul_part_t mul_high(mul27_t a, logic signed [DspAW-LowW-1:0] b);
    return a * b;
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      a_q <= a_i;
      b_q <= b_i;
    end
    if (en_i[1]) begin
      low_o  <= mul_low(a_q, b_q[LowW-1:0]);
      high_o <= mul_high(a_q, b_q[DspAW-1:LowW]);
    end
  end
endmodule
