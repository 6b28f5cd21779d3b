// SPDX-License-Identifier: Apache-2.0
// p = a times guess, unsigned, W x RecipW bits, exact: one multiplier of 27x18, or two where a_i has more than 26 bits.
//   s1  low = a's lower bits times guess, high = its upper 26 times guess      M
//   s2  p = low + 2^(W-26) high
// One product a cycle, two cycles, never stalls; en_i[k]: stage k + 1 takes an item. The operands come from registers.
// Model: uint64 multiplication.
module mul_guess
  import castray_cfg_pkg::*;
#(
  parameter int unsigned W = 26
) (
  input  logic                clk_i,

  input  logic [1:0]          en_i,
  input  logic [W-1:0]        a_i,
  input  logic [RecipW-1:0]   guess_i,
  output logic [W+RecipW-1:0] p_o
);
  localparam int unsigned LowW = (W > DspAW - 1) ? W - (DspAW - 1) : 0;
  logic [W-LowW+RecipW-1:0] high_q;

  always_ff @(posedge clk_i) begin
    if (en_i[0]) high_q <= a_i[W-1:LowW] * guess_i;
  end
  if (LowW == 0) begin : g_one
    always_ff @(posedge clk_i) begin
      if (en_i[1]) p_o <= high_q;
    end
  end else begin : g_two
    logic [LowW+RecipW-1:0] low_q;
    always_ff @(posedge clk_i) begin
      if (en_i[0]) low_q <= a_i[LowW-1:0] * guess_i;
      if (en_i[1]) p_o <= {high_q, LowW'(0)} + (W + RecipW)'(low_q);
    end
  end
endmodule
