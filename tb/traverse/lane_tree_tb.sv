// SPDX-License-Identifier: Apache-2.0
// A lane that only follows the hierarchy, with a hit unit of its own.
module lane_tree_tb
  import castray_cfg_pkg::*, castray_pkg::*, castray_image_pkg::*;
#(
  parameter int unsigned Contexts  = DefaultContexts,
  parameter int unsigned NodeLines = DefaultCacheLines,
  parameter int unsigned LeafLines = DefaultCacheLines,
  parameter int unsigned TileNodes = tile_nodes(tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2)),
  localparam int unsigned TileW    = $clog2(TileNodes)
) (
  input  logic         clk_i,
  input  logic         rst_ni,
  input  tree_t        tree_i,

  input  logic         in_valid_i,
  output logic         in_ready_o,
  input  ray_t         in_i,
  input  start_t       start_i,

  input  logic         tile_write_i,
  input  logic [TileW-1:0] tile_index_i,
  input  node_t        tile_node_i,

  output logic         out_valid_o,
  input  logic         out_ready_i,
  output hit_t         out_o,
  output work_t        work_o,
  output error_t       fault_o,

  output logic         node_req_valid_o,
  input  logic         node_req_ready_i,
  output line_req_t    node_req_o,
  input  logic         node_fill_valid_i,
  output logic         node_fill_ready_o,
  input  line_fill_t   node_fill_i,
  output logic         leaf_req_valid_o,
  input  logic         leaf_req_ready_i,
  output line_req_t    leaf_req_o,
  input  logic         leaf_fill_valid_i,
  output logic         leaf_fill_ready_o,
  input  line_fill_t   leaf_fill_i,

  output logic         empty_o,
  output lane_events_t events_o
);
  logic     cand_valid, cand_ready, hit_over, result_valid;
  cand_t    cand [1];
  hit_ray_t cand_ray [1];
  result_t  result;
  shared_hits #(.Lanes(1)) u_hits (
    .clk_i, .rst_ni,
    .cand_valid_i(cand_valid), .cand_ready_o(cand_ready), .cand_i(cand), .ray_i(cand_ray),
    .over_o(hit_over), .result_valid_o(result_valid), .result_o(result), .busy_o()
  );

  line_fill_t node_fill;
  always_comb begin
    node_fill = node_fill_i;
    if (tile_write_i) node_fill.data = line_data_t'(tile_node_i);
  end
  lane #(.Contexts(Contexts), .NodeLines(NodeLines), .LeafLines(LeafLines), .TileNodes(TileNodes)) u_lane (
    .clk_i, .rst_ni, .hierarchy_i(1'b1), .tree_i, .fill_i(1'b1), .emit_i(1'b1),
    .ray_valid_i(in_valid_i), .ray_ready_o(in_ready_o), .ray_i(in_i), .start_i,
    .test_valid_i(1'b0), .test_ready_o(), .test_step_i(1'b0), .test_ctx_i('0), .test_prim_i('0),
    .tile_write_i, .tile_index_i,
    .cand_valid_o(cand_valid), .cand_ready_i(cand_ready), .cand_o(cand[0]), .cand_ray_o(cand_ray[0]),
    .hit_over_i(hit_over), .result_valid_i(result_valid), .result_i(result),
    .hit_valid_o(out_valid_o), .hit_ready_i(out_ready_i), .hit_o(out_o), .work_o, .fault_o,
    .node_req_valid_o, .node_req_ready_i, .node_req_o, .node_fill_valid_i, .node_fill_ready_o, .node_fill_i(node_fill),
    .leaf_req_valid_o, .leaf_req_ready_i, .leaf_req_o, .leaf_fill_valid_i, .leaf_fill_ready_o, .leaf_fill_i,
    .used_o(), .full_o(), .empty_o, .quiet_o(), .events_o
  );

`ifndef SYNTHESIS
  stream_check #(.data_t(hit_t)) u_check_hit (
    .clk_i, .rst_ni, .valid_i(out_valid_o), .ready_i(out_ready_i), .data_i(out_o)
  );
`endif
endmodule
