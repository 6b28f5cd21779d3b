// SPDX-License-Identifier: Apache-2.0
// Deals tiles out to the lanes, all rays of a tile to one lane, so that they share what its caches
// hold: to the next lane in turn whose queue has room for a whole tile. A lane's room is counted here:
// taken by tiles, given back by rays that leave its queue (left_i).
//   TileEmpty   to no lane: filled with background as a whole, or with each_miss_i pixel by pixel
//   direct_i    to no lane in particular, and all start at the root
// What is dealt is told once, in the cycle in which the tile is taken: deal_*.
// Combinational; one tile a cycle.
module tile_deal
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Lanes    = DefaultLanes,
  parameter int unsigned TileLog2 = DefaultTileLog2
) (
  input  logic             clk_i,
  input  logic             rst_ni,

  input  logic             direct_i,     // these stand still
  input  logic             each_miss_i,

  input  logic             in_valid_i,
  output logic             in_ready_o,
  input  started_t         in_i,

  output logic             pixels_valid_o,
  input  logic             pixels_ready_i,
  output logic             miss_o,       // its pixels meet nothing

  output logic             fill_valid_o,
  input  logic             fill_ready_i,

  output logic             deal_valid_o,
  output lane_no_t         deal_lane_o,

  input  logic [Lanes-1:0] left_i
);
  localparam int unsigned Depth = ray_queue(TileLog2);
  localparam int unsigned CntW  = $clog2(Depth + 1);

  // ---- Room ----
  logic [CntW-1:0]  held_q [Lanes];
  logic [Lanes-1:0] room, chosen;
  lane_no_t         next_q, lane;
  logic             any, empty, deal;
  logic [CntW-1:0]  rays;
  assign rays = CntW'(in_i.tile.width) * CntW'(in_i.tile.height);
  for (genvar i = 0; i < Lanes; i++) begin : g_lane
    assign room[i]   = held_q[i] <= CntW'(Depth - (1 << (2 * TileLog2)));
    assign chosen[i] = lane == lane_no_t'(i);
    always_ff @(posedge clk_i) begin
      if (!rst_ni) held_q[i] <= '0;
      else if (left_i[i] || (deal && chosen[i]))
        held_q[i] <= held_q[i] + ((deal && chosen[i]) ? rays : '0) - CntW'(left_i[i]);
    end
  end
  always_comb begin
    any  = 1'b0;
    lane = next_q;
    for (int unsigned i = 0; i < Lanes; i++) begin
      if (!any) begin
        lane = lane_no_t'((32'(next_q) + i >= Lanes) ? 32'(next_q) + i - Lanes : 32'(next_q) + i);
        any  = |(room & (Lanes'(1) << lane));
      end
    end
  end

  // ---- Where the tile goes ----
  logic to_lane, to_pixels;
  assign empty     = in_i.start == TileEmpty && !direct_i;
  assign to_lane   = !empty && !direct_i;
  assign to_pixels = empty ? each_miss_i : (direct_i || any);
  assign pixels_valid_o = in_valid_i && to_pixels;
  assign fill_valid_o   = in_valid_i && empty && !each_miss_i;
  assign miss_o         = empty;
  assign in_ready_o     = (to_pixels && pixels_ready_i) || (empty && !each_miss_i && fill_ready_i);
  assign deal           = in_valid_i && in_ready_o && to_lane;
  assign deal_valid_o   = deal;
  assign deal_lane_o    = lane;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) next_q <= '0;
    else if (deal) next_q <= (lane == lane_no_t'(Lanes - 1)) ? '0 : lane + 1'b1;
  end
endmodule
