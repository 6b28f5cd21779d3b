// SPDX-License-Identifier: Apache-2.0
// p = a * b, signed 27 x 27 bits, exact: two DSPs, 27 x 18 and 27 x 10, split by hand because
// synthesis would take four.
//   s1  a, b                                     the DSPs' A and B registers
//   s2  a * b[16:0], a * b[26:17]                M
//   s3  low + 2^17 high                          P
// One product a cycle, three cycles, never stalls. en_i[k] says that stage k + 1 takes an item in
// this cycle: the parent, which has a valid bit for each stage, serves any number of multipliers.
// Model: int64 multiplication.
module mul27 (
  input  logic               clk_i,

  input  logic [2:0]         en_i,
  input  logic signed [26:0] a_i,
  input  logic signed [26:0] b_i,
  output logic signed [53:0] p_o
);
  logic signed [26:0] a_q, b_q;
  logic signed [44:0] low_q;
  logic signed [36:0] high_q;

  // The lower half of b is unsigned: its sign bit is zero.
  function automatic logic signed [44:0] mul_low(logic signed [26:0] a, logic [16:0] b);
    logic signed [17:0] b_low;
    b_low = {1'b0, b};
    return a * b_low;
  endfunction
  function automatic logic signed [36:0] mul_high(logic signed [26:0] a, logic signed [9:0] b);
    return a * b;
  endfunction

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      a_q <= a_i;
      b_q <= b_i;
    end
    if (en_i[1]) begin
      low_q  <= mul_low(a_q, b_q[16:0]);
      high_q <= mul_high(a_q, b_q[26:17]);
    end
    if (en_i[2]) p_o <= 54'(low_q) + (54'(high_q) <<< 17);
  end
endmodule
