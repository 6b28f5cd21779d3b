// SPDX-License-Identifier: Apache-2.0
// The memory of the core: Ports AXI4 ports of 128 bits. Reads: on every port an axi_reader, whose
// clients are those of the read arbiter that live there and one that fetches lines for the caches.
// Writes: one axi_writer, on port 0; the others never write. Instances and wires only.
//   port 0        all clients but those of the last one, lines, writes
//   the last one  attributes, rays of a list, lines
module axi_ports
  import castray_cfg_pkg::*;
  import castray_pkg::*;
#(
  parameter int unsigned Ports     = DefaultPorts,
  parameter int unsigned MaxReads  = DefaultL2Misses + DefaultAttrMisses + DefaultRayBursts,   // bursts outstanding on each port
  parameter int unsigned MaxWrites = 48,  // of two beats: more than memory takes to answer
  parameter int unsigned MaxBeats  = 4    // of a write
) (
  input  logic                    clk_i,
  input  logic                    rst_ni,

  input  logic [ReadClients-1:0]  read_valid_i,
  output logic [ReadClients-1:0]  read_ready_o,
  input  read_req_t               read_i [ReadClients],
  output logic [ReadClients-1:0]  rsp_valid_o,
  output read_rsp_t               rsp_o [ReadClients],

  input  logic [Ports-1:0]        line_valid_i,
  output logic [Ports-1:0]        line_ready_o,
  input  read_req_t               line_i [Ports],
  output logic [Ports-1:0]        line_rsp_valid_o,
  output read_rsp_t               line_rsp_o [Ports],

  input  logic [WriteClients-1:0] write_valid_i,
  output logic [WriteClients-1:0] write_ready_o,
  input  write_req_t              write_i [WriteClients],

  input  logic                    block_i,         // no burst is taken any more
  output logic                    read_idle_o,     // nothing is outstanding
  output logic                    write_idle_o,
  output logic                    read_error_o,    // one cycle each
  output logic                    write_error_o,
  output logic [Ports-1:0]        read_beat_o,     // counter events
  output logic                    write_beat_o,

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
  if (Ports < 1 || Ports > 2) begin : g_check
    $error("axi_ports: Ports must be 1 or 2");
  end
  if (MaxReads < DefaultL2Misses + DefaultAttrMisses + DefaultRayBursts) begin : g_reads
    $error("axi_ports: MaxReads is less than what lines, attributes and rays ask for at once");
  end

  // A client's port.
  function automatic int unsigned port_of(int unsigned client);
    return (client == ReadAttribute || client == ReadRay) ? Ports - 1 : 0;
  endfunction

  // ---- Reads: the clients of the arbiter by number, then lines ----
  localparam int unsigned Clients = ReadClients + 1;
  logic [Ports-1:0][Clients-1:0] ready, rsp_valid;
  logic [Ports-1:0]              idle, error;
  read_rsp_t                     rsp [Ports];

  for (genvar p = 0; p < Ports; p++) begin : g_read
    logic [Clients-1:0] valid;
    read_req_t          req [Clients];
    for (genvar c = 0; c < ReadClients; c++) begin : g_client
      assign valid[c] = read_valid_i[c] && port_of(c) == p;
      assign req[c]   = read_i[c];
    end
    assign valid[ReadClients]  = line_valid_i[p];
    assign req[ReadClients]    = line_i[p];
    assign line_ready_o[p]     = ready[p][ReadClients];
    assign line_rsp_valid_o[p] = rsp_valid[p][ReadClients];
    assign line_rsp_o[p]       = rsp[p];

    axi_reader #(.Clients(Clients), .MaxReads(MaxReads)) u_axi_reader (
      .clk_i, .rst_ni,
      .req_valid_i(valid), .req_ready_o(ready[p]), .req_i(req),
      .rsp_valid_o(rsp_valid[p]), .rsp_o(rsp[p]),
      .block_i, .idle_o(idle[p]), .error_o(error[p]), .beat_o(read_beat_o[p]),
      .m_axi_arvalid_o(m_axi_arvalid_o[p]), .m_axi_arready_i(m_axi_arready_i[p]),
      .m_axi_araddr_o(m_axi_araddr_o[p]), .m_axi_arid_o(m_axi_arid_o[p]),
      .m_axi_arlen_o(m_axi_arlen_o[p]), .m_axi_arsize_o(m_axi_arsize_o[p]),
      .m_axi_arburst_o(m_axi_arburst_o[p]), .m_axi_arcache_o(m_axi_arcache_o[p]),
      .m_axi_arprot_o(m_axi_arprot_o[p]),
      .m_axi_rvalid_i(m_axi_rvalid_i[p]), .m_axi_rready_o(m_axi_rready_o[p]),
      .m_axi_rdata_i(m_axi_rdata_i[p]), .m_axi_rid_i(m_axi_rid_i[p]),
      .m_axi_rresp_i(m_axi_rresp_i[p]), .m_axi_rlast_i(m_axi_rlast_i[p])
    );
  end
  for (genvar c = 0; c < ReadClients; c++) begin : g_home
    assign read_ready_o[c] = ready[port_of(c)][c];
    assign rsp_valid_o[c]  = rsp_valid[port_of(c)][c];
    assign rsp_o[c]        = rsp[port_of(c)];
  end
  assign read_idle_o  = &idle;
  assign read_error_o = |error;

  // ---- Writes ----
  axi_writer #(.MaxWrites(MaxWrites), .MaxBeats(MaxBeats)) u_axi_writer (
    .clk_i, .rst_ni,
    .req_valid_i(write_valid_i), .req_ready_o(write_ready_o), .req_i(write_i),
    .block_i, .idle_o(write_idle_o), .error_o(write_error_o), .beat_o(write_beat_o),
    .m_axi_awvalid_o(m_axi_awvalid_o[0]), .m_axi_awready_i(m_axi_awready_i[0]),
    .m_axi_awaddr_o(m_axi_awaddr_o[0]), .m_axi_awid_o(m_axi_awid_o[0]),
    .m_axi_awlen_o(m_axi_awlen_o[0]), .m_axi_awsize_o(m_axi_awsize_o[0]),
    .m_axi_awburst_o(m_axi_awburst_o[0]), .m_axi_awcache_o(m_axi_awcache_o[0]),
    .m_axi_awprot_o(m_axi_awprot_o[0]),
    .m_axi_wvalid_o(m_axi_wvalid_o[0]), .m_axi_wready_i(m_axi_wready_i[0]),
    .m_axi_wdata_o(m_axi_wdata_o[0]), .m_axi_wstrb_o(m_axi_wstrb_o[0]),
    .m_axi_wlast_o(m_axi_wlast_o[0]),
    .m_axi_bvalid_i(m_axi_bvalid_i[0]), .m_axi_bready_o(m_axi_bready_o[0]),
    .m_axi_bid_i(m_axi_bid_i[0]), .m_axi_bresp_i(m_axi_bresp_i[0])
  );
  for (genvar p = 1; p < Ports; p++) begin : g_no_writes
    assign m_axi_awvalid_o[p] = 1'b0;
    assign m_axi_awaddr_o[p]  = '0;
    assign m_axi_awid_o[p]    = '0;
    assign m_axi_awlen_o[p]   = '0;
    assign m_axi_awsize_o[p]  = '0;
    assign m_axi_awburst_o[p] = '0;
    assign m_axi_awcache_o[p] = '0;
    assign m_axi_awprot_o[p]  = '0;
    assign m_axi_wvalid_o[p]  = 1'b0;
    assign m_axi_wdata_o[p]   = '0;
    assign m_axi_wstrb_o[p]   = '0;
    assign m_axi_wlast_o[p]   = 1'b0;
    assign m_axi_bready_o[p]  = 1'b1;
  end
endmodule
