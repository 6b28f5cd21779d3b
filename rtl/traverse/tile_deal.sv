// SPDX-License-Identifier: Apache-2.0
// Deals tiles out to the lanes, all rays of a tile to one lane, so that they share what its caches
// hold. DealTiles tiles wait here, so that those whose start is sought quickly make up for others:
//   in -+-> queue -> the next lane in turn whose queue of rays has run low
//       +-> TileEmpty: filled with background as a whole, ahead of those that wait
// A tile's rays take as long through the setup as Low rays take a lane; that those that are left do
// not all fit its queue holds up the setup for a while and nothing else. The rays of each lane are
// counted here: taken by tiles, given back by rays that leave its queue (left_i).
//   each_miss_i  an empty tile gives its pixels, to no lane
//   direct_i     tiles go to no lane in particular, and all start at the root
// What is dealt is told once, in the cycle in which the tile leaves: deal_*.
// One tile a cycle; latency 1.
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
  output logic             idle_o,         // no tile waits

  output logic             pixels_valid_o,
  input  logic             pixels_ready_i,
  output logic             miss_o,         // its pixels meet nothing
  output started_t         out_o,

  output logic             fill_valid_o,
  input  logic             fill_ready_i,
  output logic [7:0]       fill_slot_o,

  output logic             deal_valid_o,   // out_o goes to a lane
  output lane_no_t         deal_lane_o,

  input  logic [Lanes-1:0] left_i
);
  localparam int unsigned Low  = 16;
  localparam int unsigned CntW = $clog2(Low + (1 << (2 * TileLog2)) + 1);

  // ---- Empty tiles, and those that wait ----
  typedef struct packed {
    started_t        tile;
    logic [CntW-1:0] rays;
  } waiting_t;
  logic     fill, queue_ready, queue_valid, leave;
  waiting_t entered, head;
  started_t tile;
  assign entered = '{tile: in_i, rays: CntW'(in_i.tile.width) * CntW'(in_i.tile.height)};
  assign tile    = head.tile;
  assign fill         = in_i.start == TileEmpty && !direct_i && !each_miss_i;
  assign fill_valid_o = in_valid_i && fill;
  assign fill_slot_o  = in_i.tile.slot;
  assign in_ready_o   = fill ? fill_ready_i : queue_ready;
  assign idle_o       = !queue_valid;
  stream_fifo #(.data_t(waiting_t), .Depth(DealTiles)) u_queue (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(in_valid_i && !fill), .ready_o(queue_ready), .data_i(entered),
    .valid_o(queue_valid), .ready_i(leave), .data_o(head)
  );

  // ---- Room ----
  logic [CntW-1:0]  held_q [Lanes];
  logic [Lanes-1:0] room, chosen;
  lane_no_t         next_q, lane;
  logic             any, empty, deal;
  for (genvar i = 0; i < Lanes; i++) begin : g_lane
    assign room[i]   = held_q[i] <= CntW'(Low);
    assign chosen[i] = lane == lane_no_t'(i);
    always_ff @(posedge clk_i) begin
      if (!rst_ni) held_q[i] <= '0;
      else if (left_i[i] || (deal && chosen[i]))
        held_q[i] <= held_q[i] + ((deal && chosen[i]) ? head.rays : '0) - CntW'(left_i[i]);
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
  logic to_lane;
  assign empty          = tile.start == TileEmpty && !direct_i;
  assign to_lane        = !empty && !direct_i;
  assign pixels_valid_o = queue_valid && (!to_lane || any);
  assign leave          = pixels_valid_o && pixels_ready_i;
  assign miss_o         = empty;
  assign out_o          = tile;
  assign deal           = leave && to_lane;
  assign deal_valid_o   = deal;
  assign deal_lane_o    = lane;
  always_ff @(posedge clk_i) begin
    if (!rst_ni) next_q <= '0;
    else if (deal) next_q <= (lane == lane_no_t'(Lanes - 1)) ? '0 : lane + 1'b1;
  end
endmodule
