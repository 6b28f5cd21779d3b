// SPDX-License-Identifier: Apache-2.0
// One traversal of the hierarchy for all rays of a tile: where they start. Instances and wires, and
// the four corners of a tile.
//   tile -> its corner pixels -> (the camera) -> rays -> tile_bounds -> frontier -> tile_node -> tile
//                                                                    <-> line_fetch <-> memory
// A frontier is written as one node or two at store_*, before its tile is offered. With direct_i,
// which stands still, tiles pass as they come and start at the root.
// In order; Tiles tiles at once. Corner rays share the camera's pipe with the rays of tiles that have
// left: so a tile enters only when frontier has a place for it, and its corners are always taken.
// Model: cpp_model/traverse/tile_start.hpp, equal bit for bit.
module tile_start
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Tiles = StartTiles,          // a power of two
  parameter int unsigned Lines = DefaultStartLines    // of the cache of nodes
) (
  input  logic       clk_i,
  input  logic       rst_ni,

  input  logic       direct_i,      // these stand still
  input  point_t     eye_i,
  input  ref_t       root_i,
  input  line_no_t   nodes_i,       // where the nodes begin
  input  logic [31:0] node_count_i,
  output error_t     fault_o,

  input  logic       in_valid_i,
  output logic       in_ready_o,
  input  tile_t      in_i,

  output logic       corner_valid_o,
  input  logic       corner_ready_i,
  output pixel_tag_t corner_o,
  input  logic       ray_valid_i,   // of the corners, in their order
  output logic       ray_ready_o,
  input  ray_t       ray_i,

  output logic       out_valid_o,
  input  logic       out_ready_i,
  output started_t   out_o,
  output logic       idle_o,        // no tile is here

  output logic       store_valid_o, // a node of the tile in slot store_slot_o
  output logic [7:0] store_slot_o,
  output logic       store_second_o,
  output node_t      store_node_o,

  output logic       req_valid_o,
  input  logic       req_ready_i,
  output line_req_t  req_o,
  input  logic       fill_valid_i,
  output logic       fill_ready_o,
  input  line_fill_t fill_i,

  output logic       node_o,        // counter events
  output logic       busy_o,        // a node is split
  output logic       hit_o,
  output logic       miss_o
);
  // ---- In: a tile waits for its start; meanwhile its corners go to the camera ----
  logic  wait_valid, wait_ready, head_valid, head_ready, corner_busy, corner_last;
  tile_t head;
  assign in_ready_o = wait_ready && (direct_i || !corner_busy || corner_last);
  assign wait_valid = in_valid_i && (direct_i || !corner_busy || corner_last);
  stream_fifo #(.data_t(tile_t), .Depth(Tiles)) u_tiles (
    .clk_i, .rst_ni, .used_o(),
    .valid_i(wait_valid), .ready_o(wait_ready), .data_i(in_i),
    .valid_o(head_valid), .ready_i(head_ready), .data_o(head)
  );

  tile_t      tile_q;
  logic [1:0] corner_q;     // 1: right, 2: bottom
  logic       busy_q;
  assign corner_busy    = busy_q;
  assign corner_last    = corner_q == 2'd3 && corner_ready_i;
  assign corner_valid_o = busy_q;
  assign corner_o = '{
    slot: tile_q.slot,
    x: corner_q[0] ? tile_q.x + pixel_t'(tile_q.width) - 1'b1 : tile_q.x,
    y: corner_q[1] ? tile_q.y + pixel_t'(tile_q.height) - 1'b1 : tile_q.y
  };
  always_ff @(posedge clk_i) begin
    if (!rst_ni) begin
      busy_q   <= 1'b0;
      corner_q <= '0;
    end else begin
      if (in_valid_i && in_ready_o) busy_q <= !direct_i;
      else if (corner_last) busy_q <= 1'b0;
      if (busy_q && corner_ready_i) corner_q <= corner_q + 1'b1;
    end
  end
  always_ff @(posedge clk_i) begin
    if (in_valid_i && in_ready_o) tile_q <= in_i;
  end

  // ---- Bounds, frontier ----
  logic         formed_valid, formed_ready, bounds_valid, bounds_ready, ask_valid, node_valid, node_ready, parts_valid, parts_ready, at_root;
  tile_bounds_t formed, bounds;
  ctx_t         ask_tile, node_tile;
  line_t        ask_index;
  line_data_t   node;
  logic [3:0]   parts;
  logic [2:0]   part_at;
  part_t        part;
  logic         part_read;
  error_t       frontier_fault, fetch_fault;

  tile_bounds u_bounds (
    .clk_i, .rst_ni, .in_valid_i(ray_valid_i), .in_ready_o(ray_ready_o), .in_i(ray_i),
    .out_valid_o(formed_valid), .out_ready_i(formed_ready), .out_o(formed)
  );
  pipe_cut #(.data_t(tile_bounds_t)) u_formed (   // the frontier's decision does not reach the camera's pipes
    .clk_i, .rst_ni,
    .valid_i(formed_valid), .ready_o(formed_ready), .data_i(formed),
    .valid_o(bounds_valid), .ready_i(bounds_ready), .data_o(bounds)
  );
  frontier #(.Tiles(Tiles)) u_frontier (
    .clk_i, .rst_ni, .eye_i, .root_i, .fault_o(frontier_fault),
    .in_valid_i(bounds_valid), .in_ready_o(bounds_ready), .in_i(bounds),
    .ask_valid_o(ask_valid), .ask_tile_o(ask_tile), .ask_index_o(ask_index),
    .node_valid_i(node_valid), .node_ready_o(node_ready), .node_tile_i(node_tile), .node_i(node_t'(node)),
    .out_valid_o(parts_valid), .out_ready_i(parts_ready), .out_root_o(at_root), .out_parts_o(parts),
    .part_i(part_at), .part_read_o(part_read), .part_o(part), .read_o(node_o)
  );
  assign busy_o = node_valid;
  line_fetch #(.Contexts(Tiles), .Lines(Lines)) u_fetch (
    .clk_i, .rst_ni, .base_i(nodes_i), .count_i(node_count_i),
    .visit_valid_i({1'b0, ask_valid}), .visit_ctx_i('{ask_tile, '0}),
    .visit_ref_i('{'{kind: RefNode, index: ask_index}, '0}),
    .keep_i(1'b0), .keep_index_i('0),
    .out_valid_o(node_valid), .out_ready_i(node_ready), .out_ctx_o(node_tile), .out_kept_o(), .out_index_o(),
    .out_data_o(node),
    .fault_o(fetch_fault),
    .req_valid_o, .req_ready_i, .req_o, .fill_valid_i, .fill_ready_o, .fill_i,
    .hit_o, .miss_o, .wait_o()
  );
  assign fault_o = (frontier_fault != ErrNone) ? frontier_fault : fetch_fault;

  // ---- Out: the frontier's nodes, then the tile ----
  logic       some, write, written, written_q;
  logic [1:0] start;
  assign some  = !at_root && parts != '0;
  assign write = parts_valid && some && !written_q;
  tile_node u_node (
    .clk_i, .rst_ni, .start_i(write), .parts_i(parts), .done_o(written),
    .part_o(part_at), .part_read_i(part_read), .part_i(part),
    .write_o(store_valid_o), .second_o(store_second_o), .node_o(store_node_o)
  );
  always_ff @(posedge clk_i) begin
    if (!rst_ni || parts_ready) written_q <= 1'b0;
    else if (write && written) written_q <= 1'b1;
  end
  assign start        = (direct_i || at_root) ? TileRoot : (parts == '0) ? TileEmpty : (parts <= 4'd4) ? TileOne : TileTwo;
  assign store_slot_o = head.slot;
  assign out_valid_o  = head_valid && (direct_i || (parts_valid && (!some || written_q)));
  assign out_o        = '{tile: head, start: start};
  assign idle_o       = !head_valid;
  assign head_ready   = out_valid_o && out_ready_i;
  assign parts_ready  = head_ready && !direct_i;
endmodule
