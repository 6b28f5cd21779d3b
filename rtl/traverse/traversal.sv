// SPDX-License-Identifier: Apache-2.0
// From rays to hits: the lanes, the queues of rays before them, and what leads primitives past their
// contexts. Instances, and which lane each tile was dealt to.
//
//   hierarchy    in -> the queue of the lane that its tile was dealt to, or whose turn it is with a
//                list -> lane[Lanes] -> arb -> out
//   brute force  in -> ray_dispatch -> the lanes' queues -> lane[Lanes] -> arb -> out
//                prim_reader -> brute_walk -^ (all lanes)
//
// Hits leave in another order than their rays came; pixels that meet nothing (miss_*) join them. Of such
// a pixel's record tag, found and work are told, the rest is any; of a lane's ray that missed all is told.
// is_list_i, brute_i, tree_i, root_i, lines_i stand still from the first ray until idle.
// Model: cpp_model/traverse/lane.hpp, equal bit for bit.
module traversal
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
#(
  parameter int unsigned Lanes    = DefaultLanes,
  parameter int unsigned Contexts = DefaultContexts,
  parameter int unsigned TileLog2 = DefaultTileLog2,
  parameter int unsigned Slots    = tile_slots(DefaultLanes, DefaultContexts, DefaultTileLog2),
  parameter bit          GateClocks = 1'b0
) (
  input  logic                clk_i,
  input  logic                rst_ni,

  input  logic                is_list_i,      // rays of a list: all start at the root
  input  logic                brute_i,
  input  tree_t               tree_i,
  input  ref_t                root_i,
  input  addr_t               lines_i,        // where the primitives' lines begin
  output error_t              fault_o,

  input  logic                exhausted_i,    // no more rays come
  input  logic                starved_i,      // none come before hits have left
  output logic                idle_o,

  input  logic                deal_valid_i,   // which lane the rays of a tile go to, before they come
  input  lane_no_t            deal_lane_i,
  input  started_t            deal_i,
  output logic [Lanes-1:0]    left_o,         // a ray left its lane's queue

  input  logic                store_valid_i,  // a node of the frontier of the tile in a slot
  input  logic [7:0]          store_slot_i,
  input  logic                store_second_i,
  input  node_t               store_node_i,

  input  logic                in_valid_i,
  output logic                in_ready_o,
  input  ray_t                in_i,

  input  logic                miss_valid_i,
  output logic                miss_ready_o,
  input  pixel_tag_t          miss_i,

  output logic                out_valid_o,
  input  logic                out_ready_i,
  output cast_t               out_o,

  output logic                read_valid_o,   // primitives
  input  logic                read_ready_i,
  output read_req_t           read_o,
  input  logic                rsp_valid_i,
  input  read_rsp_t           rsp_i,

  output logic [2*Lanes-1:0]  line_valid_o,   // lines: nodes of lane i at 2 i, leaves at 2 i + 1
  input  logic [2*Lanes-1:0]  line_ready_i,
  output line_req_t           line_o [2*Lanes],
  input  logic [2*Lanes-1:0]  fill_valid_i,
  output logic [2*Lanes-1:0]  fill_ready_o,
  input  line_fill_t          fill_i,

  output lane_events_t        events_o [Lanes],   // counter events
  output logic [Lanes-1:0]    ray_o,
  output logic [Lanes-1:0]    hit_o,
  output logic [Lanes-1:0]    lane_starved_o,      // a lane has room for a ray, and none is there
  output logic [Lanes-1:0]    hit_wait_o,
  output logic                hit_busy_o,     // a test is at the hit unit
  output logic                batch_o,
  output logic                test_stall_o,
  output logic                fetch_stall_o
);
  // ---- Brute force: rays to lanes in turn, primitives past the lanes ----
  logic             fill, emit, dealt_ready, brute_idle, none_queued;
  logic [Lanes-1:0] dealt_valid, queue_ready, queue_empty, ray_valid, ray_ready, lane_empty, full, quiet, test_ready;
  logic [CtxW:0]    used [Lanes];
  logic             reader_start, reader_done, slot_valid, slot_ready, test_valid;
  prim_slot_t       slot, test_prim;
  ctx_t             test_ctx;
  error_t           reader_fault;

  ray_dispatch #(.Lanes(Lanes)) u_ray_dispatch (
    .clk_i, .rst_ni, .restart_i((exhausted_i || starved_i) && none_queued),
    .in_valid_i(in_valid_i && brute_i), .in_ready_o(dealt_ready),
    .out_valid_o(dealt_valid), .out_ready_i(queue_ready)
  );

  prim_reader u_prim_reader (
    .clk_i, .rst_ni,
    .start_i(reader_start), .base_i(lines_i), .lines_i(tree_i.leaf_count), .primitives_i(tree_i.primitives),
    .done_o(reader_done), .fault_o(reader_fault),
    .req_valid_o(read_valid_o), .req_ready_i(read_ready_i), .req_o(read_o), .rsp_valid_i, .rsp_i,
    .out_valid_o(slot_valid), .out_ready_i(slot_ready), .out_o(slot)
  );

  brute_walk #(.Lanes(Lanes)) u_brute_walk (
    .clk_i, .rst_ni,
    .exhausted_i(exhausted_i && none_queued), .starved_i(brute_i && starved_i && none_queued),
    .used_i(used[0]), .full_i(full & {Lanes{brute_i}}), .quiet_i(quiet),
    .empty_i(lane_empty | {Lanes{!brute_i}}),
    .fill_o(fill), .emit_o(emit),
    .reader_start_o(reader_start), .reader_done_i(reader_done),
    .prim_valid_i(slot_valid), .prim_ready_o(slot_ready), .prim_i(slot),
    .test_valid_o(test_valid), .test_ready_i(test_ready),
    .test_ctx_o(test_ctx), .test_prim_o(test_prim),
    .idle_o(brute_idle), .batch_o, .test_stall_o, .fetch_stall_o
  );

  // ---- Hierarchy: what was dealt, by the tile's slot, or a list's turn; a queue for each lane ----
  localparam int unsigned SlotW     = $clog2(Slots);
  localparam int unsigned TileNodes = tile_nodes(Slots);
  typedef struct packed {
    lane_no_t   lane;
    logic [1:0] start;
  } dealt_t;
  logic             tree_clk;
  dealt_t           dealt_q [1 << SlotW];
  logic [Lanes-1:0] to_lane;
  lane_no_t         in_lane, turn;

  clock_gate #(.Gated(GateClocks)) u_tree_clock (.clk_i, .awake_i(!brute_i || !rst_ni), .clk_o(tree_clk));
  always_ff @(posedge tree_clk) begin
    if (deal_valid_i) dealt_q[deal_i.tile.slot[SlotW-1:0]] <= '{lane: deal_lane_i, start: deal_i.start};
  end
  list_turn #(.Lanes(Lanes)) u_list_turn (
    .clk_i(tree_clk), .rst_ni, .taken_i(is_list_i && !brute_i && in_valid_i && in_ready_o), .lane_o(turn)
  );
  assign in_lane    = is_list_i ? turn : dealt_q[in_i.tag.slot[SlotW-1:0]].lane;
  assign in_ready_o = brute_i ? dealt_ready : |(queue_ready & to_lane);

  function automatic start_t start_of(logic [1:0] start, logic [SlotW-1:0] tile_slot, ref_t root);
    ref_t none;
    none = '{kind: RefNone, index: '0};
    unique case (start)
      TileRoot: return '{first: root, second: none};
      TileOne:  return '{first: '{kind: RefTile, index: line_t'({tile_slot, 1'b0})}, second: none};
      TileTwo:  return '{first: '{kind: RefTile, index: line_t'({tile_slot, 1'b0})},
                         second: '{kind: RefTile, index: line_t'({tile_slot, 1'b1})}};
      default:  return '{first: none, second: none};
    endcase
  endfunction

  // ---- Lanes ----
  logic [Lanes-1:0] hit_valid, hit_ready, found;
  cast_t            cast [Lanes];
  error_t           lane_fault [Lanes];
  logic [Lanes-1:0] cand_valid, cand_ready, hit_over, result_valid;
  cand_t            cand [Lanes];
  hit_ray_t         cand_ray [Lanes];
  result_t          result;

  shared_hits #(.Lanes(Lanes)) u_hits (
    .clk_i, .rst_ni,
    .cand_valid_i(cand_valid), .cand_ready_o(cand_ready), .cand_i(cand), .ray_i(cand_ray),
    .over_o(hit_over), .result_valid_o(result_valid), .result_o(result),
    .busy_o(hit_busy_o)
  );

  // Nodes of tiles' frontiers go to the lanes where lines from memory do.
  line_fill_t node_fill;
  always_comb begin
    node_fill = fill_i;
    if (store_valid_i) node_fill.data = line_data_t'(store_node_i);
  end

  for (genvar i = 0; i < Lanes; i++) begin : g_lane
    logic [SlotW-1:0] tile_slot;
    ray_t             ray;
    assign to_lane[i] = in_lane == lane_no_t'(i);
    assign tile_slot  = ray.tag.slot[SlotW-1:0];
    assign left_o[i]  = !brute_i && ray_valid[i] && ray_ready[i];

    block_fifo #(.data_t(ray_t), .Depth(ray_queue(TileLog2))) u_queue (
      .clk_i, .rst_ni,
      .valid_i(brute_i ? dealt_valid[i] : in_valid_i && to_lane[i]), .ready_o(queue_ready[i]), .data_i(in_i),
      .valid_o(ray_valid[i]), .ready_i(ray_ready[i]), .data_o(ray), .empty_o(queue_empty[i])
    );
    lane #(.Contexts(Contexts), .TileNodes(TileNodes), .GateClocks(GateClocks)) u_lane (
      .clk_i, .rst_ni, .hierarchy_i(!brute_i), .tree_i,
      .fill_i(fill || !brute_i), .ray_valid_i(ray_valid[i]), .ray_ready_o(ray_ready[i]), .ray_i(ray),
      .start_i(start_of(is_list_i ? TileRoot : dealt_q[tile_slot].start, tile_slot, root_i)),
      .test_valid_i(test_valid), .test_ready_o(test_ready[i]), .test_step_i(&test_ready),
      .test_ctx_i(test_ctx), .test_prim_i(test_prim),
      .tile_write_i(store_valid_i), .tile_index_i({store_slot_i[SlotW-1:0], store_second_i}),
      .cand_valid_o(cand_valid[i]), .cand_ready_i(cand_ready[i]), .cand_o(cand[i]), .cand_ray_o(cand_ray[i]),
      .hit_over_i(hit_over[i]), .result_valid_i(result_valid[i]), .result_i(result),
      .emit_i(emit || !brute_i),
      .hit_valid_o(hit_valid[i]), .hit_ready_i(hit_ready[i]), .hit_o(cast[i].hit), .work_o(cast[i].work),
      .fault_o(lane_fault[i]),
      .node_req_valid_o(line_valid_o[2*i]), .node_req_ready_i(line_ready_i[2*i]), .node_req_o(line_o[2*i]),
      .node_fill_valid_i(fill_valid_i[2*i]), .node_fill_ready_o(fill_ready_o[2*i]), .node_fill_i(node_fill),
      .leaf_req_valid_o(line_valid_o[2*i+1]), .leaf_req_ready_i(line_ready_i[2*i+1]), .leaf_req_o(line_o[2*i+1]),
      .leaf_fill_valid_i(fill_valid_i[2*i+1]), .leaf_fill_ready_o(fill_ready_o[2*i+1]), .leaf_fill_i(fill_i),
      .used_o(used[i]), .full_o(full[i]), .empty_o(lane_empty[i]), .quiet_o(quiet[i]),
      .events_o(events_o[i])
    );
    assign found[i] = cast[i].hit.found;
  end
  assign ray_o      = ray_valid & ray_ready;
  assign hit_o      = found & hit_valid & hit_ready;
  assign hit_wait_o = hit_valid & ~hit_ready;
  assign lane_starved_o = (rst_ni && !exhausted_i && (fill || !brute_i)) ? ~full & ~ray_valid : '0;
  assign none_queued = &queue_empty;
  assign idle_o      = brute_i ? brute_idle : (exhausted_i && &lane_empty && none_queued);

  // ---- Out: the lanes' hits, and the misses, which are a tag only ----
  logic       cast_valid, cast_ready, out_is_miss;
  cast_t      lanes_cast;
  pixel_tag_t out_tag;
  stream_arb #(.data_t(cast_t), .N(Lanes)) u_merge (
    .clk_i, .rst_ni,
    .valid_i(hit_valid), .ready_o(hit_ready), .data_i(cast),
    .valid_o(cast_valid), .ready_i(cast_ready), .data_o(lanes_cast), .index_o()
  );
  stream_arb #(.data_t(pixel_tag_t), .N(2)) u_out (
    .clk_i, .rst_ni,
    .valid_i({miss_valid_i, cast_valid}), .ready_o({miss_ready_o, cast_ready}), .data_i('{lanes_cast.hit.tag, miss_i}),
    .valid_o(out_valid_o), .ready_i(out_ready_i), .data_o(out_tag), .index_o(out_is_miss)
  );
  always_comb begin
    out_o         = lanes_cast;
    out_o.hit.tag = out_tag;
    if (out_is_miss) begin
      out_o.work      = '0;
      out_o.hit.found = 1'b0;
    end
  end

  always_comb begin
    fault_o = brute_i ? reader_fault : ErrNone;
    for (int unsigned i = 0; i < Lanes; i++) if (lane_fault[i] != ErrNone) fault_o = lane_fault[i];
  end
endmodule
