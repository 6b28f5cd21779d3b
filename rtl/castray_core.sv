// SPDX-License-Identifier: Apache-2.0
// castray: a scene image in memory, a picture and its hits out. Instances and wires only; the
// README's data-flow diagram as code.
//
//   job_control - job_loader - frame_setup
//   tile_walk -> ray_gen -> ray_setup -> ray_dispatch -> lane[Lanes] -> arb -+-> hit_writer
//   prim_reader -> brute_walk -------------------------> (all lanes)         |
//                        attr_cache -> shade ---+                            |
//                            ^                  arb -> tile_gather           |
//                            +--- background ---+---------------- found? <---+
//
// Control: AXI4-Lite, docs/register-map.md. Memory: one AXI4 port of 128 bits.
// The scene image: docs/scene-image.md. Model: cpp_model/core.cpp, equal bit for bit.
module castray_core
  import castray_cfg_pkg::*;
  import castray_pkg::*;
  import castray_image_pkg::*;
  import castray_reg_pkg::*;
#(
  parameter int unsigned Lanes       = 3,    // 1 to 8
  parameter int unsigned Contexts    = 32,   // rays in flight in each lane, 1 to 64
  parameter int unsigned TileLog2    = 3,    // tiles of 4x4, 8x8 or 16x16 pixels: 2, 3 or 4
  parameter int unsigned AttrEntries = 128   // places of the attribute cache
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

  // AXI4 memory
  output logic                m_axi_arvalid_o,
  input  logic                m_axi_arready_i,
  output addr_t               m_axi_araddr_o,
  output logic [3:0]          m_axi_arid_o,
  output logic [7:0]          m_axi_arlen_o,
  output logic [2:0]          m_axi_arsize_o,
  output logic [1:0]          m_axi_arburst_o,
  output logic [3:0]          m_axi_arcache_o,
  output logic [2:0]          m_axi_arprot_o,
  input  logic                m_axi_rvalid_i,
  output logic                m_axi_rready_o,
  input  beat_t               m_axi_rdata_i,
  input  logic [3:0]          m_axi_rid_i,
  input  logic [1:0]          m_axi_rresp_i,
  input  logic                m_axi_rlast_i,
  output logic                m_axi_awvalid_o,
  input  logic                m_axi_awready_i,
  output addr_t               m_axi_awaddr_o,
  output logic [3:0]          m_axi_awid_o,
  output logic [7:0]          m_axi_awlen_o,
  output logic [2:0]          m_axi_awsize_o,
  output logic [1:0]          m_axi_awburst_o,
  output logic [3:0]          m_axi_awcache_o,
  output logic [2:0]          m_axi_awprot_o,
  output logic                m_axi_wvalid_o,
  input  logic                m_axi_wready_i,
  output beat_t               m_axi_wdata_o,
  output logic [StrbW-1:0]    m_axi_wstrb_o,
  output logic                m_axi_wlast_o,
  input  logic                m_axi_bvalid_i,
  output logic                m_axi_bready_o,
  input  logic [3:0]          m_axi_bid_i,
  input  logic [1:0]          m_axi_bresp_i
);
  if (Lanes < 1 || Lanes > 8) begin : g_lanes
    $error("castray_core: Lanes must be 1 to 8");
  end
  if (TileLog2 < 2 || TileLog2 > 4) begin : g_tile
    $error("castray_core: TileLog2 must be 2, 3 or 4");
  end

  // Tiles in flight: those of all contexts, and some to walk ahead and to write behind.
  localparam int unsigned TilePixels = 1 << (2 * TileLog2);
  localparam int unsigned Slots      = (Lanes * Contexts + TilePixels - 1) / TilePixels + 4;

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
  paint_t        paint;

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
  read_rsp_t               rsp;
  logic [WriteClients-1:0] write_valid, write_ready;
  write_req_t              write_req [WriteClients];
  logic                    read_beat, write_beat;

  axi_reader u_axi_reader (
    .clk_i, .rst_ni,
    .req_valid_i(read_valid), .req_ready_o(read_ready), .req_i(read_req),
    .rsp_valid_o(rsp_valid), .rsp_o(rsp),
    .block_i(block), .idle_o(read_idle), .error_o(read_error), .beat_o(read_beat),
    .m_axi_arvalid_o, .m_axi_arready_i, .m_axi_araddr_o, .m_axi_arid_o, .m_axi_arlen_o,
    .m_axi_arsize_o, .m_axi_arburst_o, .m_axi_arcache_o, .m_axi_arprot_o,
    .m_axi_rvalid_i, .m_axi_rready_o, .m_axi_rdata_i, .m_axi_rid_i, .m_axi_rresp_i, .m_axi_rlast_i
  );

  axi_writer u_axi_writer (
    .clk_i, .rst_ni,
    .req_valid_i(write_valid), .req_ready_o(write_ready), .req_i(write_req),
    .block_i(block), .idle_o(write_idle), .error_o(write_error), .beat_o(write_beat),
    .m_axi_awvalid_o, .m_axi_awready_i, .m_axi_awaddr_o, .m_axi_awid_o, .m_axi_awlen_o,
    .m_axi_awsize_o, .m_axi_awburst_o, .m_axi_awcache_o, .m_axi_awprot_o,
    .m_axi_wvalid_o, .m_axi_wready_i, .m_axi_wdata_o, .m_axi_wstrb_o, .m_axi_wlast_o,
    .m_axi_bvalid_i, .m_axi_bready_o, .m_axi_bid_i, .m_axi_bresp_i
  );

  job_loader u_job_loader (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(load_start), .job_i(job), .done_o(load_done), .error_o(load_error),
    .header_o(header), .record_o(record),
    .req_valid_o(read_valid[ReadJob]), .req_ready_i(read_ready[ReadJob]),
    .req_o(read_req[ReadJob]),
    .rsp_valid_i(rsp_valid[ReadJob]), .rsp_i(rsp)
  );

  // ---- Camera ----
  logic       tile_valid, tile_ready, px_valid, px_ready, dir_valid, dir_ready, ray_valid, ray_ready;
  tile_t      tile;
  pixel_tag_t px;
  pixel_dir_t dir;
  ray_t       ray;

  frame_setup u_frame_setup (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(setup_start), .record_i(record), .done_o(setup_done), .camera_o(camera)
  );

  tile_walk #(.TileLog2(TileLog2), .Slots(Slots)) u_tile_walk (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(walk_start), .job_i(job), .done_o(walk_done),
    .tile_valid_o(tile_valid), .tile_ready_i(tile_ready), .tile_o(tile),
    .out_valid_o(px_valid), .out_ready_i(px_ready), .out_o(px)
  );

  ray_gen u_ray_gen (
    .clk_i, .rst_ni(datapath_rst_n), .camera_i(camera),
    .in_valid_i(px_valid), .in_ready_o(px_ready), .in_i(px),
    .out_valid_o(dir_valid), .out_ready_i(dir_ready), .out_o(dir)
  );

  ray_setup u_ray_setup (
    .clk_i, .rst_ni(datapath_rst_n), .camera_i(camera),
    .in_valid_i(dir_valid), .in_ready_o(dir_ready), .in_i(dir),
    .out_valid_o(ray_valid), .out_ready_i(ray_ready), .out_o(ray)
  );

  // ---- Lanes ----
  logic             exhausted, starved, none_in_setup, fill, emit;
  logic [Lanes-1:0] lane_ray_valid, lane_ray_ready, full, quiet, lane_empty;
  logic [Lanes-1:0] lane_hit_valid, lane_hit_ready, test_ready, test_event, cand_event;
  logic [Lanes-1:0] lane_hit_found;
  logic [CtxW:0]    used [Lanes];
  hit_t             lane_hit [Lanes];
  logic             slot_valid, slot_ready, reader_start, reader_done, brute_idle;
  prim_slot_t       slot, test_prim;
  logic             test_valid, test_step;
  ctx_t             test_ctx;
  logic             batch_event, test_stall, fetch_stall;

  ray_dispatch #(.Lanes(Lanes)) u_ray_dispatch (
    .clk_i, .rst_ni(datapath_rst_n),
    .restart_i(emit), .issued_i(px_valid && px_ready), .walk_done_i(walk_done),
    .none_in_setup_o(none_in_setup), .exhausted_o(exhausted),
    .in_valid_i(ray_valid), .in_ready_o(ray_ready),
    .out_valid_o(lane_ray_valid), .out_ready_i(lane_ray_ready)
  );

  prim_reader u_prim_reader (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(reader_start), .base_i(job.image + addr_t'(header.lines.offset)),
    .lines_i(header.lines.count), .primitives_i(header.primitives),
    .done_o(reader_done), .fault_o(fault),
    .req_valid_o(read_valid[ReadPrimitive]), .req_ready_i(read_ready[ReadPrimitive]),
    .req_o(read_req[ReadPrimitive]),
    .rsp_valid_i(rsp_valid[ReadPrimitive]), .rsp_i(rsp),
    .out_valid_o(slot_valid), .out_ready_i(slot_ready), .out_o(slot)
  );

  brute_walk #(.Lanes(Lanes)) u_brute_walk (
    .clk_i, .rst_ni(datapath_rst_n),
    .exhausted_i(exhausted), .starved_i(starved),
    .used_i(used[0]), .full_i(full), .quiet_i(quiet), .empty_i(lane_empty),
    .fill_o(fill), .emit_o(emit),
    .reader_start_o(reader_start), .reader_done_i(reader_done),
    .prim_valid_i(slot_valid), .prim_ready_o(slot_ready), .prim_i(slot),
    .test_valid_o(test_valid), .test_ready_i(test_ready),
    .test_ctx_o(test_ctx), .test_prim_o(test_prim),
    .idle_o(brute_idle), .batch_o(batch_event), .test_stall_o(test_stall),
    .fetch_stall_o(fetch_stall)
  );
  assign test_step = &test_ready;

  for (genvar i = 0; i < Lanes; i++) begin : g_lane
    lane #(.Contexts(Contexts)) u_lane (
      .clk_i, .rst_ni(datapath_rst_n), .fill_i(fill),
      .ray_valid_i(lane_ray_valid[i]), .ray_ready_o(lane_ray_ready[i]), .ray_i(ray),
      .test_valid_i(test_valid), .test_ready_o(test_ready[i]), .test_step_i(test_step),
      .test_ctx_i(test_ctx), .test_prim_i(test_prim),
      .emit_i(emit),
      .hit_valid_o(lane_hit_valid[i]), .hit_ready_i(lane_hit_ready[i]), .hit_o(lane_hit[i]),
      .used_o(used[i]), .full_o(full[i]), .empty_o(lane_empty[i]), .quiet_o(quiet[i]),
      .test_o(test_event[i]), .cand_o(cand_event[i])
    );
    assign lane_hit_found[i] = lane_hit[i].found;
  end

  // ---- Hits: to the hit buffer when asked, and to the shader or past it ----
  logic       merged_valid, merged_ready, hit_valid, hit_ready, record_valid, record_ready;
  logic       colour_valid, colour_ready, found_valid, found_ready, miss_valid, miss_ready;
  hit_t       merged;
  hit_t       hit;

  stream_arb #(.data_t(hit_t), .N(Lanes)) u_merge (
    .clk_i, .rst_ni(datapath_rst_n),
    .valid_i(lane_hit_valid), .ready_o(lane_hit_ready), .data_i(lane_hit),
    .valid_o(merged_valid), .ready_i(merged_ready), .data_o(merged), .index_o()
  );

  pipe_cut #(.data_t(hit_t)) u_merged (
    .clk_i, .rst_ni(datapath_rst_n),
    .valid_i(merged_valid), .ready_o(merged_ready), .data_i(merged),
    .valid_o(hit_valid), .ready_i(hit_ready), .data_o(hit)
  );

  stream_fork #(.N(2)) u_fork (
    .clk_i, .rst_ni(datapath_rst_n),
    .valid_i(hit_valid), .ready_o(hit_ready),
    .valid_o({record_valid, colour_valid}), .ready_i({record_ready, colour_ready})
  );

  // Without a hit buffer every record is dropped here.
  logic writer_ready, writer_take, records_idle;
  assign record_ready = !job.want_hits || writer_ready;
  assign writer_take  = record_valid && job.want_hits && writer_ready;

  hit_writer u_hit_writer (
    .clk_i, .rst_ni(datapath_rst_n), .base_i(job.hits), .width_i(job.width),
    .in_valid_i(record_valid && job.want_hits), .in_ready_o(writer_ready), .in_i(hit),
    .out_valid_o(write_valid[WriteHit]), .out_ready_i(write_ready[WriteHit]),
    .out_o(write_req[WriteHit])
  );

  credit #(.Limit(15)) u_in_records (
    .clk_i, .rst_ni(datapath_rst_n),
    .take_i(writer_take), .give_i(write_valid[WriteHit] && write_ready[WriteHit]),
    .available_o(), .idle_o(records_idle)
  );

  // ---- Shading ----
  logic       shade_valid, shade_ready, done_valid, done_ready;
  logic       lit_valid, lit_ready, back_valid, back_ready, attr_hit, attr_miss;
  shade_req_t shade_req;
  shaded_t    lit, back;
  shaded_t    shaded;
  logic       shade_idle, gather_idle;

  assign found_valid  = colour_valid && hit.found;
  assign miss_valid   = colour_valid && !hit.found;
  assign colour_ready = hit.found ? found_ready : miss_ready;

  frame_paint u_frame_paint (.record_i(record), .paint_o(paint));

  attr_cache #(.Entries(AttrEntries)) u_attr_cache (
    .clk_i, .rst_ni(datapath_rst_n), .base_i(job.image + addr_t'(header.attributes.offset)),
    .in_valid_i(found_valid), .in_ready_o(found_ready), .in_i(hit),
    .out_valid_o(shade_valid), .out_ready_i(shade_ready), .out_o(shade_req),
    .req_valid_o(read_valid[ReadAttribute]), .req_ready_i(read_ready[ReadAttribute]),
    .req_o(read_req[ReadAttribute]),
    .rsp_valid_i(rsp_valid[ReadAttribute]), .rsp_i(rsp),
    .hit_o(attr_hit), .miss_o(attr_miss)
  );

  shade u_shade (
    .clk_i, .rst_ni(datapath_rst_n), .eye_i(camera.eye), .paint_i(paint),
    .in_valid_i(shade_valid), .in_ready_o(shade_ready), .in_i(shade_req),
    .out_valid_o(lit_valid), .out_ready_i(lit_ready), .out_o(lit)
  );

  background u_background (
    .clk_i, .rst_ni(datapath_rst_n), .paint_i(paint),
    .in_valid_i(miss_valid), .in_ready_o(miss_ready), .in_i(hit),
    .out_valid_o(back_valid), .out_ready_i(back_ready), .out_o(back)
  );

  stream_arb #(.data_t(shaded_t), .N(2)) u_colours (
    .clk_i, .rst_ni(datapath_rst_n),
    .valid_i({lit_valid, back_valid}), .ready_o({lit_ready, back_ready}), .data_i('{back, lit}),
    .valid_o(done_valid), .ready_i(done_ready), .data_o(shaded), .index_o()
  );

  tile_gather #(.TileLog2(TileLog2), .Slots(Slots)) u_tile_gather (
    .clk_i, .rst_ni(datapath_rst_n), .base_i(job.frame), .stride_i(record.stride),
    .tile_valid_i(tile_valid), .tile_ready_o(tile_ready), .tile_i(tile),
    .in_valid_i(done_valid), .in_ready_o(done_ready), .in_i(shaded),
    .out_valid_o(write_valid[WritePixel]), .out_ready_i(write_ready[WritePixel]),
    .out_o(write_req[WritePixel]),
    .idle_o(gather_idle)
  );

  // Hits between the lanes and the gather buffer.
  credit #(.Limit(1023)) u_in_shade (
    .clk_i, .rst_ni(datapath_rst_n),
    .take_i(merged_valid && merged_ready), .give_i(done_valid && done_ready),
    .available_o(), .idle_o(shade_idle)
  );
  assign starved = tile_valid && !tile_ready && none_in_setup && shade_idle;
  assign empty   = brute_idle && shade_idle && gather_idle && records_idle && !hit_valid;

  // ---- Counters ----
  counters #(.Lanes(Lanes)) u_counters (
    .clk_i, .rst_ni,
    .clear_i(start), .running_i(running),
    .test_i(test_event), .ray_i(lane_ray_valid & lane_ray_ready),
    .hit_i(lane_hit_found & lane_hit_valid & lane_hit_ready), .candidate_i(cand_event),
    .batch_i(batch_event), .test_stall_i(test_stall), .fetch_stall_i(fetch_stall),
    .attr_hit_i(attr_hit), .attr_miss_i(attr_miss),
    .read_beat_i(read_beat), .write_beat_i(write_beat),
    .counts_o(counts)
  );
endmodule
