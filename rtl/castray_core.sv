// SPDX-License-Identifier: Apache-2.0
// castray: a scene image in memory, a picture and its hits out. Instances and wires only; the
// README's data-flow diagram as code.
//
//   job_control - job_loader - frame_setup
//   ray_source -> traversal -> shading -> frame and hit buffers
//
// Control: AXI4-Lite, docs/register-map.md. Memory: one AXI4 port of 128 bits.
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
  parameter int unsigned Ports       = DefaultPorts
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
  if (Lanes < 1 || Lanes > 8) begin : g_lanes
    $error("castray_core: Lanes must be 1 to 8");
  end
  if (TileLog2 < 2 || TileLog2 > 4) begin : g_tile
    $error("castray_core: TileLog2 must be 2, 3 or 4");
  end

  localparam int unsigned Slots = tile_slots(Lanes, Contexts, TileLog2);

  // ---- Control ----
  logic          start, running, done, datapath_rst_n, block;
  job_t          job;
  error_t        job_error, load_error, fault;
  logic [63:0]   counts [Counters];
  logic          load_start, load_done, setup_start, setup_done, walk_start, walk_done, empty;
  logic          read_idle, write_idle, read_error, write_error;
  image_header_t header;
  frame_record_t record;
  camera_t       camera;

  axi_lite_regs #(.Lanes(Lanes), .Contexts(Contexts), .TileLog2(TileLog2)) u_regs (
    .clk_i, .rst_ni,
    .s_axi_awvalid_i, .s_axi_awready_o, .s_axi_awaddr_i,
    .s_axi_wvalid_i, .s_axi_wready_o, .s_axi_wdata_i, .s_axi_wstrb_i,
    .s_axi_bvalid_o, .s_axi_bready_i, .s_axi_bresp_o,
    .s_axi_arvalid_i, .s_axi_arready_o, .s_axi_araddr_i,
    .s_axi_rvalid_o, .s_axi_rready_i, .s_axi_rdata_o, .s_axi_rresp_o,
    .interrupt_o(irq_o),
    .start_o(start), .job_o(job), .done_i(done), .error_i(job_error), .counts_i(counts)
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
  logic [Ports-1:0]        read_beat;
  logic [WriteClients-1:0] write_valid, write_ready;
  write_req_t              write_req [WriteClients];
  logic                    write_beat;

  axi_ports #(.Ports(Ports)) u_axi_ports (
    .clk_i, .rst_ni,
    .read_valid_i(read_valid), .read_ready_o(read_ready), .read_i(read_req),
    .rsp_valid_o(rsp_valid), .rsp_o(rsp),
    .line_valid_i('0), .line_ready_o(), .line_i('{default: '0}),
    .line_rsp_valid_o(), .line_rsp_o(),
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

  job_loader u_job_loader (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(load_start), .job_i(job), .done_o(load_done), .error_o(load_error),
    .header_o(header), .record_o(record),
    .req_valid_o(read_valid[ReadJob]), .req_ready_i(read_ready[ReadJob]),
    .req_o(read_req[ReadJob]),
    .rsp_valid_i(rsp_valid[ReadJob]), .rsp_i(rsp[ReadJob])
  );

  // ---- Camera ----
  logic  tile_valid, tile_ready, none_in_setup, exhausted, ray_valid, ray_ready;
  tile_t tile;
  ray_t  ray;

  frame_setup u_frame_setup (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(setup_start), .record_i(record), .done_o(setup_done), .camera_o(camera)
  );

  ray_source #(.TileLog2(TileLog2), .Slots(Slots)) u_ray_source (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(walk_start), .job_i(job), .camera_i(camera),
    .walk_done_o(walk_done), .none_in_setup_o(none_in_setup), .exhausted_o(exhausted),
    .tile_valid_o(tile_valid), .tile_ready_i(tile_ready), .tile_o(tile),
    .out_valid_o(ray_valid), .out_ready_i(ray_ready), .out_o(ray)
  );

  // ---- Hits ----
  logic [Lanes-1:0] test_event, ray_event, hit_event, cand_event;
  logic             batch_event, test_stall, fetch_stall, attr_hit, attr_miss;
  logic             hit_valid, hit_ready, traversal_idle, coloured, shading_idle;
  hit_t             hit;

  traversal #(.Lanes(Lanes), .Contexts(Contexts)) u_traversal (
    .clk_i, .rst_ni(datapath_rst_n),
    .lines_i(job.image + addr_t'(header.lines.offset)), .line_count_i(header.lines.count),
    .primitives_i(header.primitives), .fault_o(fault),
    .exhausted_i(exhausted), .starved_i(tile_valid && !tile_ready && none_in_setup && coloured),
    .idle_o(traversal_idle),
    .in_valid_i(ray_valid), .in_ready_o(ray_ready), .in_i(ray),
    .out_valid_o(hit_valid), .out_ready_i(hit_ready), .out_o(hit),
    .read_valid_o(read_valid[ReadPrimitive]), .read_ready_i(read_ready[ReadPrimitive]),
    .read_o(read_req[ReadPrimitive]), .rsp_valid_i(rsp_valid[ReadPrimitive]), .rsp_i(rsp[ReadPrimitive]),
    .test_o(test_event), .ray_o(ray_event), .hit_o(hit_event), .cand_o(cand_event),
    .batch_o(batch_event), .test_stall_o(test_stall), .fetch_stall_o(fetch_stall)
  );

  shading #(.TileLog2(TileLog2), .Slots(Slots), .AttrEntries(AttrEntries)) u_shading (
    .clk_i, .rst_ni(datapath_rst_n),
    .job_i(job), .record_i(record), .eye_i(camera.eye),
    .attributes_i(job.image + addr_t'(header.attributes.offset)),
    .tile_valid_i(tile_valid), .tile_ready_o(tile_ready), .tile_i(tile),
    .in_valid_i(hit_valid), .in_ready_o(hit_ready), .in_i(hit),
    .read_valid_o(read_valid[ReadAttribute]), .read_ready_i(read_ready[ReadAttribute]),
    .read_o(read_req[ReadAttribute]), .rsp_valid_i(rsp_valid[ReadAttribute]), .rsp_i(rsp[ReadAttribute]),
    .pixel_valid_o(write_valid[WritePixel]), .pixel_ready_i(write_ready[WritePixel]),
    .pixel_o(write_req[WritePixel]),
    .record_valid_o(write_valid[WriteHit]), .record_ready_i(write_ready[WriteHit]),
    .record_o(write_req[WriteHit]),
    .coloured_o(coloured), .idle_o(shading_idle), .attr_hit_o(attr_hit), .attr_miss_o(attr_miss)
  );
  assign empty = traversal_idle && shading_idle;

  // ---- Counters ----
  logic [EventBits-1:0] events [Counters];
  assign events[CntCycles]      = EventBits'(running);
  assign events[CntTests]       = EventBits'(test_event);
  assign events[CntRays]        = EventBits'(ray_event);
  assign events[CntHits]        = EventBits'(hit_event);
  assign events[CntCandidates]  = EventBits'(cand_event);
  assign events[CntBatches]     = EventBits'(batch_event);
  assign events[CntTestStalls]  = EventBits'(test_stall);
  assign events[CntFetchStalls] = EventBits'(fetch_stall);
  assign events[CntAttrHits]    = EventBits'(attr_hit);
  assign events[CntAttrMisses]  = EventBits'(attr_miss);
  assign events[CntReadBeats]   = EventBits'(read_beat);
  assign events[CntWriteBeats]  = EventBits'(write_beat);

  counters u_counters (.clk_i, .rst_ni, .clear_i(start), .events_i(events), .counts_o(counts));
endmodule
