// SPDX-License-Identifier: Apache-2.0
// A clock that stands still while the units behind it rest. It changes no result and no cycle: a
// simulator spends as much time on a unit at rest as on one at work, unless its clock rests too.
//
//   Gated = 0   clk_o is clk_i: hardware
//   Gated = 1   clk_o runs in each cycle with awake_i, and in the Settle cycles after it
//
// awake_i is high in reset, and in each cycle in which something passes the border of these units;
// they change nothing once nothing has passed for Settle cycles. In gated simulations only: an FPGA
// would need a clock buffer here.
module clock_gate #(
  parameter bit          Gated  = 1'b0,
  parameter int unsigned Settle = 0
) (
  input  logic clk_i,
  input  logic awake_i,
  output logic clk_o
);
  if (!Gated) begin : g_through
    assign clk_o = clk_i;
  end else begin : g_gate
    logic runs, enable;

    if (Settle == 0) begin : g_now
      assign runs = awake_i;
    end else begin : g_settle
      localparam int unsigned CntW = $clog2(Settle + 1);
      logic [CntW-1:0] left_q;
      always_ff @(posedge clk_i) begin
        if (awake_i) left_q <= CntW'(Settle);
        else if (left_q != '0) left_q <= left_q - 1'b1;
      end
      assign runs = awake_i || left_q != '0;
    end

    always_latch if (!clk_i) enable = runs;   // taken over while the clock is low: no glitch
    assign clk_o = clk_i && enable;
  end
endmodule
