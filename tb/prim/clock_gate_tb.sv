// SPDX-License-Identifier: Apache-2.0
// Three gates side by side, each with a counter of its clock's edges.
module clock_gate_tb #(
  parameter int unsigned Settle = 3
) (
  input  logic             clk_i,
  input  logic             awake_i,
  output logic [2:0][31:0] edges_o   // through, gated, gated and settling
);
  logic [2:0]       clk;
  clock_gate #(.Gated(1'b0)) u_through (.clk_i, .awake_i, .clk_o(clk[0]));
  clock_gate #(.Gated(1'b1)) u_gated (.clk_i, .awake_i, .clk_o(clk[1]));
  clock_gate #(.Gated(1'b1), .Settle(Settle)) u_settling (.clk_i, .awake_i, .clk_o(clk[2]));
  for (genvar i = 0; i < 3; i++) begin : g_count
    logic [31:0] count_q = '0;
    always_ff @(posedge clk[i]) count_q <= count_q + 1;
    assign edges_o[i] = count_q;
  end
endmodule
