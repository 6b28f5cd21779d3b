// SPDX-License-Identifier: Apache-2.0
// clock_wake with its clocks gated, and the edges of each: tree, camera, shading.
module clock_wake_tb #(
  parameter int unsigned Streams = 3,
  parameter int unsigned Settle  = 5
) (
  input  logic               clk_i,
  input  logic               rst_ni,
  input  logic               brute_i,
  input  logic [Streams-1:0] camera_valid_i,
  input  logic [Streams-1:0] camera_ready_i,
  input  logic [Streams-1:0] shading_valid_i,
  input  logic [Streams-1:0] shading_ready_i,
  output logic [2:0][31:0]   edges_o
);
  logic [2:0] clk;
  clock_wake #(.GateClocks(1'b1), .CameraStreams(Streams), .ShadingStreams(Streams), .Settle(Settle)) u_dut (
    .clk_i, .rst_ni, .brute_i, .camera_valid_i, .camera_ready_i, .shading_valid_i, .shading_ready_i,
    .tree_clk_o(clk[0]), .camera_clk_o(clk[1]), .shading_clk_o(clk[2])
  );
  for (genvar i = 0; i < 3; i++) begin : g_edges
    logic [31:0] count_q = '0;
    always_ff @(posedge clk[i]) count_q <= count_q + 1;
    assign edges_o[i] = count_q;
  end
endmodule
