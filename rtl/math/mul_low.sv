// SPDX-License-Identifier: Apache-2.0
// p = the lower OutW bits of a b, unsigned, in parts:
//   s1  low  = a's lower 17 bits times b's lower 26
//       high = a's upper bits times b, rest = a's lower 17 bits times b's upper ones; both no longer than OutW asks for
//   s2  p = low + 2^17 high + 2^26 rest
// A part is a multiplier of 27x18; high is two where OutW is more than 43 and b more than 26 bits. No rest for a b of up to 26.
// One product a cycle, two cycles, never stalls; en_i[k]: stage k + 1 takes an item. The operands come from registers.
// AW and OutW are at least 18. Model: uint64 multiplication.
module mul_low
  import castray_cfg_pkg::*;
#(
  parameter int unsigned AW   = 26,
  parameter int unsigned BW   = 26,
  parameter int unsigned OutW = 28
) (
  input  logic            clk_i,

  input  logic [1:0]      en_i,
  input  logic [AW-1:0]   a_i,
  input  logic [BW-1:0]   b_i,
  output logic [OutW-1:0] p_o
);
  localparam int unsigned LowW   = DspBW - 1;
  localparam int unsigned WideW  = DspAW - 1;
  localparam int unsigned HighW  = OutW - LowW;                       // bits of high that count
  localparam int unsigned HighBW = (BW < HighW) ? BW : HighW;
  localparam int unsigned LowBW  = (BW < WideW) ? BW : WideW;
  if (AW <= LowW || OutW <= LowW) begin : g_width
    $error("mul_low: AW and OutW must be more than %0d", LowW);
  end
  logic [OutW-1:0]  low_q;
  logic [HighW-1:0] high_q;

  always_ff @(posedge clk_i) begin
    if (en_i[0]) begin
      low_q  <= OutW'(a_i[LowW-1:0] * b_i[LowBW-1:0]);
      high_q <= HighW'(a_i[AW-1:LowW] * b_i[HighBW-1:0]);
    end
  end
  if (BW <= WideW || OutW <= WideW) begin : g_two
    always_ff @(posedge clk_i) begin
      if (en_i[1]) p_o <= low_q + {high_q, LowW'(0)};
    end
  end else begin : g_three
    localparam int unsigned RestW  = OutW - WideW;
    localparam int unsigned RestAW = (LowW < RestW) ? LowW : RestW;
    logic [RestW-1:0] rest_q;
    always_ff @(posedge clk_i) begin
      if (en_i[0]) rest_q <= RestW'(a_i[RestAW-1:0] * b_i[BW-1:WideW]);
      if (en_i[1]) p_o <= low_q + {high_q, LowW'(0)} + {rest_q, WideW'(0)};
    end
  end
endmodule
