// SPDX-License-Identifier: Apache-2.0
// a * b = low + 2^17 high, signed 27 x 27 bits, exact: two DSPs, 27 x 18 and 27 x 10, split by
// hand so that no tool takes more. What adds the parts belongs to the third stage, the DSPs' P.
//   s1  a, b                                     the DSPs' A and B registers
//   s2  low = a b[16:0], high = a b[26:17]       M
// One product a cycle, never stalls; en_i[k]: stage k + 1 takes an item.
// The parts need 45 and 37 bits; the rest are copies of the sign, which synthesis merges and which
// save a simulator from cutting and extending them.
// Model: int64 multiplication.
module mul27_parts (
  input  logic               clk_i,

  input  logic [1:0]         en_i,
  input  logic signed [26:0] a_i,
  input  logic signed [26:0] b_i,
  output logic signed [63:0] low_o,
  output logic signed [63:0] high_o
);
  logic signed [26:0] a_q, b_q;

  // The lower half of b is unsigned: its sign bit is zero.
  function automatic logic signed [63:0] mul_low(logic signed [26:0] a, logic [16:0] b);
    logic signed [17:0] b_low;
    b_low = {1'b0, b};
    return a * b_low;
  endfunction
  function automatic logic signed [63:0] mul_high(logic signed [26:0] a, logic signed [9:0] b);
    return a * b;
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      a_q <= a_i;
      b_q <= b_i;
    end
    if (en_i[1]) begin
      low_o  <= mul_low(a_q, b_q[16:0]);
      high_o <= mul_high(a_q, b_q[26:17]);
    end
  end
endmodule
