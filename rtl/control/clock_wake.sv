// SPDX-License-Identifier: Apache-2.0
// The clocks of what rests by brute force: the caches always, camera and shading between the rays.
// Of the streams that pass the border of camera and shading it sees the handshakes: an item that passes
// wakes them, and they run Settle cycles more. In the hierarchy, and in reset, everything runs.
// With GateClocks 0 the three are clk_i.
module clock_wake #(
  parameter bit          GateClocks     = 1'b0,
  parameter int unsigned CameraStreams  = 7,
  parameter int unsigned ShadingStreams = 7,
  parameter int unsigned Settle         = 4095   // more cycles than what is inside them takes to come to rest
) (
  input  logic                      clk_i,
  input  logic                      rst_ni,
  input  logic                      brute_i,

  input  logic [CameraStreams-1:0]  camera_valid_i,
  input  logic [CameraStreams-1:0]  camera_ready_i,
  input  logic [ShadingStreams-1:0] shading_valid_i,
  input  logic [ShadingStreams-1:0] shading_ready_i,

  output logic                      tree_clk_o,
  output logic                      camera_clk_o,
  output logic                      shading_clk_o
);
  logic all_awake, camera_moves, shading_moves;
  assign all_awake     = !rst_ni || !brute_i;
  assign camera_moves  = (camera_valid_i & camera_ready_i) != '0;
  assign shading_moves = (shading_valid_i & shading_ready_i) != '0;

  clock_gate #(.Gated(GateClocks)) u_tree (.clk_i, .awake_i(all_awake), .clk_o(tree_clk_o));
  clock_gate #(.Gated(GateClocks), .Settle(Settle)) u_camera (
    .clk_i, .awake_i(all_awake || camera_moves), .clk_o(camera_clk_o)
  );
  clock_gate #(.Gated(GateClocks), .Settle(Settle)) u_shading (
    .clk_i, .awake_i(all_awake || shading_moves), .clk_o(shading_clk_o)
  );
endmodule
