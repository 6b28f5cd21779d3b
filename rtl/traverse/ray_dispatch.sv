// SPDX-License-Identifier: Apache-2.0
// Deals rays out to the lanes in turn, ray k of a batch to lane k mod Lanes, so that the first lane
// never has fewer than another (restart_i: a batch ends with the rays that came).
// Only the handshake passes here, combinational, one ray a cycle.
// Model: cpp_model/core.cpp, where the order of rays does not matter.
module ray_dispatch
  import castray_cfg_pkg::*;
#(
  parameter int unsigned Lanes = DefaultLanes
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             restart_i,

  input  logic             in_valid_i,
  output logic             in_ready_o,

  output logic [Lanes-1:0] out_valid_o,
  input  logic [Lanes-1:0] out_ready_i
);
  localparam int unsigned LaneW = (Lanes > 1) ? $clog2(Lanes) : 1;

  logic [LaneW-1:0] next_q;

  always_comb begin
    out_valid_o         = '0;
    out_valid_o[next_q] = in_valid_i;
  end
  assign in_ready_o = out_ready_i[next_q];

  always_ff @(posedge clk_i) begin
    if (!rst_ni || restart_i) next_q <= '0;
    else if (in_valid_i && in_ready_o) next_q <= (next_q == LaneW'(Lanes - 1)) ? '0 : next_q + 1'b1;
  end
endmodule
