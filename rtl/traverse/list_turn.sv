// SPDX-License-Identifier: Apache-2.0
// Which lane the rays of a list go to: runs of Run rays to the lanes in turn, so that neighbours share
// what a lane's caches hold.
// Model: cpp_model/ray_list.cpp, where no lane exists.
module list_turn
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Lanes = DefaultLanes,
  parameter int unsigned Run   = 16             // a power of two
) (
  input  logic     clk_i,
  input  logic     rst_ni,

  input  logic     taken_i,   // a ray goes to lane_o
  output lane_no_t lane_o
);
  localparam int unsigned RunW = $clog2(Run);
  logic [RunW-1:0] ray_q;     // of the run
  lane_no_t        lane_q;
  assign lane_o = lane_q;

  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      ray_q  <= '0;
      lane_q <= '0;
    end else if (taken_i) begin
      ray_q <= ray_q + 1'b1;
      if (ray_q == '1) lane_q <= (lane_q == lane_no_t'(Lanes - 1)) ? '0 : lane_q + 1'b1;
    end
  end
endmodule
