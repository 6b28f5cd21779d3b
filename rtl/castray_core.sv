// SPDX-License-Identifier: Apache-2.0
// castray: a scene image in memory, a picture and its hits out, or the hits of a list of rays.
// Instances and wires only; the README's data-flow diagram as code.
//
//   job_control - job_loader - frame_setup
//   ray_reader (a list) -> ray_source -> traversal -> shading -> frame and hit buffers
//
// Control: AXI4-Lite, docs/register-map.md. Memory: one or two AXI4 ports of 128 bits (axi_ports),
// behind caches of lines (line_memory, docs/memory.md).
// The scene image: docs/scene-image.md. Model: cpp_model/core.cpp, equal bit for bit.
module castray_core
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
  import castray_reg_pkg::*;
#(
  parameter int unsigned Lanes       = DefaultLanes,
  parameter int unsigned Contexts    = DefaultContexts,
  parameter int unsigned TileLog2    = DefaultTileLog2,
  parameter int unsigned AttrEntries = DefaultAttrEntries,
  parameter int unsigned Ports       = DefaultPorts,
  parameter int unsigned L2Kbytes    = DefaultL2Kbytes,
  parameter bit          GateClocks  = 1'b0   // of units at rest: simulations are faster, nothing else changes
) (
  input  logic                clk_i,
  input  logic                rst_ni,
  output logic                irq_o,

  // AXI4-Lite control
  input  logic                s_axi_awvalid_i,
  output logic                s_axi_awready_o,
  input  logic [RegAddrW-1:0] s_axi_awaddr_i,
  input  logic                s_axi_wvalid_i,
  output logic                s_axi_wready_o,
  input  logic [31:0]         s_axi_wdata_i,
  input  logic [3:0]          s_axi_wstrb_i,
  output logic                s_axi_bvalid_o,
  input  logic                s_axi_bready_i,
  output logic [1:0]          s_axi_bresp_o,
  input  logic                s_axi_arvalid_i,
  output logic                s_axi_arready_o,
  input  logic [RegAddrW-1:0] s_axi_araddr_i,
  output logic                s_axi_rvalid_o,
  input  logic                s_axi_rready_i,
  output logic [31:0]         s_axi_rdata_o,
  output logic [1:0]          s_axi_rresp_o,

  // AXI4 memory: of each port its part of a signal, port 0's the lowest
  output logic [Ports-1:0]            m_axi_arvalid_o,
  input  logic [Ports-1:0]            m_axi_arready_i,
  output logic [Ports-1:0][AddrW-1:0] m_axi_araddr_o,
  output logic [Ports-1:0][3:0]       m_axi_arid_o,
  output logic [Ports-1:0][7:0]       m_axi_arlen_o,
  output logic [Ports-1:0][2:0]       m_axi_arsize_o,
  output logic [Ports-1:0][1:0]       m_axi_arburst_o,
  output logic [Ports-1:0][3:0]       m_axi_arcache_o,
  output logic [Ports-1:0][2:0]       m_axi_arprot_o,
  input  logic [Ports-1:0]            m_axi_rvalid_i,
  output logic [Ports-1:0]            m_axi_rready_o,
  input  logic [Ports-1:0][DataW-1:0] m_axi_rdata_i,
  input  logic [Ports-1:0][3:0]       m_axi_rid_i,
  input  logic [Ports-1:0][1:0]       m_axi_rresp_i,
  input  logic [Ports-1:0]            m_axi_rlast_i,
  output logic [Ports-1:0]            m_axi_awvalid_o,
  input  logic [Ports-1:0]            m_axi_awready_i,
  output logic [Ports-1:0][AddrW-1:0] m_axi_awaddr_o,
  output logic [Ports-1:0][3:0]       m_axi_awid_o,
  output logic [Ports-1:0][7:0]       m_axi_awlen_o,
  output logic [Ports-1:0][2:0]       m_axi_awsize_o,
  output logic [Ports-1:0][1:0]       m_axi_awburst_o,
  output logic [Ports-1:0][3:0]       m_axi_awcache_o,
  output logic [Ports-1:0][2:0]       m_axi_awprot_o,
  output logic [Ports-1:0]            m_axi_wvalid_o,
  input  logic [Ports-1:0]            m_axi_wready_i,
  output logic [Ports-1:0][DataW-1:0] m_axi_wdata_o,
  output logic [Ports-1:0][StrbW-1:0] m_axi_wstrb_o,
  output logic [Ports-1:0]            m_axi_wlast_o,
  input  logic [Ports-1:0]            m_axi_bvalid_i,
  output logic [Ports-1:0]            m_axi_bready_o,
  input  logic [Ports-1:0][3:0]       m_axi_bid_i,
  input  logic [Ports-1:0][1:0]       m_axi_bresp_i
);
  if (Lanes < 1 || Lanes > MaxLanes) begin : g_lanes
    $error("castray_core: Lanes is %0d, it must be 1 to %0d", Lanes, MaxLanes);
  end
  if (Contexts < 1 || Contexts > 2 ** CtxW) begin : g_contexts
    $error("castray_core: Contexts is %0d, it must be 1 to %0d", Contexts, 2 ** CtxW);
  end
  if (TileLog2 < 2 || TileLog2 > 4) begin : g_tile
    $error("castray_core: TileLog2 is %0d, it must be 2, 3 or 4", TileLog2);
  end
  if (AttrEntries < 4 || 2 ** $clog2(AttrEntries) != AttrEntries) begin : g_attributes
    $error("castray_core: AttrEntries is %0d, it must be a power of two, at least 4", AttrEntries);
  end
  if (Ports < 1 || Ports > 2) begin : g_ports
    $error("castray_core: Ports is %0d, it must be 1 or 2", Ports);
  end
  if (L2Kbytes != 0 && 2 ** $clog2(L2Kbytes) != L2Kbytes) begin : g_l2
    $error("castray_core: L2Kbytes is %0d, it must be 0 or a power of two", L2Kbytes);
  end

  localparam int unsigned Slots = tile_slots(Lanes, Contexts, TileLog2);

  // ---- Control ----
  logic          start, running, done, datapath_rst_n, block;
  job_t          job;
  error_t        job_error, load_error, fault;
  logic [63:0]   count;
  logic [$clog2(Counters)-1:0] count_number;   // whose it is
  logic          load_start, load_done, setup_start, setup_done, walk_start, walk_done, empty;
  logic          read_idle, write_idle, read_error, write_error;
  image_header_t header;
  frame_record_t record;
  camera_t       camera;
  logic          tree_clk, camera_clk, shading_clk;   // clk_i, or gated

  axi_lite_regs #(.Lanes(Lanes), .Contexts(Contexts), .TileLog2(TileLog2)) u_regs (
    .clk_i, .rst_ni,
    .s_axi_awvalid_i, .s_axi_awready_o, .s_axi_awaddr_i,
    .s_axi_wvalid_i, .s_axi_wready_o, .s_axi_wdata_i, .s_axi_wstrb_i,
    .s_axi_bvalid_o, .s_axi_bready_i, .s_axi_bresp_o,
    .s_axi_arvalid_i, .s_axi_arready_o, .s_axi_araddr_i,
    .s_axi_rvalid_o, .s_axi_rready_i, .s_axi_rdata_o, .s_axi_rresp_o,
    .interrupt_o(irq_o),
    .start_o(start), .job_o(job), .done_i(done), .error_i(job_error), .number_i(count_number), .count_i(count)
  );

  job_control u_job_control (
    .clk_i, .rst_ni,
    .start_i(start), .job_i(job), .running_o(running), .done_o(done), .error_o(job_error),
    .datapath_rst_no(datapath_rst_n), .block_o(block),
    .load_start_o(load_start), .load_done_i(load_done), .load_error_i(load_error),
    .setup_start_o(setup_start), .setup_done_i(setup_done),
    .walk_start_o(walk_start), .walk_done_i(walk_done), .empty_i(empty),
    .read_idle_i(read_idle), .write_idle_i(write_idle),
    .read_error_i(read_error), .write_error_i(write_error), .fault_i(fault)
  );

  // ---- Memory ----
  logic [ReadClients-1:0]  read_valid, read_ready, rsp_valid;
  read_req_t               read_req [ReadClients];
  read_rsp_t               rsp [ReadClients];
  logic [Ports-1:0]        line_valid, line_ready, line_rsp_valid, read_beat, l2_hit, l2_miss;
  read_req_t               line_read [Ports];
  read_rsp_t               line_rsp [Ports];
  logic [WriteClients-1:0] write_valid, write_ready, write_wait;
  write_req_t              write_req [WriteClients];
  logic                    write_beat;
  assign write_wait = write_valid & ~write_ready;

  // What is written at once: a row of a tile, or a hit record.
  localparam int unsigned RowBytes   = PixelBytes << TileLog2;
  localparam int unsigned WriteBytes = (RowBytes > HitBytes) ? RowBytes : HitBytes;

  axi_ports #(.Ports(Ports), .MaxBeats(WriteBytes / StrbW)) u_axi_ports (
    .clk_i, .rst_ni,
    .read_valid_i(read_valid), .read_ready_o(read_ready), .read_i(read_req),
    .rsp_valid_o(rsp_valid), .rsp_o(rsp),
    .line_valid_i(line_valid), .line_ready_o(line_ready), .line_i(line_read),
    .line_rsp_valid_o(line_rsp_valid), .line_rsp_o(line_rsp),
    .write_valid_i(write_valid), .write_ready_o(write_ready), .write_i(write_req),
    .block_i(block), .read_idle_o(read_idle), .write_idle_o(write_idle),
    .read_error_o(read_error), .write_error_o(write_error),
    .read_beat_o(read_beat), .write_beat_o(write_beat),
    .m_axi_arvalid_o, .m_axi_arready_i, .m_axi_araddr_o, .m_axi_arid_o, .m_axi_arlen_o,
    .m_axi_arsize_o, .m_axi_arburst_o, .m_axi_arcache_o, .m_axi_arprot_o, .m_axi_rvalid_i,
    .m_axi_rready_o, .m_axi_rdata_i, .m_axi_rid_i, .m_axi_rresp_i, .m_axi_rlast_i, .m_axi_awvalid_o,
    .m_axi_awready_i, .m_axi_awaddr_o, .m_axi_awid_o, .m_axi_awlen_o, .m_axi_awsize_o,
    .m_axi_awburst_o, .m_axi_awcache_o, .m_axi_awprot_o, .m_axi_wvalid_o, .m_axi_wready_i,
    .m_axi_wdata_o, .m_axi_wstrb_o, .m_axi_wlast_o, .m_axi_bvalid_i, .m_axi_bready_o, .m_axi_bid_i,
    .m_axi_bresp_i
  );

  // The caches of the lanes and, last, that of ray_source.
  localparam int unsigned Caches = 2 * Lanes + 1;
  logic [Caches-1:0] cache_valid, cache_ready, fill_valid, fill_ready;
  line_req_t         cache_req [Caches];
  line_fill_t        fill;

  line_memory #(.Clients(Caches), .Ports(Ports), .L2Lines(L2Kbytes * 1024 / LineBytes)) u_line_memory (
    .clk_i(tree_clk), .rst_ni(datapath_rst_n), .base_i(job.image), .hit_o(l2_hit), .miss_o(l2_miss),
    .req_valid_i(cache_valid), .req_ready_o(cache_ready), .req_i(cache_req),
    .fill_valid_o(fill_valid), .fill_ready_i(fill_ready), .fill_o(fill),
    .read_valid_o(line_valid), .read_ready_i(line_ready), .read_o(line_read),
    .rsp_valid_i(line_rsp_valid), .rsp_i(line_rsp)
  );

  job_loader u_job_loader (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(load_start), .job_i(job), .done_o(load_done), .error_o(load_error),
    .header_o(header), .record_o(record),
    .req_valid_o(read_valid[ReadJob]), .req_ready_i(read_ready[ReadJob]),
    .req_o(read_req[ReadJob]),
    .rsp_valid_i(rsp_valid[ReadJob]), .rsp_i(rsp[ReadJob])
  );

  logic     list_valid, list_ready, list_done;
  ray_req_t list_ray;
  error_t   list_fault;

  ray_reader u_ray_reader (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(walk_start && job.is_list), .base_i(job.rays), .count_i(job.ray_count),
    .done_o(list_done), .fault_o(list_fault),
    .req_valid_o(read_valid[ReadRay]), .req_ready_i(read_ready[ReadRay]), .req_o(read_req[ReadRay]),
    .rsp_valid_i(rsp_valid[ReadRay]), .rsp_i(rsp[ReadRay]),
    .out_valid_o(list_valid), .out_ready_i(list_ready), .out_o(list_ray)
  );

  // ---- Camera ----
  logic         tile_valid, tile_ready, none_in_setup, exhausted, ray_valid, ray_ready, miss_valid, miss_ready;
  logic         back_valid, back_ready, deal_valid, store_valid, store_second;
  logic         tile_node, tile_busy, tile_hit, tile_miss;
  logic [7:0]   back_slot, store_slot, tile_slot;
  tile_t        tile;
  ray_t         ray;
  pixel_tag_t   miss;
  started_t     deal;
  lane_no_t     deal_lane;
  node_t        store_node;
  ref_t         root;
  tree_t        tree;
  error_t       source_fault, lane_fault;
  logic [Lanes-1:0] left;

  assign root = ref_t'(header.root);
  assign tree = '{
    limit: job.steps, primitives: header.primitives,
    leaf_count: header.lines.count, leaf_base: line_no_t'(header.lines.offset / LineBytes),
    node_count: header.nodes.count, node_base: line_no_t'(header.nodes.offset / LineBytes)
  };

  frame_setup u_frame_setup (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(setup_start), .record_i(record), .done_o(setup_done), .camera_o(camera)
  );

  ray_source #(.Lanes(Lanes), .TileLog2(TileLog2), .Slots(Slots)) u_ray_source (
    .clk_i(camera_clk), .rst_ni(datapath_rst_n),
    .start_i(walk_start && !job.is_list), .job_i(job), .camera_i(camera), .root_i(root),
    .nodes_i(tree.node_base), .node_count_i(tree.node_count), .fault_o(source_fault),
    .walk_done_o(walk_done), .none_in_setup_o(none_in_setup), .exhausted_o(exhausted),
    .list_valid_i(list_valid), .list_ready_o(list_ready), .list_i(list_ray), .list_done_i(list_done),
    .tile_valid_o(tile_valid), .tile_ready_i(tile_ready), .tile_o(tile), .tile_slot_i(tile_slot),
    .out_valid_o(ray_valid), .out_ready_i(ray_ready), .out_o(ray),
    .miss_valid_o(miss_valid), .miss_ready_i(miss_ready), .miss_o(miss),
    .fill_valid_o(back_valid), .fill_ready_i(back_ready), .fill_slot_o(back_slot),
    .deal_valid_o(deal_valid), .deal_lane_o(deal_lane), .deal_o(deal), .left_i(left),
    .store_valid_o(store_valid), .store_slot_o(store_slot), .store_second_o(store_second),
    .store_node_o(store_node),
    .req_valid_o(cache_valid[Caches-1]), .req_ready_i(cache_ready[Caches-1]), .req_o(cache_req[Caches-1]),
    .fill_line_valid_i(fill_valid[Caches-1]), .fill_line_ready_o(fill_ready[Caches-1]), .fill_line_i(fill),
    .node_o(tile_node), .node_busy_o(tile_busy), .node_hit_o(tile_hit), .node_miss_o(tile_miss)
  );

  // ---- Hits ----
  logic [Lanes-1:0] ray_event, hit_event, starved, hit_wait;
  lane_events_t     lane_events [Lanes];
  logic             batch_event, test_stall, fetch_stall, attr_hit, attr_miss, hit_busy, shader_busy;
  logic             hit_valid, hit_ready, traversal_idle, coloured, shading_idle;
  cast_t            cast;

  traversal #(   // Contexts of 0 would stop a tool before it says what is wrong
    .Lanes(Lanes), .Contexts((Contexts > 0) ? Contexts : 1), .TileLog2(TileLog2), .Slots(Slots), .GateClocks(GateClocks)
  ) u_traversal (
    .clk_i, .rst_ni(datapath_rst_n),
    .is_list_i(job.is_list), .brute_i(job.brute), .tree_i(tree), .root_i(root),
    .lines_i(job.image + addr_t'(header.lines.offset)), .fault_o(lane_fault),
    .exhausted_i(exhausted), .starved_i(tile_valid && !tile_ready && none_in_setup && coloured),
    .idle_o(traversal_idle),
    .deal_valid_i(deal_valid), .deal_lane_i(deal_lane), .deal_i(deal), .left_o(left),
    .store_valid_i(store_valid), .store_slot_i(store_slot), .store_second_i(store_second),
    .store_node_i(store_node),
    .in_valid_i(ray_valid), .in_ready_o(ray_ready), .in_i(ray),
    .miss_valid_i(miss_valid), .miss_ready_o(miss_ready), .miss_i(miss),
    .out_valid_o(hit_valid), .out_ready_i(hit_ready), .out_o(cast),
    .read_valid_o(read_valid[ReadPrimitive]), .read_ready_i(read_ready[ReadPrimitive]),
    .read_o(read_req[ReadPrimitive]), .rsp_valid_i(rsp_valid[ReadPrimitive]), .rsp_i(rsp[ReadPrimitive]),
    .line_valid_o(cache_valid[2*Lanes-1:0]), .line_ready_i(cache_ready[2*Lanes-1:0]),
    .line_o(cache_req[0:2*Lanes-1]),
    .fill_valid_i(fill_valid[2*Lanes-1:0]), .fill_ready_o(fill_ready[2*Lanes-1:0]), .fill_i(fill),
    .events_o(lane_events), .ray_o(ray_event), .hit_o(hit_event),
    .lane_starved_o(starved), .hit_wait_o(hit_wait), .hit_busy_o(hit_busy),
    .batch_o(batch_event), .test_stall_o(test_stall), .fetch_stall_o(fetch_stall)
  );
  assign fault = (list_fault != ErrNone) ? list_fault : (source_fault != ErrNone) ? source_fault : lane_fault;

  shading #(.TileLog2(TileLog2), .Slots(Slots), .AttrEntries(AttrEntries)) u_shading (
    .clk_i(shading_clk), .rst_ni(datapath_rst_n),
    .job_i(job), .record_i(record), .eye_i(camera.eye),
    .attributes_i(job.image + addr_t'(header.attributes.offset)),
    .tile_valid_i(tile_valid), .tile_ready_o(tile_ready), .tile_i(tile), .tile_slot_o(tile_slot),
    .fill_valid_i(back_valid), .fill_ready_o(back_ready), .fill_slot_i(back_slot),
    .in_valid_i(hit_valid), .in_ready_o(hit_ready), .in_i(cast),
    .read_valid_o(read_valid[ReadAttribute]), .read_ready_i(read_ready[ReadAttribute]),
    .read_o(read_req[ReadAttribute]), .rsp_valid_i(rsp_valid[ReadAttribute]), .rsp_i(rsp[ReadAttribute]),
    .pixel_valid_o(write_valid[WritePixel]), .pixel_ready_i(write_ready[WritePixel]),
    .pixel_o(write_req[WritePixel]),
    .record_valid_o(write_valid[WriteHit]), .record_ready_i(write_ready[WriteHit]),
    .record_o(write_req[WriteHit]),
    .coloured_o(coloured), .idle_o(shading_idle), .attr_hit_o(attr_hit), .attr_miss_o(attr_miss),
    .shader_busy_o(shader_busy)
  );
  assign empty = traversal_idle && shading_idle;

  // ---- Clocks of what rests by brute force: what passes the border of ray_source, and of shading ----
  clock_wake #(.GateClocks(GateClocks)) u_clock_wake (
    .clk_i, .rst_ni(datapath_rst_n), .brute_i(job.brute),
    .camera_valid_i({walk_start, tile_valid, list_valid, ray_valid, miss_valid, back_valid, deal_valid}),
    .camera_ready_i({1'b1, tile_ready, list_ready, ray_ready, miss_ready, back_ready, 1'b1}),
    .shading_valid_i({tile_valid, hit_valid, back_valid, read_valid[ReadAttribute], rsp_valid[ReadAttribute], write_valid}),
    .shading_ready_i({tile_ready, hit_ready, back_ready, read_ready[ReadAttribute], 1'b1, write_ready}),
    .tree_clk_o(tree_clk), .camera_clk_o(camera_clk), .shading_clk_o(shading_clk)
  );

  // ---- Counters ----
  lane_sums_t           sums;
  logic [EventBits-1:0] events [Counters];
  lane_sums #(.Lanes(Lanes)) u_lane_sums (.events_i(lane_events), .sums_o(sums));
  assign events[CntCycles]      = EventBits'(running);
  assign events[CntTests]       = sums.test;
  assign events[CntRays]        = EventBits'(ray_event);
  assign events[CntHits]        = EventBits'(hit_event);
  assign events[CntCandidates]  = sums.cand;
  assign events[CntBatches]     = EventBits'(batch_event);
  assign events[CntTestStalls]  = EventBits'(test_stall);
  assign events[CntFetchStalls] = EventBits'(fetch_stall);
  assign events[CntAttrHits]    = EventBits'(attr_hit);
  assign events[CntAttrMisses]  = EventBits'(attr_miss);
  assign events[CntReadBeats]   = EventBits'(read_beat);
  assign events[CntWriteBeats]  = EventBits'(write_beat);
  assign events[CntNodes]       = sums.node;
  assign events[CntNodeHits]    = sums.node_hit;
  assign events[CntNodeMisses]  = sums.node_miss;
  assign events[CntLeafHits]    = sums.leaf_hit;
  assign events[CntLeafMisses]  = sums.leaf_miss;
  assign events[CntNodeWaits]   = sums.node_wait;
  assign events[CntLeafWaits]   = sums.leaf_wait;
  assign events[CntTestWaits]   = sums.test_wait;
  assign events[CntL2Hits]      = EventBits'(l2_hit);
  assign events[CntL2Misses]    = EventBits'(l2_miss);
  assign events[CntTileNodes]   = EventBits'(tile_node);
  assign events[CntTileHits]    = EventBits'(tile_hit);
  assign events[CntTileMisses]  = EventBits'(tile_miss);
  assign events[CntEmptyTiles]  = EventBits'(back_valid && back_ready);
  assign events[CntHitUnitBusy] = EventBits'(hit_busy);
  assign events[CntShaderBusy]  = EventBits'(shader_busy);
  assign events[CntTileBusy]    = EventBits'(tile_busy);
  assign events[CntStarved]     = EventBits'(starved);
  assign events[CntHitWaits]    = EventBits'(hit_wait);
  assign events[CntWriteWaits]  = EventBits'(write_wait);

  counters u_counters (.clk_i, .rst_ni, .clear_i(start), .events_i(events), .number_o(count_number), .count_o(count));
endmodule
