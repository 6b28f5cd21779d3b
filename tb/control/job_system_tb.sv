// SPDX-License-Identifier: Apache-2.0
// The units around the datapath, wired as in castray_core, with a datapath of two state machines:
// one reads `height` bursts of 16 beats from the image on, the other writes `height` bursts of 64
// bytes to the frame, each with the number of the read beat that it waited for.
module job_system_tb
  import castray_pkg::*, castray_image_pkg::*, castray_reg_pkg::*;
(
  input  logic                clk_i,
  input  logic                rst_ni,

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
  output logic                interrupt_o,

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
  input  logic [1:0]          m_axi_bresp_i,

  output logic                lost_o    // a beat came that the datapath did not ask for
);
  logic   start, running, done, datapath_rst_n, block;
  logic   load_start, load_done, setup_start, walk_start, walk_done, empty;
  logic   read_idle, write_idle, read_error, write_error, read_beat, write_beat;
  job_t   job;
  error_t error, load_error;
  logic [63:0] count;
  logic [$clog2(Counters)-1:0] count_number;

  axi_lite_regs #(.Lanes(1), .Contexts(1), .TileLog2(3)) u_regs (
    .clk_i, .rst_ni,
    .s_axi_awvalid_i, .s_axi_awready_o, .s_axi_awaddr_i, .s_axi_wvalid_i, .s_axi_wready_o, .s_axi_wdata_i,
    .s_axi_wstrb_i, .s_axi_bvalid_o, .s_axi_bready_i, .s_axi_bresp_o, .s_axi_arvalid_i, .s_axi_arready_o,
    .s_axi_araddr_i, .s_axi_rvalid_o, .s_axi_rready_i, .s_axi_rdata_o, .s_axi_rresp_o, .interrupt_o,
    .start_o(start), .job_o(job), .done_i(done), .error_i(error), .number_i(count_number), .count_i(count)
  );

  job_control u_control (
    .clk_i, .rst_ni,
    .start_i(start), .job_i(job), .running_o(running), .done_o(done), .error_o(error),
    .datapath_rst_no(datapath_rst_n), .block_o(block),
    .load_start_o(load_start), .load_done_i(load_done), .load_error_i(load_error),
    .setup_start_o(setup_start), .setup_done_i(setup_done_q), .walk_start_o(walk_start),
    .walk_done_i(walk_done), .empty_i(empty),
    .read_idle_i(read_idle), .write_idle_i(write_idle), .read_error_i(read_error), .write_error_i(write_error),
    .fault_i(ErrNone)
  );
  logic setup_done_q;
  always_ff @(posedge clk_i) setup_done_q <= datapath_rst_n && (setup_done_q || setup_start);

  logic [EventBits-1:0] events [Counters];
  always_comb begin
    for (int unsigned i = 0; i < Counters; i++) events[i] = '0;
    events[CntCycles][0]     = running;
    events[CntReadBeats][0]  = read_beat;
    events[CntWriteBeats][0] = write_beat;
  end
  counters u_counters (
    .clk_i, .rst_ni, .clear_i(start), .events_i(events), .number_o(count_number), .count_o(count)
  );

  logic [1:0] read_valid, read_ready, rsp_valid;
  read_req_t  read_req [2];
  read_rsp_t  rsp;
  axi_reader #(.Clients(2), .MaxReads(6)) u_reader (
    .clk_i, .rst_ni,
    .req_valid_i(read_valid), .req_ready_o(read_ready), .req_i(read_req),
    .rsp_valid_o(rsp_valid), .rsp_o(rsp),
    .block_i(block), .idle_o(read_idle), .error_o(read_error), .beat_o(read_beat),
    .m_axi_arvalid_o, .m_axi_arready_i, .m_axi_araddr_o, .m_axi_arid_o, .m_axi_arlen_o, .m_axi_arsize_o,
    .m_axi_arburst_o, .m_axi_arcache_o, .m_axi_arprot_o,
    .m_axi_rvalid_i, .m_axi_rready_o, .m_axi_rdata_i, .m_axi_rid_i, .m_axi_rresp_i, .m_axi_rlast_i
  );

  logic [0:0] write_valid, write_ready;
  write_req_t write_req [1];
  axi_writer #(.Clients(1), .MaxWrites(6)) u_writer (
    .clk_i, .rst_ni,
    .req_valid_i(write_valid), .req_ready_o(write_ready), .req_i(write_req),
    .block_i(block), .idle_o(write_idle), .error_o(write_error), .beat_o(write_beat),
    .m_axi_awvalid_o, .m_axi_awready_i, .m_axi_awaddr_o, .m_axi_awid_o, .m_axi_awlen_o, .m_axi_awsize_o,
    .m_axi_awburst_o, .m_axi_awcache_o, .m_axi_awprot_o,
    .m_axi_wvalid_o, .m_axi_wready_i, .m_axi_wdata_o, .m_axi_wstrb_o, .m_axi_wlast_o,
    .m_axi_bvalid_i, .m_axi_bready_o, .m_axi_bid_i, .m_axi_bresp_i
  );

  image_header_t header;
  frame_record_t record;
  job_loader u_loader (
    .clk_i, .rst_ni(datapath_rst_n),
    .start_i(load_start), .job_i(job), .done_o(load_done), .error_o(load_error),
    .header_o(header), .record_o(record),
    .req_valid_o(read_valid[0]), .req_ready_i(read_ready[0]), .req_o(read_req[0]),
    .rsp_valid_i(rsp_valid[0]), .rsp_i(rsp)
  );
  logic unused_records;
  assign unused_records = ^{header, record};

  // ---- The datapath ----
  logic [12:0] asked_q, written_q;
  logic [16:0] beats_q;
  logic        busy_q;
  assign read_valid[1]  = busy_q && asked_q != job.height;
  assign read_req[1]    = '{addr: job.image + (addr_t'(asked_q) << 8), beats: 5'd16};
  assign write_valid[0] = busy_q && written_q != job.height && 13'(beats_q >> 4) > written_q;
  assign write_req[0]   = '{addr: job.frame + (addr_t'(written_q) << 6), beats: 3'd4, strb: '1, data: {16{32'(written_q)}}};
  assign walk_done      = busy_q && asked_q == job.height;
  assign empty          = written_q == job.height;

  always_ff @(posedge clk_i) begin
    if (!datapath_rst_n) begin
      asked_q   <= '0;
      written_q <= '0;
      beats_q   <= '0;
      busy_q    <= 1'b0;
    end else begin
      if (walk_start) busy_q <= 1'b1;
      if (read_valid[1] && read_ready[1]) asked_q <= asked_q + 1'b1;
      if (write_valid[0] && write_ready[0]) written_q <= written_q + 1'b1;
      if (rsp_valid[1]) beats_q <= beats_q + 1'b1;
    end
  end
  // Sticky: a beat without a request, or data of another burst than the next one.
  always_ff @(posedge clk_i) begin
    if (!rst_ni) lost_o <= 1'b0;
    else if (datapath_rst_n && rsp_valid[1] && (beats_q >= {asked_q, 4'd0} || rsp.data[16:0] != beats_q)) lost_o <= 1'b1;
  end
endmodule
