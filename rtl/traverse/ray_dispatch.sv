// SPDX-License-Identifier: Apache-2.0
// Deals rays out to the lanes in turn, ray k of a batch to lane k mod Lanes, so that the first lane
// never has fewer than another (restart_i: a batch has ended). And knows when the source is
// exhausted: issued_i counts a ray from where it is promised (a pixel leaves the walk), so
// exhausted_o means that the walk has ended and no ray is still being set up.
// Combinational payload, one ray a cycle.
// Model: cpp_model/core.cpp, where the order of rays does not matter.
module ray_dispatch
  import castray_pkg::*;
#(
  parameter int unsigned Lanes = 3
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             restart_i,
  input  logic             issued_i,
  input  logic             walk_done_i,
  output logic             none_in_setup_o,
  output logic             exhausted_o,

  input  logic             in_valid_i,
  output logic             in_ready_o,

  output logic [Lanes-1:0] out_valid_o,
  input  logic [Lanes-1:0] out_ready_i
);
  localparam int unsigned LaneW = (Lanes > 1) ? $clog2(Lanes) : 1;

  logic [LaneW-1:0] next_q;
  logic [15:0]      under_way_q;
  logic             taken;

  always_comb begin
    out_valid_o         = '0;
    out_valid_o[next_q] = in_valid_i;
  end
  assign in_ready_o = out_ready_i[next_q];
  assign taken      = in_valid_i && in_ready_o;
  assign none_in_setup_o = under_way_q == '0;
  assign exhausted_o     = walk_done_i && none_in_setup_o;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      next_q      <= '0;
      under_way_q <= '0;
    end else begin
      if (restart_i) next_q <= '0;
      else if (taken) next_q <= (next_q == LaneW'(Lanes - 1)) ? '0 : next_q + 1'b1;
      if (issued_i != taken) under_way_q <= issued_i ? under_way_q + 1'b1 : under_way_q - 1'b1;
    end
  end
endmodule
